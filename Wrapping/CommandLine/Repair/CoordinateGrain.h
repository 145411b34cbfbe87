// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CoordinateGrain_h
#define CoordinateGrain_h

#include "Reading/PolygonMesh.h"

#include <string>

namespace program
{

/**
 * A warning if coordinates that were stored in single precision are too coarse for the edges of the
 * mesh, or nothing. Then ridges show the rounding rather than the surface.
 */
std::string WarnOfGrain(const PolygonMesh& mesh);

} // namespace program

#endif
