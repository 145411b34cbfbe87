// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_ShapeSample_h
#define ridges_ShapeSample_h

#include "Mesh/PositionSample.h"

#include <vector>

namespace ridges
{

/**
 * As PositionSample, but the same points of a mesh that was moved, turned or scaled, but for
 * rounding: points are drawn by their distance from the centroid. Where many have the same one, as
 * on spheres and surfaces of revolution, it is a PositionSample.
 */
std::vector<Id> ShapeSample(const TriangleMesh& mesh, double wanted);

/// The same of a mesh that is shared between ranks: see PositionSample.
std::vector<DrawnPoint> ShapeSample(
  const TriangleMesh& mesh, Id count, double wanted, Ranks& ranks);

} // namespace ridges

#endif
