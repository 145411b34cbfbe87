// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Picture_h
#define Picture_h

#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <optional>

namespace program
{

/// How a type of ridges is called and drawn. Colours are the paper's, in shades that read on grey.
struct RidgeStyle
{
  int type;                ///< Value of the RidgeType array.
  const char* name;        ///< What it is.
  const char* salientName; ///< What it is among salient lines; empty: it is not.
  const char* colorName;
  std::array<double, 3> color;
};

extern const std::array<RidgeStyle, 5> RidgeStyles;

struct PictureOptions
{
  std::array<int, 2> size{ 1600, 1200 };
  std::optional<std::array<double, 3>> view; ///< From the model to the viewer.
  std::optional<std::array<double, 3>> up;
};

/// Throws Failure if there is nothing to draw on; VTK would abort the program.
void CheckDisplay();

/// Draws the mesh, the ridges and the umbilics, with a legend. Without umbilics (null) the ridges
/// are salient lines: thicker, and called crests and valleys.
vtkSmartPointer<vtkImageData> DrawPicture(
  vtkPolyData* mesh, vtkPolyData* ridges, vtkPolyData* umbilics, const PictureOptions& options);

} // namespace program

#endif
