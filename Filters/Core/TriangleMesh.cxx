// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleMesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace ridges
{

TriangleMesh::TriangleMesh(
  const double* points, Id numberOfPoints, std::vector<Triangle> triangles, Edges edges)
  : Points_(points)
  , NumberOfPoints_(numberOfPoints)
  , Triangles_(std::move(triangles))
{
  this->BuildIncidence();
  if (edges == Edges::Built)
  {
    this->BuildEdges();
  }
}

void TriangleMesh::BuildIncidence()
{
  this->Offsets_.assign(static_cast<std::size_t>(this->NumberOfPoints_) + 1, 0);
  for (const Triangle& triangle : this->Triangles_)
  {
    for (const Id p : triangle)
    {
      ++this->Offsets_[p + 1];
    }
  }
  for (Id p = 0; p < this->NumberOfPoints_; ++p)
  {
    this->Offsets_[p + 1] += this->Offsets_[p];
  }

  this->Incident_.resize(3 * this->Triangles_.size());
  std::vector<Id> next(this->Offsets_.begin(), this->Offsets_.end() - 1);
  for (Id t = 0; t < this->NumberOfTriangles(); ++t)
  {
    for (const Id p : this->Triangles_[t])
    {
      this->Incident_[next[p]++] = t;
    }
  }
}

void TriangleMesh::BuildEdges(const RangeLoop& loop)
{
  // Chunks of points find and number the edges to larger points on their own; then the chunks are
  // put one behind the other.
  constexpr Id chunkSize = 4096;
  const Id count = this->NumberOfPoints_;
  const Id chunks = (count + chunkSize - 1) / chunkSize;
  std::vector<std::vector<Edge>> found(chunks);
  this->TriangleEdges_.resize(this->Triangles_.size());
  loop(chunks,
    [&](Id begin, Id end)
    {
      for (Id chunk = begin; chunk < end; ++chunk)
      {
        this->FindEdges(chunk * chunkSize, std::min(count, (chunk + 1) * chunkSize), found[chunk]);
      }
    });

  std::vector<Id> first(static_cast<std::size_t>(chunks) + 1, 0);
  for (Id chunk = 0; chunk < chunks; ++chunk)
  {
    first[chunk + 1] = first[chunk] + static_cast<Id>(found[chunk].size());
  }
  this->Edges_.resize(first[chunks]);
  loop(chunks,
    [&](Id begin, Id end)
    {
      for (Id chunk = begin; chunk < end; ++chunk)
      {
        std::copy(found[chunk].begin(), found[chunk].end(), this->Edges_.begin() + first[chunk]);
      }
    });
  loop(this->NumberOfTriangles(),
    [&](Id begin, Id end)
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
  for (const Edge& edge : this->Edges_)
  {
    if (edge.t1 < 0)
    {
      this->OnBorder_[edge.v0] = 1;
      this->OnBorder_[edge.v1] = 1;
    }
  }
}

/// Appends the edges from the points [begin, end) to larger ones, numbered from 0.
void TriangleMesh::FindEdges(Id begin, Id end, std::vector<Edge>& edges)
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
      for (; i < last; ++i)
      {
        this->TriangleEdges_[halfEdges[i].triangle][halfEdges[i].side] = number;
      }
    }
  }
}

Eigen::Vector3d TriangleMesh::Centroid(Id t) const
{
  const Triangle& c = this->Triangles_[t];
  return (this->Point(c[0]) + this->Point(c[1]) + this->Point(c[2])) / 3.0;
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
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (const Id t : this->TrianglesAround(p))
  {
    normal += this->AreaNormal(t);
  }
  return normal;
}

Id TriangleMesh::EulerCharacteristic() const
{
  Id used = 0;
  for (Id p = 0; p < this->NumberOfPoints_; ++p)
  {
    used += this->Offsets_[p + 1] > this->Offsets_[p] ? 1 : 0;
  }
  return used - this->NumberOfEdges() + this->NumberOfTriangles();
}

Id TriangleMesh::NumberOfInconsistentEdges() const
{
  const auto startsAt = [this](Id t, Id e)
  {
    const Triangle& edges = this->TriangleEdges_[t];
    const auto side = std::find(edges.begin(), edges.end(), e) - edges.begin();
    return this->Triangles_[t][side];
  };
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

void TriangleMesh::OrientConsistently()
{
  std::vector<std::uint8_t> isReached(this->NumberOfTriangles(), 0);
  std::vector<Id> reached;
  for (Id first = 0; first < this->NumberOfTriangles(); ++first)
  {
    if (isReached[first])
    {
      continue;
    }
    isReached[first] = 1;
    reached.assign(1, first);
    for (std::size_t i = 0; i < reached.size(); ++i)
    {
      const Id t = reached[i];
      for (int side = 0; side < 3; ++side)
      {
        const Id next = this->Neighbor(t, side);
        if (next < 0 || isReached[next])
        {
          continue;
        }
        isReached[next] = 1;
        reached.push_back(next);
        Triangle& corners = this->Triangles_[next];
        const Id from = this->Triangles_[t][side];
        const Id to = this->Triangles_[t][(side + 1) % 3];
        for (int j = 0; j < 3; ++j)
        {
          if (corners[j] == from && corners[(j + 1) % 3] == to)
          {
            std::swap(corners[1], corners[2]);
            std::swap(this->TriangleEdges_[next][0], this->TriangleEdges_[next][2]);
            break;
          }
        }
      }
    }
  }
}

} // namespace ridges
