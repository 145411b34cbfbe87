// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_FitErrors_h
#define ridges_FitErrors_h

#include "Mesh/TriangleMesh.h"
#include "Monge/MongeField.h"

namespace ridges
{

/// What is known of the errors of the fits, in arrays by point that the caller keeps. The standard
/// errors are used if they are there, else the residual and scale of the fits, else nothing is.
struct FitErrorSource
{
  const double* maximumCurvatureError = nullptr;
  const double* minimumCurvatureError = nullptr;
  const double* thirdOrderError = nullptr; ///< 4 values a point.
  const double* fitResidual = nullptr;     ///< rms of the heights left over, per fitting radius.
  const double* fitScale = nullptr;        ///< The fitting radius.
  const double* noiseGain = nullptr;       ///< Of the fits: see JetFit.

  /// Of heights, by the rounding of coordinates: residuals may not show it. It counts in the error
  /// of k1 - k2.
  double rounding = 0.0;
};

/**
 * Standard error of k1 - k2 at a point. From the residual it is an estimate: the residuals around
 * the point are averaged, as one of them says little with as few points as a fit has.
 */
double GapError(const TriangleMesh& mesh, const FitErrorSource& source, Id point);

/// Standard error of b0 (blue) or b3 (red) at a point, in the same way.
double ExtremalityError(
  const TriangleMesh& mesh, const FitErrorSource& source, Color color, Id point);

/// Whether the fit says that the surface turns by clearly less than 60 degrees within its radius:
/// then the triangles around the point need not be asked (see TamePoint.h).
bool IsGentle(const MongeField& field, const FitErrorSource& source, Id point);

/// A cheap test whether k1 - k2 at a point may be within `significance` standard errors of 0: not
/// where the point's own residual, four times as large, would not do.
bool MayBeWeak(
  const MongeField& field, const FitErrorSource& source, double significance, Id point);

/// Whether k1 - k2, as the mean over the corners, is within `significance` standard errors of 0.
bool IsWeak(const TriangleMesh& mesh, const MongeField& field, const double* gapErrors,
  double significance, Id triangle);

/// The same where standard errors are known, of the corners of a triangle.
bool IsWeakByStandardErrors(
  const MongeField& field, const FitErrorSource& source, double significance, const Triangle& c);

} // namespace ridges

#endif
