// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesUmbilicInput_h
#define vtkRidgesUmbilicInput_h

#include "vtkRidgesCompatibility.h"

#include "vtkType.h"

#include <Eigen/Core>

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * Reads the arrays of umbilics and their patches that vtkUmbilicDetection writes, on a mesh or on
 * vertices; private to the module. All else that needs umbilics takes them from here.
 */
class vtkRidgesUmbilicInput
{
public:
  struct Umbilic
  {
    vtkIdType id = -1;
    vtkIdType cell = -1; ///< The triangle where it lies, or -1.
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double index = 0.0;  ///< 0 where the array is missing.
    int ridgeCount = -1; ///< Or -1.
  };

  /// Those of the field data of a mesh.
  void FetchFromMesh(vtkPolyData* mesh);

  /// Those of a vertex each.
  void FetchFromVertices(vtkPolyData* vertices);

  const std::vector<Umbilic>& GetUmbilics() const { return this->Umbilics; }

  /// The arrays that the last call has not found. Without the index there are umbilics all the
  /// same, but without any of the others there are none.
  const std::string& GetFaults() const { return this->Faults; }

private:
  struct Arrays
  {
    vtkDataArray* id = nullptr;
    vtkDataArray* cell = nullptr;
    vtkDataArray* position = nullptr;
    vtkDataArray* index = nullptr;
    vtkDataArray* ridgeCount = nullptr;
  };
  void Read(const Arrays& arrays, vtkIdType count);

  std::vector<Umbilic> Umbilics;
  std::string Faults;
};

/// A cell array of numbers of regions, UmbilicPatch or CancelledUmbilics, that may be missing.
class vtkRidgesRegions
{
public:
  vtkRidgesRegions(vtkPolyData* mesh, const char* array);

  bool AreThere() const { return this->Array != nullptr; }

  /// The region that a cell is in, or -1.
  vtkIdType At(vtkIdType cell) const;

private:
  vtkDataArray* Array = nullptr;
  const vtkIdType* Values = nullptr; ///< Of an array of ids, for speed.
};

#endif
