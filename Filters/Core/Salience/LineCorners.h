// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_LineCorners_h
#define ridges_LineCorners_h

#include "Salience/SalientSelection.h"

#include <vector>

namespace ridges
{

/// A line with what it was selected from.
struct LineOfRidge
{
  SalientLine* line;
  const RidgeTrace* ridge;
  const RidgeFolds* folds;
};

/// Where ends of lines may meet. Lengths are in the unit of the points, angles in radians.
struct CornerRule
{
  double reach = 0.0; ///< How far an end may be from its corner.
  double angle = 0.0; ///< What the line folds by within the reach of its end.
};

/**
 * Lengthens lines to the corners where creases meet. Smoothing ends a crease one to three
 * deviations before its corner. Ends that point to one place within their reach are led to the
 * point of the mesh next to it: the place nearest to all of them, gone on straight.
 */
void MeetAtCorners(const TriangleMesh& mesh, const MongeField& field, const CornerRule& rule,
  const std::vector<LineOfRidge>& lines);

} // namespace ridges

#endif
