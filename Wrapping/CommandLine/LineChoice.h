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
 * what the mesh does not resolve. Infinite where nothing was fitted and on planes. It is the
 * standard error that the residual of a fit causes in the tensor of third derivatives, over its
 * norm.
 */
double ThirdOrderUncertainty(vtkPolyData* fitted);

struct LineChoice
{
  Lines lines = Lines::Complete;
  std::string reason;
};

/**
 * The complete picture if the uncertainty is at most 0.12. With automatic fits, meshes of smooth
 * surfaces have less than 0.02, noise of a thousandth of an edge makes it 0.02 to 0.09, a hundredth
 * 0.07 to 0.2; scans and parts have 0.14 and more.
 */
LineChoice ChooseLines(vtkPolyData* fitted);

} // namespace program

#endif
