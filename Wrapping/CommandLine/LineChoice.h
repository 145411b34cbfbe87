// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LineChoice_h
#define LineChoice_h

#include "vtkPolyData.h"

#include <string>

namespace program
{

/// Which lines of a mesh are wanted.
enum class Lines
{
  ByData,   ///< What the mesh can give: see ChooseLines.
  Complete, ///< All ridges and umbilics, as of a smooth surface.
  Salient   ///< The main feature lines, as of a scan or a part.
};

/**
 * By how much the third derivatives of a fitted mesh are uncertain, relative to themselves: the
 * value that three quarters of the points do not exceed. Noise makes them uncertain, and so does
 * what the mesh does not resolve. Infinite where nothing was fitted and on planes.
 *
 * A fit that follows nothing but noise has a cubic part that is 14 times its residual, in the
 * median over random noise, where it is largest; so the uncertainty is 14 times the residual over
 * the size of the cubic part at the rim of the neighbourhood.
 */
double ThirdOrderUncertainty(vtkPolyData* fitted);

struct LineChoice
{
  Lines lines = Lines::Complete;
  std::string reason;
};

/**
 * The complete picture if the uncertainty is at most 0.1. Meshes of smooth surfaces have 0.001 to
 * 0.06, scans and parts 0.17 and more, noise of a thousandth of an edge 0.5 and more.
 */
LineChoice ChooseLines(vtkPolyData* fitted);

} // namespace program

#endif
