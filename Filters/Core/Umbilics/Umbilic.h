// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Umbilic_h
#define ridges_Umbilic_h

#include "Umbilics/UmbilicForm.h"

namespace ridges
{

/// A point where k1 = k2, and the patch of triangles that stands for its neighbourhood.
struct Umbilic
{
  Id triangle; ///< The triangle where it lies: a singular one, wherever there is one.
  Eigen::Vector3d position;
  double index;        ///< +1/2 or -1/2: turns of d1 around it.
  int ridgeCount;      ///< Ridges of each colour that meet there: 1 or 3.
  int thirdOrderIndex; ///< Sign of S (section 8.2): the sign of the index, from third order.
  UmbilicPattern pattern;
  bool touchesBorder; ///< Whether the patch does.
  std::vector<Id> patch;
  bool isNearBorder = false; ///< Whether fits there are one-sided.
};

/// The umbilic in a triangle, with all that the forms at its corners tell.
Umbilic MakeUmbilic(const TriangleMesh& mesh, const MongeField& field, Id triangle, double index,
  std::vector<Id> patch);

/// Whether an edge without a second triangle, or with too many, is among those of the patch.
bool TouchesBorder(const TriangleMesh& mesh, const std::vector<Id>& patch);

} // namespace ridges

#endif
