// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesUmbilicMarks_h
#define vtkRidgesUmbilicMarks_h

#include "Core/Ridges/Patch/PatchRidges.h"
#include "vtkRidgesCompatibility.h"
#include "vtkRidgesUmbilicInput.h"

#include "vtkType.h"

#include <unordered_map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

class vtkRidgesMesh;

/**
 * The umbilics that vtkUmbilicDetection has marked on a mesh, if it has, private to the module.
 */
class vtkRidgesUmbilicMarks
{
public:
  explicit vtkRidgesUmbilicMarks(const vtkRidgesMesh& mesh);

  /// Removes the marks from the output of a filter, whose Monge arrays they do not belong to.
  static void RemoveFrom(vtkPolyData* output);

  /// Whether there are marks, even if of no umbilic.
  bool AreThere() const { return this->PatchOfCell.AreThere(); }

  const std::vector<Eigen::Vector3d>& GetPositions() const { return this->Positions; }

  /// The patches of the umbilics, and the regions where umbilics have cancelled each other.
  const std::vector<ridges::RidgePatch>& GetPatches() const { return this->Patches; }

  /// The umbilic whose triangle this is, or -1.
  vtkIdType UmbilicAt(ridges::Id triangle) const;

  /// The umbilic whose patch a triangle is in, or -1.
  vtkIdType PatchOf(ridges::Id triangle) const;

private:
  void FetchUmbilics();
  void FetchRegions(const vtkRidgesRegions& regions, std::size_t firstPatch);

  const vtkRidgesMesh& Mesh;
  vtkRidgesRegions PatchOfCell;
  std::vector<Eigen::Vector3d> Positions;
  std::vector<ridges::RidgePatch> Patches;
  std::unordered_map<vtkIdType, vtkIdType> UmbilicOfCell;
};

#endif
