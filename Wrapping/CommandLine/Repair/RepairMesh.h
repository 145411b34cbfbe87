// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RepairMesh_h
#define RepairMesh_h

#include "Reading/PolygonMesh.h"
#include "Repair/JoinPoints.h"
#include "Repair/OrientFaces.h"
#include "Repair/RemoveInvalidFaces.h"

namespace program
{

struct RepairOptions
{
  Joining joining = Joining::Borders;
  bool orient = false;
};

struct RepairReport
{
  InvalidFaces removed; ///< Of the file; faces that collapse where points are joined do not count.
  std::size_t joinedPoints = 0;
  Orientation orientation;

  bool HasChanged() const
  {
    return this->removed.collapsed + this->removed.notFinite + this->joinedPoints +
      this->orientation.turnedFaces >
      0;
  }
};

/// Removes invalid faces, joins points, and orients the faces, in this order.
RepairReport RepairMesh(PolygonMesh& mesh, const RepairOptions& options);

} // namespace program

#endif
