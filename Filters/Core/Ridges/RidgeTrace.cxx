// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/RidgeTrace.h"

#include "Mesh/PositionOrder.h"
#include "Monge/AcuteRule.h"
#include "Umbilics/UmbilicForm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ridges
{
namespace
{

/// By position, then by kind, then by edge or triangle or, of turning points, by value: -1, 0 or 1.
int Compare(const TriangleMesh& mesh, const RidgeVertex& a, const RidgeVertex& b)
{
  for (int i = 0; i < 3; ++i)
  {
    const double x = a.point.position[i];
    const double y = b.point.position[i];
    if (x != y)
    {
      return x < y ? -1 : 1;
    }
  }
  const auto kindOf = [](const RidgeVertex& vertex)
  { return vertex.edge != RidgeVertex::None ? 0 : (vertex.umbilic != RidgeVertex::None ? 1 : 2); };
  if (kindOf(a) != kindOf(b))
  {
    return kindOf(a) < kindOf(b) ? -1 : 1;
  }
  if (a.edge != b.edge)
  {
    const OrderedEdge x(mesh, a.edge);
    const OrderedEdge y(mesh, b.edge);
    for (const auto& [p, q] : { std::pair(x.p, y.p), std::pair(x.q, y.q) })
    {
      if (PointComesBefore(mesh, p, q) || PointComesBefore(mesh, q, p))
      {
        return PointComesBefore(mesh, p, q) ? -1 : 1;
      }
    }
  }
  if (a.umbilic != b.umbilic)
  {
    return ComesBefore(mesh, a.umbilic, b.umbilic)
      ? -1
      : (ComesBefore(mesh, b.umbilic, a.umbilic) ? 1 : 0);
  }
  const auto valuesOf = [](const RidgePoint& point) {
    return std::array<double, 3>{ point.curvature, point.gap, point.P };
  };
  const auto x = valuesOf(a.point);
  const auto y = valuesOf(b.point);
  return x < y ? -1 : (y < x ? 1 : 0);
}

/// From that of the two which comes first: not even round-off depends on the direction.
RidgeVertex TurningPointBetween(
  const TriangleMesh& mesh, const RidgeVertex& before, const RidgeVertex& after)
{
  const bool swaps = Compare(mesh, after, before) < 0;
  const RidgePoint& a = (swaps ? after : before).point;
  const RidgePoint& b = (swaps ? before : after).point;
  const double t = CrossingParameter(a.P, b.P);
  const auto between = [t](double atA, double atB) { return (1.0 - t) * atA + t * atB; };
  RidgeVertex vertex;
  vertex.point.parameter = 0.0;
  vertex.point.position = (1.0 - t) * a.position + t * b.position;
  vertex.point.curvature = between(a.curvature, b.curvature);
  vertex.point.gap = between(a.gap, b.gap);
  vertex.point.P = 0.0;
  vertex.point.crestMargin = between(a.crestMargin, b.crestMargin);
  vertex.point.color = a.color;
  return vertex;
}

/// Puts the vertices of a ridge one after another.
class Tracer
{
public:
  Tracer(const std::vector<RidgeSegment>& segments, const std::vector<RidgePath>& paths,
    const RidgeCrossings& crossings, TypeRule rule, const UmbilicLookup& umbilics)
    : Segments_(segments)
    , Paths_(paths)
    , Crossings_(crossings)
    , ByFourthOrder_(rule == TypeRule::FourthOrder)
    , Umbilics_(umbilics)
  {
  }

  RidgeTrace Trace(const Ridge& ridge) const
  {
    const std::vector<bool> inPatch = this->FindPiecesInPatches(ridge);
    RidgeTrace trace;
    trace.closed = ridge.closed;
    // With some turning points.
    trace.vertices.reserve(2 * ridge.nodes.size());
    trace.types.reserve(2 * ridge.nodes.size());
    trace.vertices.push_back(this->VertexAt(ridge, 0, 1));
    for (std::size_t i = 0; i < ridge.segments.size(); ++i)
    {
      const RidgeVertex next = this->VertexAt(ridge, i + 1, i);
      const RidgeSegment& segment = this->Segments_[ridge.segments[i]];
      if (segment.path != RidgeSegment::NoPath)
      {
        const bool forward = !Ridge::IsUmbilic(ridge.nodes[i]) && ridge.nodes[i] == segment.edge0;
        this->AppendPath(trace, segment, forward);
        trace.types.push_back(segment.type);
        trace.vertices.push_back(next);
      }
      else
      {
        this->AppendPiece(trace, segment, next, !inPatch.empty() && inPatch[i]);
      }
    }
    // There are many short ones on noise.
    trace.vertices.shrink_to_fit();
    trace.types.shrink_to_fit();
    return trace;
  }

private:
  /// Empty if there are none.
  std::vector<bool> FindPiecesInPatches(const Ridge& ridge) const
  {
    std::vector<bool> inPatch;
    if (!Ridge::IsUmbilic(ridge.nodes.front()) && !Ridge::IsUmbilic(ridge.nodes.back()))
    {
      return inPatch;
    }
    inPatch.resize(ridge.segments.size(), false);
    const auto mark = [this, &ridge, &inPatch](Id node, std::size_t start, int step)
    {
      if (!Ridge::IsUmbilic(node) || !this->Umbilics_.patchOf)
      {
        return;
      }
      const Id patch = this->Umbilics_.patchOf(Ridge::TriangleOfUmbilic(node));
      for (std::size_t i = start; patch >= 0 && i < ridge.segments.size();
           i += static_cast<std::size_t>(step))
      {
        if (this->Umbilics_.patchOf(this->Segments_[ridge.segments[i]].triangle) != patch)
        {
          break;
        }
        inPatch[i] = true;
      }
    };
    mark(ridge.nodes.front(), 0, 1);
    mark(ridge.nodes.back(), ridge.segments.size() - 1, -1);
    return inPatch;
  }

  RidgePoint PointAt(const Ridge& ridge, std::size_t node) const
  {
    return this->Crossings_.PointOn(ridge.nodes[node]);
  }

  /// The vertex of a node; `beside` is another one next to it, for what an umbilic takes over.
  RidgeVertex VertexAt(const Ridge& ridge, std::size_t node, std::size_t beside) const
  {
    RidgeVertex vertex;
    if (!Ridge::IsUmbilic(ridge.nodes[node]))
    {
      vertex.edge = ridge.nodes[node];
      vertex.point = this->PointAt(ridge, node);
      return vertex;
    }
    const TriangleMesh& mesh = this->Crossings_.Mesh();
    const MongeField& field = this->Crossings_.Field();
    vertex.umbilic = Ridge::TriangleOfUmbilic(ridge.nodes[node]);
    const Eigen::Vector3d position = this->Umbilics_.positionOf
      ? this->Umbilics_.positionOf(vertex.umbilic)
      : UmbilicInTriangle(mesh, field, vertex.umbilic);
    const std::size_t segment = std::min(node, beside);
    const Id path = this->Segments_[ridge.segments[segment]].path;
    // A piece with both ends at an umbilic has a path, which is walked backwards.
    const bool throughPath = path != RidgeSegment::NoPath && !this->Paths_[path].points.empty();
    const bool atEnd = node > beside && Ridge::IsUmbilic(ridge.nodes[beside]);
    const RidgePoint next = !throughPath
      ? this->PointAt(ridge, beside)
      : (atEnd ? this->Paths_[path].points.front() : this->Paths_[path].points.back());
    vertex.point = RidgePointAtUmbilic(mesh, field, vertex.umbilic, position, next);
    return vertex;
  }

  void AppendPath(RidgeTrace& trace, const RidgeSegment& segment, bool forward) const
  {
    const RidgePath& path = this->Paths_[segment.path];
    const std::size_t count = path.edges.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t j = forward ? i : count - 1 - i;
      RidgeVertex vertex;
      vertex.edge = path.edges[j];
      vertex.point = path.points[j];
      trace.types.push_back(segment.type);
      trace.vertices.push_back(vertex);
    }
  }

  void AppendPiece(
    RidgeTrace& trace, const RidgeSegment& segment, const RidgeVertex& next, bool inPatch) const
  {
    const RidgeVertex last = trace.vertices.back();
    const RidgePoint& before = last.point;
    const Color color = before.color;
    if (color != next.point.color)
    {
      trace.types.push_back(RidgeType::Undecided);
    }
    else if (inPatch)
    {
      trace.types.push_back(TypeOf(color, false));
    }
    else if (!this->ByFourthOrder_ || segment.edge1 == RidgeSegment::ToUmbilic)
    {
      trace.types.push_back(segment.type);
    }
    else
    {
      trace.types.push_back(TypeOf(color, before.P < 0.0));
      if ((before.P < 0.0) != (next.point.P < 0.0))
      {
        trace.vertices.push_back(TurningPointBetween(this->Crossings_.Mesh(), last, next));
        trace.types.push_back(TypeOf(color, next.point.P < 0.0));
      }
    }
    trace.vertices.push_back(next);
  }

  const std::vector<RidgeSegment>& Segments_;
  const std::vector<RidgePath>& Paths_;
  const RidgeCrossings& Crossings_;
  bool ByFourthOrder_;
  const UmbilicLookup& Umbilics_;
};

bool AreAlike(const RidgeTrace& trace, Id i, Id j)
{
  return trace.types[i] == trace.types[j] && trace.IsCrest(i) == trace.IsCrest(j);
}

} // namespace

bool RidgeTrace::IsCrest(Id piece) const
{
  return IsElliptic(this->types[piece]) &&
    this->vertices[piece].point.crestMargin + this->vertices[piece + 1].point.crestMargin >= 0.0;
}

RidgeTrace TraceRidge(const Ridge& ridge, const std::vector<RidgeSegment>& segments,
  const std::vector<RidgePath>& paths, const RidgeCrossings& crossings, TypeRule rule,
  const UmbilicLookup& umbilics)
{
  return Tracer(segments, paths, crossings, rule, umbilics).Trace(ridge);
}

std::vector<RidgeRun> RunsOf(const RidgeTrace& trace)
{
  std::vector<RidgeRun> runs;
  const Id count = static_cast<Id>(trace.types.size());
  for (Id first = 0; first < count;)
  {
    Id last = first + 1;
    while (last < count && AreAlike(trace, last - 1, last))
    {
      ++last;
    }
    runs.push_back({ first, last });
    first = last;
  }
  return runs;
}

void RotateLoop(RidgeTrace& trace, std::size_t start)
{
  const auto shift = static_cast<std::ptrdiff_t>(start);
  trace.vertices.pop_back();
  std::rotate(trace.types.begin(), trace.types.begin() + shift, trace.types.end());
  std::rotate(trace.vertices.begin(), trace.vertices.begin() + shift, trace.vertices.end());
  trace.vertices.push_back(trace.vertices.front());
}

void MakeCanonical(const TriangleMesh& mesh, RidgeTrace& trace)
{
  const std::size_t count = trace.types.size();
  if (trace.closed)
  {
    std::size_t start = 0;
    bool startsRun = false;
    for (std::size_t i = 0; i < count; ++i)
    {
      const bool here =
        !AreAlike(trace, static_cast<Id>((i + count - 1) % count), static_cast<Id>(i));
      const bool comesFirst = Compare(mesh, trace.vertices[i], trace.vertices[start]) < 0;
      if ((here && !startsRun) || (here == startsRun && comesFirst))
      {
        start = i;
        startsRun = here;
      }
    }
    RotateLoop(trace, start);
  }
  // A ridge from an umbilic back to itself has equal ends, as a loop has.
  for (std::size_t i = trace.closed ? 1 : 0; i <= count / 2; ++i)
  {
    const int order = Compare(mesh, trace.vertices[i], trace.vertices[count - i]);
    if (order > 0)
    {
      std::reverse(trace.vertices.begin(), trace.vertices.end());
      std::reverse(trace.types.begin(), trace.types.end());
    }
    if (order != 0)
    {
      break;
    }
  }
}

bool ComesBefore(const TriangleMesh& mesh, const RidgeTrace& a, const RidgeTrace& b)
{
  const std::size_t count = std::min(a.vertices.size(), b.vertices.size());
  for (std::size_t i = 0; i < count; ++i)
  {
    const int order = Compare(mesh, a.vertices[i], b.vertices[i]);
    if (order != 0)
    {
      return order < 0;
    }
  }
  return a.vertices.size() < b.vertices.size();
}

} // namespace ridges
