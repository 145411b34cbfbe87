// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/Umbilic.h"

#include <utility>

namespace ridges
{

bool TouchesBorder(const TriangleMesh& mesh, const std::vector<Id>& patch)
{
  for (const Id t : patch)
  {
    for (int side = 0; side < 3; ++side)
    {
      if (mesh.Neighbor(t, side) < 0)
      {
        return true;
      }
    }
  }
  return false;
}

Umbilic MakeUmbilic(const TriangleMesh& mesh, const MongeField& field, Id triangle, double index,
  std::vector<Id> patch)
{
  const Eigen::Vector3d weights = UmbilicWeights(mesh, field, triangle);
  const SymmetricTensor<3> cubicForm = CubicFormAt(mesh, field, triangle, weights);
  // Three ridges mean an index of -1/2: where third order says otherwise, directions are right.
  Umbilic umbilic;
  umbilic.triangle = triangle;
  umbilic.position = UmbilicInTriangle(mesh, field, triangle);
  umbilic.index = index;
  umbilic.ridgeCount = index > 0.0 ? 1 : RidgeCountOf(cubicForm);
  umbilic.thirdOrderIndex = ThirdOrderIndexOf(cubicForm);
  umbilic.pattern = PatternOf(cubicForm, index);
  umbilic.touchesBorder = TouchesBorder(mesh, patch);
  umbilic.patch = std::move(patch);
  return umbilic;
}

} // namespace ridges
