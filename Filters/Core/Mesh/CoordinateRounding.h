// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_CoordinateRounding_h
#define ridges_CoordinateRounding_h

#include "Mesh/TriangleMesh.h"

namespace ridges
{

/**
 * The largest error, as a part of a coordinate, that rounding may have caused: half a unit in the
 * last place of single precision if all coordinates are such numbers, else of double precision. On
 * regular meshes rounding repeats from row to row, so that residuals of fits may not show it.
 */
double CoordinateRounding(const TriangleMesh& mesh);

} // namespace ridges

#endif
