// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/TriangleMesh.h"

#include "Mesh/PositionOrder.h"

#include "Mesh/Regions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

namespace ridges
{
namespace
{

Buffer<Triangle> CopyOf(const std::vector<Triangle>& triangles)
{
  Buffer<Triangle> copy(triangles.size());
  std::copy(triangles.begin(), triangles.end(), copy.begin());
  return copy;
}

} // namespace

TriangleMesh::TriangleMesh(const double* points, Id numberOfPoints, Buffer<Triangle> triangles,
  Edges edges, const RangeLoop& loop, Id shares)
  : Points_(points)
  , NumberOfPoints_(numberOfPoints)
  , Triangles_(std::move(triangles))
{
  this->BuildIncidence(loop, shares);
  if (edges == Edges::Built)
  {
    this->BuildEdges(loop);
  }
}

TriangleMesh::TriangleMesh(
  const double* points, Id numberOfPoints, const std::vector<Triangle>& triangles, Edges edges)
  : TriangleMesh(points, numberOfPoints, CopyOf(triangles), edges)
{
}

void TriangleMesh::BuildIncidence(const RangeLoop& loop, Id shares)
{
  // Each share of the triangles counts its corners at the points; what it counted then becomes
  // the place of the next triangle of this share at the point, behind those of the shares before.
  const auto points = static_cast<std::size_t>(this->NumberOfPoints_);
  Buffer<Id> next(points * shares);
  const auto forShares = [this, &next, &points, &shares, &loop](auto visit)
  {
    loop(shares,
      [this, &visit, &next, &points, &shares](Id begin, Id end)
      {
        for (Id share = begin; share < end; ++share)
        {
          const std::int64_t count = this->NumberOfTriangles();
          visit(next.data() + points * share, static_cast<Id>(count * share / shares),
            static_cast<Id>(count * (share + 1) / shares));
        }
      });
  };
  forShares(
    [this, &points](Id* counts, Id begin, Id end)
    {
      std::fill_n(counts, points, 0);
      for (Id t = begin; t < end; ++t)
      {
        for (const Id p : this->Triangles_[t])
        {
          ++counts[p];
        }
      }
    });

  this->Offsets_ = Buffer<Id>(points + 1);
  Id sum = 0;
  for (std::size_t p = 0; p < points; ++p)
  {
    this->Offsets_[p] = sum;
    for (Id share = 0; share < shares; ++share)
    {
      Id& place = next[points * share + p];
      const Id count = place;
      place = sum;
      sum += count;
    }
  }
  this->Offsets_[points] = sum;

  this->Incident_ = Buffer<Id>(sum);
  forShares(
    [this](Id* places, Id begin, Id end)
    {
      for (Id t = begin; t < end; ++t)
      {
        for (const Id p : this->Triangles_[t])
        {
          this->Incident_[places[p]++] = t;
        }
      }
    });
}

void TriangleMesh::BuildEdges(const RangeLoop& loop)
{
  // Chunks of points find and number the edges to larger points on their own; then the chunks are
  // put one behind the other.
  constexpr Id chunkSize = 4096;
  const Id count = this->NumberOfPoints_;
  const Id chunks = (count + chunkSize - 1) / chunkSize;
  std::vector<std::vector<Edge>> found(chunks);
  std::vector<std::vector<Id>> border(chunks); // in found[chunk]
  this->TriangleEdges_ = Buffer<Triangle>(this->Triangles_.size());
  loop(chunks,
    [this, &count, &found, &border](Id begin, Id end)
    {
      for (Id chunk = begin; chunk < end; ++chunk)
      {
        this->FindEdges(
          chunk * chunkSize, std::min(count, (chunk + 1) * chunkSize), found[chunk], border[chunk]);
      }
    });

  std::vector<Id> first(static_cast<std::size_t>(chunks) + 1, 0);
  for (Id chunk = 0; chunk < chunks; ++chunk)
  {
    first[chunk + 1] = first[chunk] + static_cast<Id>(found[chunk].size());
  }
  this->Edges_ = Buffer<Edge>(first[chunks]);
  loop(chunks,
    [this, &found, &first](Id begin, Id end)
    {
      for (Id chunk = begin; chunk < end; ++chunk)
      {
        std::copy(found[chunk].begin(), found[chunk].end(), this->Edges_.begin() + first[chunk]);
      }
    });
  loop(this->NumberOfTriangles(),
    [this, &first](Id begin, Id end)
    {
      for (Id t = begin; t < end; ++t)
      {
        const Triangle& c = this->Triangles_[t];
        for (int i = 0; i < 3; ++i)
        {
          this->TriangleEdges_[t][i] += first[std::min(c[i], c[(i + 1) % 3]) / chunkSize];
        }
      }
    });

  this->OnBorder_.assign(count, 0);
  for (Id chunk = 0; chunk < chunks; ++chunk)
  {
    for (const Id e : border[chunk])
    {
      const Edge& edge = found[chunk][e];
      this->OnBorder_[edge.v0] = 1;
      this->OnBorder_[edge.v1] = 1;
    }
  }
}

/// Appends the edges from the points [begin, end) to larger ones, numbered from 0, and the numbers
/// of those that do not have exactly two triangles.
void TriangleMesh::FindEdges(Id begin, Id end, std::vector<Edge>& edges, std::vector<Id>& border)
{
  struct HalfEdge
  {
    Id other;
    Id triangle;
    int side;
  };
  edges.reserve(3 * static_cast<std::size_t>(end - begin) + 64);
  std::vector<HalfEdge> halfEdges;
  for (Id p = begin; p < end; ++p)
  {
    // Sorted by the other end: safe also where very many triangles share one point.
    halfEdges.clear();
    for (const Id t : this->TrianglesAround(p))
    {
      const Triangle& corners = this->Triangles_[t];
      for (int i = 0; i < 3; ++i)
      {
        const Id a = corners[i];
        const Id b = corners[(i + 1) % 3];
        if (std::min(a, b) == p)
        {
          halfEdges.push_back({ std::max(a, b), t, i });
        }
      }
    }
    std::sort(halfEdges.begin(), halfEdges.end(),
      [](const HalfEdge& a, const HalfEdge& b)
      { return a.other != b.other ? a.other < b.other : a.triangle < b.triangle; });

    for (std::size_t i = 0; i < halfEdges.size();)
    {
      std::size_t last = i + 1;
      while (last < halfEdges.size() && halfEdges[last].other == halfEdges[i].other)
      {
        ++last;
      }
      const std::size_t count = last - i;
      const Id t1 = count == 2 ? halfEdges[i + 1].triangle : (count == 1 ? Border : NonManifold);
      const Id number = static_cast<Id>(edges.size());
      edges.push_back({ p, halfEdges[i].other, halfEdges[i].triangle, t1 });
      if (t1 < 0)
      {
        border.push_back(number);
      }
      for (; i < last; ++i)
      {
        this->TriangleEdges_[halfEdges[i].triangle][halfEdges[i].side] = number;
      }
    }
  }
}

Eigen::Vector3d TriangleMesh::Centroid(Id t) const
{
  // Summed by size, so that the corner that a triangle starts at does not show even in round-off.
  const Triangle& c = this->Corners(t);
  const Eigen::Array3d x = this->Point(c[0]);
  const Eigen::Array3d y = this->Point(c[1]);
  const Eigen::Array3d z = this->Point(c[2]);
  const Eigen::Array3d lower = x.min(y);
  const Eigen::Array3d upper = x.max(y);
  const Eigen::Array3d middle = lower.max(upper.min(z));
  return (lower.min(z) + middle + upper.max(z)) / 3.0;
}

Eigen::Vector3d TriangleMesh::AreaNormal(Id t) const
{
  const Triangle& c = this->Triangles_[t];
  const Eigen::Vector3d e1 = this->Point(c[1]) - this->Point(c[0]);
  const Eigen::Vector3d e2 = this->Point(c[2]) - this->Point(c[0]);
  return e1.cross(e2);
}

Eigen::Vector3d TriangleMesh::PointNormal(Id p) const
{
  // Most fans are small: their normals are computed once.
  std::array<Eigen::Vector3d, 16> kept;
  const Span<Id> fan = this->TrianglesAround(p);
  double largest = 0.0;
  double area = 0.0;
  for (Id i = 0; i < fan.size(); ++i)
  {
    const Eigen::Vector3d normal = AreaNormalInOrder(*this, fan[i]);
    largest = std::max(largest, normal.cwiseAbs().maxCoeff());
    area += normal.norm();
    if (i < static_cast<Id>(kept.size()))
    {
      kept[i] = normal;
    }
  }
  // Rounded to one grain, far below what matters: such sums are exact in any order, so that the
  // numbering does not show even in the last digit.
  constexpr double grainsInLargest = 1 << 20;
  const double grain = largest * grainsInLargest;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Id i = 0; i < fan.size(); ++i)
  {
    const Eigen::Vector3d normal =
      i < static_cast<Id>(kept.size()) ? kept[i] : AreaNormalInOrder(*this, fan[i]);
    sum.array() += (normal.array() + grain) - grain;
  }
  // What is left of triangles that are folded flat is round-off.
  constexpr double roundOff = 1e-8;
  if (!(sum.norm() > roundOff * area))
  {
    sum.setZero();
  }
  return sum;
}

double TriangleMesh::MeanEdgeLength() const
{
  double sum = 0.0;
  for (const Edge& edge : this->Edges_)
  {
    sum += (this->Point(edge.v0) - this->Point(edge.v1)).norm();
  }
  return this->NumberOfEdges() > 0 ? sum / this->NumberOfEdges() : 0.0;
}

Id TriangleMesh::EulerCharacteristic(const RangeLoop& loop) const
{
  std::atomic<Id> fans{ 0 };
  loop(this->NumberOfPoints_,
    [this, &fans](Id begin, Id end)
    {
      Id sum = 0;
      for (Id p = begin; p < end; ++p)
      {
        sum += this->NumberOfFans(p);
      }
      fans += sum;
    });
  // A border edge has one triangle, and where an edge has more than two each has it for itself.
  const Id sides = 3 * this->NumberOfTriangles();
  const auto shared = static_cast<Id>(std::count_if(
    this->Edges_.begin(), this->Edges_.end(), [](const Edge& edge) { return edge.t1 >= 0; }));
  return fans - (sides - shared) + this->NumberOfTriangles();
}

Id TriangleMesh::NumberOfFans(Id p) const
{
  return this->IsSmallClosedFan(p) ? 1 : this->CountFans(p);
}

/// Whether the triangles around p are one closed fan, of one orientation and at most eight, as
/// those of nearly all points are.
bool TriangleMesh::IsSmallClosedFan(Id p) const
{
  constexpr Id most = 8;
  const Span<Id> triangles = this->TrianglesAround(p);
  const Id count = triangles.size();
  if (count < 2 || count > most)
  {
    return false;
  }
  std::array<Id, most> from;
  std::array<Id, most> to{};
  from.fill(-1);
  for (Id i = 0; i < count; ++i)
  {
    const Triangle& c = this->Triangles_[triangles[i]];
    from[i] = c[0] == p ? c[1] : (c[1] == p ? c[2] : c[0]);
    to[i] = c[0] == p ? c[2] : (c[1] == p ? c[0] : c[1]);
  }
  Id at = 0;
  for (Id length = 1; length <= count; ++length)
  {
    at = static_cast<Id>(std::find(from.begin(), from.end(), to[at]) - from.begin());
    if (at == most || (at == 0) != (length == count))
    {
      return false;
    }
  }
  return true;
}

/// The same by joining the triangles at the edges that they share.
Id TriangleMesh::CountFans(Id p) const
{
  struct Spoke
  {
    Id end;
    Id triangle;
  };
  const Span<Id> triangles = this->TrianglesAround(p);
  std::vector<Spoke> spokes;
  std::vector<Id> parent(triangles.size());
  for (Id i = 0; i < triangles.size(); ++i)
  {
    parent[i] = i;
    for (const Id q : this->Triangles_[triangles[i]])
    {
      if (q != p)
      {
        spokes.push_back({ q, i });
      }
    }
  }
  std::sort(spokes.begin(), spokes.end(),
    [](const Spoke& a, const Spoke& b)
    { return a.end != b.end ? a.end < b.end : a.triangle < b.triangle; });
  const auto rootOf = [&parent](Id i)
  {
    while (parent[i] != i)
    {
      parent[i] = parent[parent[i]];
      i = parent[i];
    }
    return i;
  };
  Id fans = triangles.size();
  for (std::size_t i = 0; i < spokes.size();)
  {
    std::size_t last = i + 1;
    while (last < spokes.size() && spokes[last].end == spokes[i].end)
    {
      ++last;
    }
    const Id a = rootOf(spokes[i].triangle);
    const Id b = last == i + 2 ? rootOf(spokes[i + 1].triangle) : a;
    fans -= a != b ? 1 : 0;
    parent[std::max(a, b)] = std::min(a, b);
    i = last;
  }
  return fans;
}

Id TriangleMesh::NumberOfInconsistentEdges() const
{
  const auto startsAt = [this](Id t, Id e) { return this->Triangles_[t][this->SideOf(t, e)]; };
  Id count = 0;
  for (Id e = 0; e < this->NumberOfEdges(); ++e)
  {
    const Edge& edge = this->Edges_[e];
    count += edge.t1 >= 0 && startsAt(edge.t0, e) == startsAt(edge.t1, e) ? 1 : 0;
  }
  return count;
}

Id TriangleMesh::NumberOfNonManifoldEdges() const
{
  return static_cast<Id>(std::count_if(this->Edges_.begin(), this->Edges_.end(),
    [](const Edge& edge) { return edge.t1 == NonManifold; }));
}

TriangleMesh TriangleMesh::ConsistentlyOriented() const
{
  Buffer<Triangle> triangles(this->Triangles_.size());
  std::copy(this->Triangles_.begin(), this->Triangles_.end(), triangles.begin());
  std::vector<std::uint8_t> isReached(this->NumberOfTriangles(), 0);
  const auto orient = [this, &triangles, &isReached](Id from, Id next)
  {
    if (isReached[next])
    {
      return false;
    }
    isReached[next] = 1;
    const Triangle& t = triangles[from];
    Triangle& s = triangles[next];
    for (int side = 0; side < 3; ++side)
    {
      // Both run through their edge in one sense, as they are now.
      if (RunsThrough(s, t[side], t[(side + 1) % 3]))
      {
        std::swap(s[1], s[2]);
        break;
      }
    }
    return true;
  };
  for (Id first = 0; first < this->NumberOfTriangles(); ++first)
  {
    if (!isReached[first])
    {
      isReached[first] = 1;
      TrianglesFrom(*this, first, orient);
    }
  }
  return TriangleMesh(this->Points_, this->NumberOfPoints_, std::move(triangles));
}

} // namespace ridges
