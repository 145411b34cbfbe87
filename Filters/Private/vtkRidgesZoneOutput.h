// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesZoneOutput_h
#define vtkRidgesZoneOutput_h

#include "vtkRidgesZoneSearch.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

class vtkRidgesMesh;

/**
 * The zones that vtkRidgeExtraction has found, and the arrays that mark them, private to the
 * module.
 */
class vtkRidgesZoneOutput
{
public:
  vtkRidgesZones maximum;
  vtkRidgesZones minimum;

  /// The mesh with RidgeZone, numbered through both curvatures, and NumberOfRidgeZones.
  void MarkOnMesh(const vtkRidgesMesh& mesh, vtkPolyData* output) const;

  void StoreNumber(vtkPolyData* output) const;

  /// What was left out, and why; empty if nothing was.
  std::string Warning() const;

private:
  std::size_t NumberOfZones() const;
};

#endif
