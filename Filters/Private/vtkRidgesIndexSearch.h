// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesIndexSearch_h
#define vtkRidgesIndexSearch_h

#include "Core/Umbilics/IndexCharge.h"
#include "vtkRidgesCompatibility.h"

#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

class vtkRidgesMongeInput;
class vtkRidgesUmbilicOutput;

/**
 * Finds umbilics from the index of every triangle, private to the module. What it is given has to
 * outlive it.
 */
class vtkRidgesIndexSearch
{
public:
  /// The mesh is that of the input, though its triangles may be turned around.
  vtkRidgesIndexSearch(
    const ridges::TriangleMesh& mesh, const vtkRidgesMongeInput& monge, double significance);

  /// Computes the indices: all, or those that a cheap test does not spare. False if the user
  /// aborted the filter, whose progress runs from `from` to `to`.
  bool Run(vtkAlgorithm* filter, bool all, double from, double to);

  /// Twice the sum of the indices.
  int HalfTurns() const;

  /// The umbilics, once the indices are known. False if the user aborted the filter.
  bool Gather(
    vtkAlgorithm* filter, double patchSize, double from, double to, vtkRidgesUmbilicOutput& found);

private:
  const ridges::TriangleMesh& Mesh;
  const vtkRidgesMongeInput& Monge;
  const std::uint8_t* Usable = nullptr; ///< Null if all points are.
  double Significance;
  std::vector<ridges::IndexCharge> Charges;
  std::vector<std::uint8_t> IsWeak;
};

#endif
