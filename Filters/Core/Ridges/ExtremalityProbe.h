// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_ExtremalityProbe_h
#define ridges_ExtremalityProbe_h

#include "Fit/JetErrors.h"
#include "Fit/JetFit.h"
#include "Mesh/RingNeighborhood.h"
#include "Monge/MongeField.h"

#include <functional>
#include <vector>

namespace ridges
{

/**
 * Whether b0 or b3 is significant on a larger scale than that of the field: by fits of degree 4
 * to more rings, at a point and two rings around it. Noise falls with the scale, so that ridges
 * which it hides on the small one show; on a surface without ridges nothing does on any scale.
 *
 * Errors have the parts of ExtremalityErrors, rounding excepted, which does not matter where noise
 * is. Holds scratch memory: use one per thread.
 */
class ExtremalityProbe
{
public:
  ExtremalityProbe(const TriangleMesh& mesh, const OrderedRings& rings);

  struct Trial
  {
    bool isUsable = false; ///< Not if the surface turns within the radius of the fit.
    bool isSignificant = false;
  };
  /// Around a point with a closed fan. Significant is what exceeds so many standard errors.
  Trial Try(Id vertex, int numberOfRings, Color color, double significance);

  /// Whether all points within so many rings of one, and a ring more, are in a set.
  bool IsDeepIn(const std::function<bool(Id)>& isIn, Id vertex, int numberOfRings);

private:
  struct PointFit
  {
    MongeForm form;
    JetErrors errors;
    double radius = 0.0;
    bool isGood = false;
  };
  PointFit Fit(Id p, int numberOfRings);
  const PointFit& FitAt(Id p) const;
  bool IsSignificant(Color color, Id vertex, double significance) const;
  double Derivative(Color color, Id vertex) const;

  const TriangleMesh& Mesh_;
  const OrderedRings& Rings_;
  RingNeighborhood Neighborhood_;
  JetFitter Fitter_;
  Eigen::Matrix3Xd Offsets_;
  std::vector<Id> Points_; ///< The point tried last, and the two rings around it.
  std::vector<PointFit> Fits_;
};

} // namespace ridges

#endif
