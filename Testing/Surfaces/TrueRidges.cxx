// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TrueRidges.h"

#include "ExactRidges.h"
#include "Fixtures/TestFields.h"
#include "ParallelFor.h"

#include "Ridges/MarchingTriangles.h"
#include "Ridges/RidgeAssembly.h"
#include "Ridges/RidgeCrossings.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace ridges
{
namespace testing
{

using Eigen::Vector3d;

namespace
{

//------------------------------------------------------------------------------
FieldArrays ExactFieldInParallel(const TriangleMesh& mesh, const AnalyticSurface& surface)
{
  FieldArrays field(mesh.NumberOfPoints());
  ParallelFor(static_cast<std::size_t>(mesh.NumberOfPoints()),
    [&](std::size_t i)
    {
      const Id p = static_cast<Id>(i);
      field.Set(p, ToMongeForm(surface.Monge(mesh.Point(p))));
    });
  return field;
}

//------------------------------------------------------------------------------
int NearestUmbilic(const std::vector<ExactUmbilic>& umbilics, const Vector3d& point, double reach)
{
  int nearest = -1;
  for (std::size_t i = 0; i < umbilics.size(); ++i)
  {
    const double distance = (umbilics[i].position - point).norm();
    if (distance < reach)
    {
      reach = distance;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

//------------------------------------------------------------------------------
class RidgeMaker
{
public:
  RidgeMaker(const AnalyticSurface& surface, const std::vector<ExactUmbilic>& umbilics,
    const RidgeCrossings& crossings, double edge)
    : Surface(surface)
    , Umbilics(umbilics)
    , Crossings(crossings)
    , Edge(edge)
  {
  }

  TrueRidge Make(const Ridge& ridge) const
  {
    TrueRidge result;
    result.maximum = this->Crossings.RidgeColor() == Color::Blue;
    result.closed = ridge.closed;
    const std::size_t count = ridge.nodes.size();
    result.points.resize(count);
    result.P.resize(count);
    ParallelFor(count,
      [&](std::size_t i)
      {
        if (!Ridge::IsUmbilic(ridge.nodes[i]))
        {
          this->Place(ridge.nodes[i], result.maximum, result.points[i], result.P[i]);
        }
      });
    this->PlaceEnd(ridge.nodes.front(), result, 0, 1);
    this->PlaceEnd(ridge.nodes.back(), result, 1, count - 2);
    return result;
  }

private:
  void Place(Id edge, bool maximum, Vector3d& point, double& P) const
  {
    const RidgePoint& crossing = this->Crossings.PointOn(edge);
    point = crossing.position;
    P = crossing.P;
    const ExactRidgePoint exact = NearestRidgePoint(this->Surface, maximum, point, this->Edge);
    if (exact.found)
    {
      point = exact.monge.origin;
      P = maximum ? exact.monge.P1 : exact.monge.P2;
    }
  }

  void PlaceEnd(Id node, TrueRidge& ridge, int end, std::size_t next) const
  {
    if (!Ridge::IsUmbilic(node))
    {
      return;
    }
    Vector3d& point = end == 0 ? ridge.points.front() : ridge.points.back();
    const Id triangle = Ridge::TriangleOfUmbilic(node);
    point = this->Crossings.Mesh().Centroid(triangle);
    const int umbilic = NearestUmbilic(this->Umbilics, point, 2.0 * this->Edge);
    if (umbilic >= 0)
    {
      point = this->Umbilics[umbilic].position;
      ridge.umbilics[end] = umbilic;
    }
    (end == 0 ? ridge.P.front() : ridge.P.back()) = ridge.P[next];
  }

  const AnalyticSurface& Surface;
  const std::vector<ExactUmbilic>& Umbilics;
  const RidgeCrossings& Crossings;
  double Edge;
};

//------------------------------------------------------------------------------
// The triangle of an umbilic may be crossed by one ridge where three end, however small it is: two
// zeros on one edge are not seen, and the two ridges turn about before the umbilic and are one.
// There the ridges inside a circle, the smallest that as many as should be cross, are drawn anew.
class MissedEnds
{
public:
  MissedEnds(const AnalyticSurface& surface, std::vector<TrueRidge>& ridges,
    const std::vector<ExactUmbilic>& umbilics, double edge)
    : Surface(surface)
    , Ridges(ridges)
    , Umbilics(umbilics)
    , Edge(edge)
  {
  }

  void Join()
  {
    for (std::size_t u = 0; u < this->Umbilics.size(); ++u)
    {
      for (const bool maximum : { true, false })
      {
        const int umbilic = static_cast<int>(u);
        const int expected = this->Umbilics[u].ridgeCount;
        if (this->CountEnds(this->Ridges, umbilic, maximum) == expected)
        {
          continue;
        }
        const double largest = 0.5 * this->DistanceToNext(u);
        for (double radius = this->Edge; radius < largest; radius *= 1.3)
        {
          const std::vector<TrueRidge> clipped = this->Clip(umbilic, maximum, radius);
          if (this->CountEnds(clipped, umbilic, maximum) == expected)
          {
            this->Ridges = clipped;
            break;
          }
        }
      }
    }
  }

private:
  static int CountEnds(const std::vector<TrueRidge>& ridges, int umbilic, bool maximum)
  {
    int count = 0;
    for (const TrueRidge& ridge : ridges)
    {
      if (ridge.maximum == maximum)
      {
        count +=
          static_cast<int>(std::count(ridge.umbilics.begin(), ridge.umbilics.end(), umbilic));
      }
    }
    return count;
  }

  double DistanceToNext(std::size_t u) const
  {
    double least = std::numeric_limits<double>::max();
    for (std::size_t v = 0; v < this->Umbilics.size(); ++v)
    {
      const double distance = (this->Umbilics[u].position - this->Umbilics[v].position).norm();
      least = v == u ? least : std::min(least, distance);
    }
    return least;
  }

  // All ridges, those of one colour without what is within the radius of the umbilic; where they
  // are cut they go straight to it.
  std::vector<TrueRidge> Clip(int umbilic, bool maximum, double radius) const
  {
    const Vector3d& center = this->Umbilics[umbilic].position;
    std::vector<TrueRidge> result;
    for (TrueRidge ridge : this->Ridges)
    {
      const auto isInside = [&](const Vector3d& p) { return (p - center).norm() < radius; };
      const auto inside = std::find_if(ridge.points.begin(), ridge.points.end(), isInside);
      if (ridge.maximum != maximum || inside == ridge.points.end())
      {
        result.push_back(ridge);
        continue;
      }
      if (ridge.closed)
      {
        const auto shift = inside - ridge.points.begin();
        ridge.points.pop_back();
        ridge.P.pop_back();
        std::rotate(ridge.points.begin(), ridge.points.begin() + shift, ridge.points.end());
        std::rotate(ridge.P.begin(), ridge.P.begin() + shift, ridge.P.end());
        ridge.points.push_back(ridge.points.front());
        ridge.P.push_back(ridge.P.front());
      }
      const std::size_t count = ridge.points.size();
      for (std::size_t first = 0; first < count; ++first)
      {
        if (isInside(ridge.points[first]))
        {
          continue;
        }
        std::size_t last = first;
        while (last + 1 < count && !isInside(ridge.points[last + 1]))
        {
          ++last;
        }
        TrueRidge part;
        part.maximum = maximum;
        part.points.assign(ridge.points.begin() + first, ridge.points.begin() + last + 1);
        part.P.assign(ridge.P.begin() + first, ridge.P.begin() + last + 1);
        part.umbilics = ridge.umbilics;
        if (last + 1 < count)
        {
          this->GoTo(umbilic, part);
          part.umbilics[1] = umbilic;
        }
        if (first > 0)
        {
          std::reverse(part.points.begin(), part.points.end());
          std::reverse(part.P.begin(), part.P.end());
          this->GoTo(umbilic, part);
          std::reverse(part.points.begin(), part.points.end());
          std::reverse(part.P.begin(), part.P.end());
          part.umbilics[0] = umbilic;
        }
        result.push_back(part);
        first = last;
      }
    }
    return result;
  }

  void GoTo(int umbilic, TrueRidge& ridge) const
  {
    const Vector3d center = this->Umbilics[umbilic].position;
    const Vector3d from = ridge.points.back();
    const int steps = 8;
    for (int i = 1; i < steps; ++i)
    {
      Vector3d point = from + (center - from) * i / steps;
      double P = ridge.P.back();
      const ExactRidgePoint exact =
        NearestRidgePoint(this->Surface, ridge.maximum, point, 0.15 * (point - center).norm());
      if (exact.found)
      {
        point = exact.monge.origin;
        P = ridge.maximum ? exact.monge.P1 : exact.monge.P2;
      }
      ridge.points.push_back(point);
      ridge.P.push_back(P);
    }
    ridge.points.push_back(center);
    ridge.P.push_back(ridge.P.back());
  }

  const AnalyticSurface& Surface;
  std::vector<TrueRidge>& Ridges;
  const std::vector<ExactUmbilic>& Umbilics;
  double Edge;
};

} // namespace

//------------------------------------------------------------------------------
int NumberOfArcs(const TrueRidge& ridge)
{
  int turns = 0;
  for (std::size_t i = 1; i < ridge.P.size(); ++i)
  {
    turns += (ridge.P[i] > 0.0) != (ridge.P[i - 1] > 0.0) ? 1 : 0;
  }
  return ridge.closed ? std::max(turns, 1) : turns + 1;
}

//------------------------------------------------------------------------------
std::array<double, 5> LengthsByType(const std::vector<TrueRidge>& ridges)
{
  std::array<double, 5> lengths{};
  for (const TrueRidge& ridge : ridges)
  {
    for (std::size_t i = 1; i < ridge.points.size(); ++i)
    {
      const double length = (ridge.points[i] - ridge.points[i - 1]).norm();
      const double P0 = ridge.P[i - 1];
      const double P1 = ridge.P[i];
      const double negative =
        P0 < 0.0 ? (P1 < 0.0 ? 1.0 : P0 / (P0 - P1)) : (P1 < 0.0 ? P1 / (P1 - P0) : 0.0);
      const int elliptic = ridge.maximum ? 1 : 3;
      lengths[elliptic] += negative * length;
      lengths[elliptic + 1] += (1.0 - negative) * length;
    }
  }
  return lengths;
}

//------------------------------------------------------------------------------
std::vector<TrueRidge> FindRidges(
  const AnalyticSurface& surface, const Mesh& fineMesh, const std::vector<ExactUmbilic>& umbilics)
{
  const MeshedSurface meshed(fineMesh);
  const TriangleMesh& mesh = meshed.Triangles();
  const FieldArrays field = ExactFieldInParallel(mesh, surface);
  std::vector<TrueRidge> found;
  for (const Color color : { Color::Blue, Color::Red })
  {
    RidgeCrossings crossings(mesh, field.View(), color, CrossingRule::Form);
    crossings.Build();
    std::vector<RidgeSegment> segments;
    for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      MarchTriangle(crossings, TypeRule::FourthOrder, t, segments);
    }
    const RidgeMaker maker(surface, umbilics, crossings, meshed.Triangles().MeanEdgeLength());
    for (const Ridge& ridge : AssembleRidges(crossings, segments))
    {
      found.push_back(maker.Make(ridge));
    }
  }
  MissedEnds(surface, found, umbilics, meshed.Triangles().MeanEdgeLength()).Join();
  return found;
}

//------------------------------------------------------------------------------
std::vector<std::string> DoubtsAbout(
  const std::vector<TrueRidge>& ridges, const std::vector<ExactUmbilic>& umbilics)
{
  std::vector<std::string> doubts;
  std::map<std::pair<bool, int>, int> ends;
  for (const TrueRidge& ridge : ridges)
  {
    for (const int umbilic : ridge.umbilics)
    {
      ++ends[{ ridge.maximum, umbilic }];
      if (!ridge.closed && umbilic < 0)
      {
        doubts.emplace_back("a ridge ends where no umbilic is");
      }
    }
  }
  for (std::size_t i = 0; i < umbilics.size(); ++i)
  {
    for (const bool maximum : { true, false })
    {
      const int count = ends[{ maximum, static_cast<int>(i) }];
      if (count != umbilics[i].ridgeCount)
      {
        doubts.push_back("umbilic " + std::to_string(i) + " has " + std::to_string(count) +
          (maximum ? " blue" : " red") + " ridges instead of " +
          std::to_string(umbilics[i].ridgeCount));
      }
    }
  }
  return doubts;
}

//------------------------------------------------------------------------------
Mesh Subdivide(const Mesh& mesh, const AnalyticSurface& surface)
{
  using Index = std::int32_t;
  Mesh result;
  result.points = mesh.points;
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middleOf = [&](Index i, Index j)
  {
    const auto inserted = middles.emplace(
      std::make_pair(std::min(i, j), std::max(i, j)), static_cast<Index>(result.PointCount()));
    if (inserted.second)
    {
      result.AddPoint(Vector3d::Zero());
    }
    return inserted.first->second;
  };
  for (std::size_t t = 0; t < mesh.TriangleCount(); ++t)
  {
    const Index* corners = &mesh.triangles[3 * t];
    std::array<Index, 3> middle{};
    for (int i = 0; i < 3; ++i)
    {
      middle[i] = middleOf(corners[i], corners[(i + 1) % 3]);
    }
    for (int i = 0; i < 3; ++i)
    {
      result.AddTriangle(corners[i], middle[i], middle[(i + 2) % 3]);
    }
    result.AddTriangle(middle[0], middle[1], middle[2]);
  }
  const std::vector<std::pair<std::pair<Index, Index>, Index>> list(middles.begin(), middles.end());
  ParallelFor(list.size(),
    [&](std::size_t i)
    {
      const std::pair<Index, Index>& edge = list[i].first;
      result.SetPoint(
        list[i].second, surface.Project(0.5 * (mesh.Point(edge.first) + mesh.Point(edge.second))));
    });
  return result;
}

} // namespace testing
} // namespace ridges
