// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CoordinateGrain_h
#define CoordinateGrain_h

#include "Reading/PolygonMesh.h"

#include <string>

namespace program
{

struct GrainWarning
{
  std::string text; ///< Empty: all is well.
  std::string advice;
};

/// A warning if coordinates that were stored in single precision, or with few decimals, are too
/// coarse for the edges of the mesh. Then ridges show the rounding rather than the surface. Also if
/// coordinates far from the origin are fine in double precision only.
GrainWarning WarnOfGrain(const PolygonMesh& mesh);

} // namespace program

#endif
