// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/RepairMesh.h"

namespace program
{

RepairReport RepairMesh(PolygonMesh& mesh, const RepairOptions& options)
{
  RepairReport report;
  report.removed = RemoveInvalidFaces(mesh);
  report.joinedPoints = JoinPoints(mesh, options.joining);
  if (options.orient)
  {
    report.orientation = OrientFaces(mesh);
  }
  return report;
}

} // namespace program
