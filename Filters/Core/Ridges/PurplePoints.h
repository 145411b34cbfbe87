// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PurplePoints_h
#define ridges_PurplePoints_h

#include "Ridges/RidgeTrace.h"

namespace ridges
{

/// Where a blue ridge crosses a red one.
struct PurplePoint
{
  Id triangle;
  Id blueRidge; ///< Index of the ridge.
  Id redRidge;
  Eigen::Vector3d position;
};

/**
 * The purple points of blue and red ridges, triangle by triangle: where a piece of one colour
 * between two edges crosses one of the other. Umbilics, where both colours end, are none, and
 * triangles with several pieces of a colour, as in patches, are passed over.
 */
std::vector<PurplePoint> FindPurplePoints(const TriangleMesh& mesh,
  const std::vector<RidgeTrace>& blue, const std::vector<RidgeTrace>& red);

} // namespace ridges

#endif
