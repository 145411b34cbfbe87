// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The polylines of vtkRidgeExtraction put together to whole ridges.

#ifndef WholeRidges_h
#define WholeRidges_h

#include "vtkPolyData.h"

#include <set>
#include <string>
#include <vector>

namespace ridges
{
namespace testing
{

struct WholeRidge
{
  bool maximum = false; ///< Blue and green.
  bool closed = false;
  std::set<int> types;
  vtkIdType first = 0; ///< Points at its ends.
  vtkIdType last = 0;
};

/// In the order of their ids.
std::vector<WholeRidge> WholeRidges(vtkPolyData* ridges);

/// Ridges that have an end at an umbilic, counted once for each end.
int CountEndsAt(
  vtkPolyData* ridges, const std::vector<WholeRidge>& whole, vtkIdType umbilic, bool maximum);

/// Ridges that are neither closed nor end at umbilics at both ends.
int CountLooseRidges(vtkPolyData* ridges, const std::vector<WholeRidge>& whole);

/// Each umbilic has as many ends of ridges of each colour as its RidgeCount says.
void ExpectAllUmbilicsJoined(vtkPolyData* umbilics, vtkPolyData* ridges);

} // namespace testing
} // namespace ridges

#endif
