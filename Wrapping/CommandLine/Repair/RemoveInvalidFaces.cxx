// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/RemoveInvalidFaces.h"

#include <algorithm>
#include <cmath>

namespace program
{
namespace
{

bool IsFinite(const PolygonMesh::Point& point)
{
  return std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); });
}

bool HasRepeatedCorner(const Face& face)
{
  for (std::size_t i = 0; i < face.size(); ++i)
  {
    if (face[i] == face.Next(i))
    {
      return true;
    }
  }
  return false;
}

} // namespace

InvalidFaces RemoveInvalidFaces(PolygonMesh& mesh)
{
  InvalidFaces invalid;
  std::vector<bool> isFinite(mesh.points.size());
  std::transform(mesh.points.begin(), mesh.points.end(), isFinite.begin(), IsFinite);
  const auto isGood = [&isFinite](vtkIdType corner)
  { return isFinite[static_cast<std::size_t>(corner)]; };

  PolygonMesh valid;
  valid.corners.reserve(mesh.corners.size());
  valid.faceEnds.reserve(mesh.faceEnds.size());
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const Face face = mesh.FaceAt(f);
    if (!std::all_of(face.begin(), face.end(), isGood))
    {
      ++invalid.notFinite;
      continue;
    }
    const std::size_t facesBefore = valid.NumberOfFaces();
    if (!HasRepeatedCorner(face))
    {
      valid.corners.insert(valid.corners.end(), face.begin(), face.end());
    }
    else
    {
      for (std::size_t i = 0; i < face.size(); ++i)
      {
        if (face[i] != face.Next(i))
        {
          valid.corners.push_back(face[i]);
        }
      }
    }
    valid.EndFace();
    invalid.collapsed += valid.NumberOfFaces() == facesBefore ? 1 : 0;
  }
  mesh.corners = std::move(valid.corners);
  mesh.faceEnds = std::move(valid.faceEnds);
  return invalid;
}

} // namespace program
