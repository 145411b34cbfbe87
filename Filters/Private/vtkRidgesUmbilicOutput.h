// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesUmbilicOutput_h
#define vtkRidgesUmbilicOutput_h

#include "Core/Mesh/TriangleGroups.h"
#include "Core/Umbilics/Umbilic.h"
#include "vtkRidgesCompatibility.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

class vtkRidgesMesh;

/**
 * What vtkUmbilicDetection has found, and the arrays that tell it, private to the module.
 */
class vtkRidgesUmbilicOutput
{
public:
  std::vector<ridges::Umbilic> umbilics;

  /// Outside all patches, triangles where umbilics have cancelled each other.
  ridges::TriangleGroups cancelled;

  /// Triangles where k1 - k2 is nowhere significant.
  std::vector<std::vector<ridges::Id>> zones;

  int eulerCharacteristic = 0;

  /// The mesh with the cell and field arrays that mark all this on it.
  void MarkOnMesh(const vtkRidgesMesh& mesh, vtkPolyData* output) const;

  /// A vertex per umbilic.
  void StoreVertices(const vtkRidgesMesh& mesh, vtkPolyData* output) const;
};

#endif
