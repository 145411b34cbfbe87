// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Polylines of vtkRidgeExtraction by the edges they cross, in a form that does not depend on the
// numbering of the mesh.

#ifndef RidgePaths_h
#define RidgePaths_h

#include "vtkPolyData.h"

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace ridges
{
namespace testing
{

/// Edges crossed, (-1, -1) for an umbilic; the direction and the start of a loop are made unique.
using EdgePath = std::vector<std::pair<vtkIdType, vtkIdType>>;
struct PolylineValues
{
  int type = 0;
  int crest = 0;
  int closed = 0;
  double length = 0.0;
  double strength = 0.0;
  double sharpness = 0.0;
};
using RidgeMap = std::map<EdgePath, PolylineValues>;

/// The polylines by what they cross; `pointName` renames the points of the mesh.
RidgeMap RidgesByPath(
  vtkPolyData* ridges, const std::function<vtkIdType(vtkIdType)>& pointName = nullptr);

/// Equal paths, types and flags; measures equal up to a relative tolerance. Lengths are divided by
/// `scale` before.
void ExpectSameRidges(
  const RidgeMap& expected, const RidgeMap& actual, double tolerance, double scale = 1.0);

} // namespace testing
} // namespace ridges

#endif
