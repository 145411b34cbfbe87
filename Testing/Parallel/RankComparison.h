// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Umbilics and ridges on all ranks against those of one.

#ifndef RankComparison_h
#define RankComparison_h

#include "ParallelTestTools.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkRidgesAndUmbilics;

namespace ridges
{
namespace testing
{

using RidgeSettings = std::function<void(vtkRidgesAndUmbilics*)>;

inline void SetNone(vtkRidgesAndUmbilics*) {}

struct ExpectedRidges
{
  vtkSmartPointer<vtkPolyData> ridges;
  vtkSmartPointer<vtkPolyData> umbilics;
  vtkSmartPointer<vtkPolyData> mesh;
  std::string warnings; ///< On rank 0.
};

/// What the serial filter finds, on all ranks.
ExpectedRidges RidgesOnOneRank(const Mesh& mesh, const RidgeSettings& set = SetNone);

/// That all ranks together find the same, byte for byte, but for ids of points and triangles, which
/// are compared by the names that these have in the whole mesh.
void ExpectTheSameRidges(
  const ExpectedRidges& expected, const RankPiece& own, const RidgeSettings& set = SetNone);

} // namespace testing
} // namespace ridges

#endif
