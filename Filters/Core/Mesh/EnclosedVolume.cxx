// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/EnclosedVolume.h"

namespace ridges
{

bool IsInsideOut(const TriangleMesh& mesh)
{
  if (mesh.NumberOfTriangles() == 0 || mesh.NumberOfInconsistentEdges() > 0)
  {
    return false;
  }
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    if (mesh.EdgeAt(e).t1 < 0)
    {
      return false;
    }
  }
  // Relative to a point of the surface, so that nothing is lost far from the origin.
  const Eigen::Vector3d apex = mesh.Point(mesh.Corners(0)[0]);
  double volume = 0.0;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    volume += mesh.AreaNormal(t).dot(mesh.Point(mesh.Corners(t)[0]) - apex);
  }
  return volume < 0.0;
}

} // namespace ridges
