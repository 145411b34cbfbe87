// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Coherence/UmbilicChecks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace ridges
{
namespace
{

class DisjointSets
{
public:
  explicit DisjointSets(std::size_t size)
    : Parents_(size)
  {
    std::iota(this->Parents_.begin(), this->Parents_.end(), 0);
  }

  std::size_t Find(std::size_t i)
  {
    while (this->Parents_[i] != i)
    {
      this->Parents_[i] = this->Parents_[this->Parents_[i]];
      i = this->Parents_[i];
    }
    return i;
  }

  void Join(std::size_t i, std::size_t j)
  {
    i = this->Find(i);
    j = this->Find(j);
    this->Parents_[std::max(i, j)] = std::min(i, j);
  }

private:
  std::vector<std::size_t> Parents_;
};

/// A part of the mesh whose triangles are connected through edges of two triangles.
struct Part
{
  Id triangle = -1; ///< The first of it.
  bool closed = true;
  Id characteristic = 0;
  double indexSum = 0.0;
};

struct Parts
{
  std::vector<Part> parts;
  std::vector<Id> partOf; ///< Per triangle.
};

// Corners that edges with two triangles join are one point of a part: thus a point at which two
// fans of triangles touch is two.
Parts FindParts(const TriangleMesh& mesh)
{
  const auto count = static_cast<std::size_t>(mesh.NumberOfTriangles());
  DisjointSets triangles(count);
  DisjointSets corners(3 * count);
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    const Edge& edge = mesh.EdgeAt(e);
    if (edge.t1 >= 0)
    {
      triangles.Join(edge.t0, edge.t1);
      for (const Id p : { edge.v0, edge.v1 })
      {
        corners.Join(3 * static_cast<std::size_t>(edge.t0) + CornerOf(mesh.Corners(edge.t0), p),
          3 * static_cast<std::size_t>(edge.t1) + CornerOf(mesh.Corners(edge.t1), p));
      }
    }
  }
  Parts found;
  found.partOf.resize(count);
  for (std::size_t t = 0; t < count; ++t)
  {
    const std::size_t root = triangles.Find(t); // the first triangle of its part
    if (root == t)
    {
      found.partOf[t] = static_cast<Id>(found.parts.size());
      found.parts.emplace_back();
      found.parts.back().triangle = static_cast<Id>(t);
    }
    found.partOf[t] = found.partOf[root];
    Part& part = found.parts[found.partOf[t]];
    ++part.characteristic;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      part.characteristic += corners.Find(3 * t + corner) == 3 * t + corner ? 1 : 0;
    }
  }
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    const Edge& edge = mesh.EdgeAt(e);
    if (edge.t1 >= 0)
    {
      --found.parts[found.partOf[edge.t0]].characteristic;
      continue;
    }
    for (const Id t : TrianglesAt(mesh, e))
    {
      found.parts[found.partOf[t]].closed = false;
    }
  }
  return found;
}

std::vector<std::pair<const RidgeChain*, Id>> EndsAtUmbilics(
  const RidgePicture& picture, const WholeRidge& ridge)
{
  std::vector<std::pair<const RidgeChain*, Id>> ends;
  for (const RidgeChain& chain : ridge.chains)
  {
    for (const Id end : { chain.points.front(), chain.points.back() })
    {
      if (!chain.closed && picture.points[end].IsUmbilic())
      {
        ends.emplace_back(&chain, end);
      }
    }
  }
  return ends;
}

} // namespace

CoherenceCheck CheckIndexSum(const RidgePicture& picture)
{
  CoherenceCheck check(CheckKind::IndexSum, OffenderKind::Triangle);
  const TriangleMesh& mesh = *picture.mesh;
  Parts parts = FindParts(mesh);
  for (const PictureUmbilic& umbilic : picture.umbilics)
  {
    if (umbilic.triangle >= 0)
    {
      parts.parts[parts.partOf[umbilic.triangle]].indexSum += umbilic.index;
    }
  }
  IndexSums sums;
  sums.parts = parts.parts.size();
  for (const Part& part : parts.parts)
  {
    if (part.closed)
    {
      ++sums.closedParts;
      sums.characteristic += part.characteristic;
      sums.index += part.indexSum;
      if (std::lround(2.0 * part.indexSum) != 2L * part.characteristic)
      {
        check.offenders.push_back({ { part.triangle, -1 }, mesh.Centroid(part.triangle) });
      }
    }
  }
  check.applies = sums.closedParts > 0;
  check.numbers = sums;
  return check;
}

CoherenceCheck CheckRidgesAtUmbilics(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges)
{
  CoherenceCheck check(CheckKind::RidgesAtUmbilics, OffenderKind::Umbilic);
  std::map<Id, std::array<int, 2>> counts;
  for (const WholeRidge& ridge : ridges)
  {
    for (const auto& end : EndsAtUmbilics(picture, ridge))
    {
      ++counts[picture.points[end.second].umbilic][ridge.color == Color::Blue ? 0 : 1];
    }
  }
  RidgeCounts first;
  first.umbilics = picture.umbilics.size();
  for (const PictureUmbilic& umbilic : picture.umbilics)
  {
    const std::array<int, 2> count = counts[umbilic.id];
    const bool known = umbilic.ridgeCount == 1 || umbilic.ridgeCount == 3;
    if (!known || !HasItsRidges(picture, umbilic, count))
    {
      if (check.offenders.empty())
      {
        first = { first.umbilics, count[0], count[1], umbilic.ridgeCount };
      }
      check.offenders.push_back({ { umbilic.id, -1 }, umbilic.position });
    }
  }
  check.applies = !picture.umbilics.empty();
  check.numbers = first;
  return check;
}

CoherenceCheck CheckTypesAtUmbilics(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges)
{
  CoherenceCheck check(CheckKind::TypesAtUmbilics, OffenderKind::Ridge);
  std::size_t ends = 0;
  for (const WholeRidge& ridge : ridges)
  {
    for (const auto& end : EndsAtUmbilics(picture, ridge))
    {
      const RidgeChain& chain = *end.first;
      ++ends;
      // A ridge from an umbilic to itself has the same point at both ends, which is looked at for
      // each of them.
      const bool good =
        (chain.points.front() != end.second || chain.types.front() == TypeOf(ridge.color, false)) &&
        (chain.points.back() != end.second || chain.types.back() == TypeOf(ridge.color, false));
      if (!good && (check.offenders.empty() || check.offenders.back().ids[0] != ridge.id))
      {
        check.offenders.push_back({ { ridge.id, -1 }, picture.points[end.second].position });
      }
    }
  }
  check.applies = ends > 0;
  check.numbers = ends;
  return check;
}

CoherenceCheck CheckUmbilicsPerTriangle(const RidgePicture& picture)
{
  CoherenceCheck check(CheckKind::UmbilicsPerTriangle, OffenderKind::Triangle);
  std::map<Id, std::size_t> counts;
  for (const PictureUmbilic& umbilic : picture.umbilics)
  {
    if (umbilic.triangle >= 0)
    {
      ++counts[umbilic.triangle];
    }
  }
  std::size_t most = 0;
  for (const auto& [triangle, count] : counts)
  {
    most = std::max(most, count);
    if (count > 1)
    {
      check.offenders.push_back({ { triangle, -1 }, picture.mesh->Centroid(triangle) });
    }
  }
  check.applies = !picture.umbilics.empty();
  check.numbers = most;
  return check;
}

} // namespace ridges
