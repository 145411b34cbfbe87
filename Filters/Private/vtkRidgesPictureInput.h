// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesPictureInput_h
#define vtkRidgesPictureInput_h

#include "Core/Coherence/RidgePicture.h"
#include "vtkRidgesCompatibility.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesMongeArrays.h"

#include <string>

/**
 * Mesh, umbilics and ridges as the numerics want them to check them, private to the module.
 */
class vtkRidgesPictureInput
{
public:
  /// What is wrong with the inputs, all of it, as text; empty if nothing is. Without umbilics,
  /// those of the mesh's field data are taken.
  std::string Fetch(
    vtkAlgorithm* filter, vtkPolyData* mesh, vtkPolyData* ridges, vtkPolyData* umbilics);

  const ridges::RidgePicture& GetPicture() const { return this->Picture; }
  const vtkRidgesMesh& GetMesh() const { return this->Mesh; }

private:
  void AddFaults(const std::string& faults);
  void FetchMesh(vtkAlgorithm* filter, vtkPolyData* mesh);
  void FetchUmbilics(vtkPolyData* umbilics);
  void FetchRidges(vtkPolyData* ridges);
  ridges::Id TriangleOf(vtkIdType cell) const;

  vtkRidgesMesh Mesh;
  vtkRidgesMongeArrays Arrays;
  ridges::RidgePicture Picture;
  std::vector<ridges::Id> TriangleOfCell;
  std::string Faults;
};

#endif
