// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesFormArrays_h
#define vtkRidgesFormArrays_h

#include "Core/Base/Ranks.h"
#include "Core/Base/Types.h"
#include "vtkRidgesCompatibility.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPointData;
VTK_ABI_NAMESPACE_END

/**
 * Arrays of Monge forms that are being written, a tuple for each point, as memory; private to the
 * module. Those of an earlier fit, of which none may be left, are taken out as these are added.
 */
class vtkRidgesFormArrays
{
public:
  /// The values of other points, of the same order: their first is stored as that of ids[0].
  void StoreAll(const vtkRidgesFormArrays& others, const std::vector<ridges::Id>& ids);

  /// Appends the values of some points, one array after the other.
  void PackRows(ridges::Bytes& bytes, const std::vector<ridges::Id>& rows) const;

  /// Values of the same arrays, as they were packed, become those of these points.
  void StoreRows(const char* packed, const std::vector<ridges::Id>& ids);

  void AddTo(vtkPointData* pointData);

  vtkIntArray* GetStatus() { return this->StatusArray; }

protected:
  /// If it is wanted, `values` becomes the array's memory in Allocate; else null. The components
  /// may have names: "b0", "b1".
  void Add(double*& values, const char* name, int components, bool wanted = true,
    const char* componentPrefix = nullptr);
  void Allocate(vtkIdType count);

  int* Status = nullptr;

private:
  std::vector<vtkSmartPointer<vtkDoubleArray>> Arrays;
  std::vector<double**> Values; ///< Where the memory of each array is to be told.
  vtkNew<vtkIntArray> StatusArray;
};

#endif
