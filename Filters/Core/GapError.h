// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_GapError_h
#define ridges_GapError_h

#include "AcuteRule.h"

namespace ridges
{

/// What is known of the error of k1 - k2, in arrays by point that the caller keeps. The standard
/// errors are used if they are there, else the residual and scale of the fits, else nothing is.
struct GapErrorSource
{
  const double* maximumCurvatureError = nullptr;
  const double* minimumCurvatureError = nullptr;
  const double* fitResidual = nullptr; ///< rms of the heights left over, per fitting radius.
  const double* fitScale = nullptr;    ///< The fitting radius.
};

/**
 * Standard error of k1 - k2 at a point. From the residual it is an estimate: the residuals around
 * the point are averaged, as one of them says little with as few points as a fit has.
 */
double GapError(const TriangleMesh& mesh, const GapErrorSource& source, Id point);

/// Whether k1 - k2, as the mean over the corners, is within `significance` standard errors of 0.
bool IsWeak(const TriangleMesh& mesh, const MongeField& field, const double* gapErrors,
  double significance, Id triangle);

} // namespace ridges

#endif
