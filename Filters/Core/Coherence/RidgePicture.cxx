// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Coherence/RidgePicture.h"

#include <algorithm>

namespace ridges
{

bool HasItsRidges(
  const RidgePicture& picture, const PictureUmbilic& umbilic, const std::array<int, 2>& counts)
{
  const auto isRight = [&picture, &umbilic](Color color, int count)
  {
    return count == umbilic.ridgeCount || (count == 0 && picture.IsInZone(color, umbilic.triangle));
  };
  return isRight(Color::Blue, counts[0]) && isRight(Color::Red, counts[1]);
}

Id FindEdge(const TriangleMesh& mesh, Id p, Id q)
{
  if (p < 0 || q < 0 || p >= mesh.NumberOfPoints() || q >= mesh.NumberOfPoints())
  {
    return PicturePoint::NoEdge;
  }
  for (const Id t : mesh.TrianglesAround(p))
  {
    for (int side = 0; side < 3; ++side)
    {
      const Edge& edge = mesh.EdgeAt(mesh.EdgeOf(t, side));
      if (edge.v0 == std::min(p, q) && edge.v1 == std::max(p, q))
      {
        return mesh.EdgeOf(t, side);
      }
    }
  }
  return PicturePoint::NoEdge;
}

namespace
{

/// Calls visit(triangle) for those at an edge.
template <typename Visit>
void ForTrianglesAt(const TriangleMesh& mesh, Id edge, Visit visit)
{
  const Edge& ends = mesh.EdgeAt(edge);
  if (ends.t1 >= 0 || ends.t1 == TriangleMesh::Border)
  {
    visit(ends.t0);
    if (ends.t1 >= 0)
    {
      visit(ends.t1);
    }
    return;
  }
  for (const Id t : mesh.TrianglesAround(ends.v0))
  {
    if (mesh.EdgeOf(t, 0) == edge || mesh.EdgeOf(t, 1) == edge || mesh.EdgeOf(t, 2) == edge)
    {
      visit(t);
    }
  }
}

} // namespace

std::vector<Id> TrianglesAt(const TriangleMesh& mesh, Id edge)
{
  std::vector<Id> triangles;
  ForTrianglesAt(mesh, edge, [&triangles](Id t) { triangles.push_back(t); });
  return triangles;
}

int RidgePicture::UsableSides(Id edge) const
{
  int count = 0;
  ForTrianglesAt(*this->mesh, edge, [this, &count](Id t) { count += this->isUsable[t]; });
  return count;
}

bool RidgePicture::IsOutside(Id edge) const
{
  int sides = 0;
  bool isOutside = false;
  std::int64_t first = -1;
  ForTrianglesAt(*this->mesh, edge,
    [this, &sides, &isOutside, &first](Id t)
    {
      if (this->isUsable[t])
      {
        const std::int64_t region = this->RegionOf(t);
        isOutside = isOutside || region < 0 || (sides > 0 && region != first);
        first = region;
        ++sides;
      }
    });
  return sides == 2 ? isOutside : sides > 0;
}

const PictureUmbilic* RidgePicture::UmbilicOf(Id id) const
{
  // Ids are mostly places.
  if (id >= 0 && id < static_cast<Id>(this->umbilics.size()) && this->umbilics[id].id == id)
  {
    return &this->umbilics[id];
  }
  const auto found = std::find_if(this->umbilics.begin(), this->umbilics.end(),
    [id](const PictureUmbilic& umbilic) { return umbilic.id == id; });
  return found == this->umbilics.end() ? nullptr : &*found;
}

} // namespace ridges
