// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Legend_h
#define Legend_h

#include "View.h"

#include <array>
#include <string>
#include <vector>

class vtkRenderer;

namespace program
{

/// A row of the legend: a mark, which is a line or a dot, and what it means.
struct LegendRow
{
  std::string text;
  std::array<double, 3> color;
  bool isDot;
};

/// Adds a legend, in the corner that hides least of the points.
void AddLegend(vtkRenderer* renderer, const std::vector<LegendRow>& rows,
  const std::array<int, 2>& pictureSize, const View& view, const std::vector<Vector3>& points);

} // namespace program

#endif
