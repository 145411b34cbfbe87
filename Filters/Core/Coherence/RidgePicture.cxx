// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Coherence/RidgePicture.h"

#include <algorithm>

namespace ridges
{

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

std::vector<Id> TrianglesAt(const TriangleMesh& mesh, Id edge)
{
  const Edge& ends = mesh.EdgeAt(edge);
  if (ends.t1 >= 0)
  {
    return { ends.t0, ends.t1 };
  }
  if (ends.t1 == TriangleMesh::Border)
  {
    return { ends.t0 };
  }
  std::vector<Id> triangles;
  for (const Id t : mesh.TrianglesAround(ends.v0))
  {
    if (mesh.EdgeOf(t, 0) == edge || mesh.EdgeOf(t, 1) == edge || mesh.EdgeOf(t, 2) == edge)
    {
      triangles.push_back(t);
    }
  }
  return triangles;
}

int RidgePicture::UsableSides(Id edge) const
{
  int count = 0;
  for (const Id t : TrianglesAt(*this->mesh, edge))
  {
    count += this->isUsable[t];
  }
  return count;
}

bool RidgePicture::IsOutside(Id edge) const
{
  const int sides = this->UsableSides(edge);
  if (sides != 2)
  {
    return sides > 0;
  }
  std::int64_t first = -1;
  for (const Id t : TrianglesAt(*this->mesh, edge))
  {
    const std::int64_t region = this->RegionOf(t);
    if (this->isUsable[t] && (region < 0 || (first >= 0 && region != first)))
    {
      return true;
    }
    first = this->isUsable[t] ? region : first;
  }
  return false;
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
