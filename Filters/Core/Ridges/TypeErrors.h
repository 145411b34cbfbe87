// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_TypeErrors_h
#define ridges_TypeErrors_h

#include "Fit/FitErrors.h"
#include "Monge/MongeField.h"
#include "Ridges/RidgeTrace.h"

#include <array>
#include <unordered_map>
#include <vector>

namespace ridges
{

/**
 * How certain the types of ridges are. P has a standard error, from the heights that the fits
 * around a point leave over and from what a fit magnifies noise by. And P over k1 - k2 is the
 * derivative of the extremality along its direction, so that the slope of b0 (b3) from point to
 * point is a second opinion about its sign.
 */
class TypeErrors
{
public:
  /// What it is given has to outlive it.
  TypeErrors(const TriangleMesh& mesh, const MongeField& field, const FitErrorSource& errors);

  /// The standard error of P at a point; 0 where nothing is known of fits.
  double ErrorAt(Color color, Id p) const;

  /// k1 - k2 times the slope of the extremality, with the sign that P has.
  double SlopeAt(Color color, Id p) const;

  /// At the vertices of a ridge: between the ends of their edges; of other vertices, those of the
  /// vertex before or else after.
  std::vector<double> ErrorsOf(const RidgeTrace& trace) const;
  std::vector<double> SlopesOf(const RidgeTrace& trace) const;
  /// Radii of the fits, 0 where they are not known.
  std::vector<double> ScalesOf(const RidgeTrace& trace) const;

private:
  /// Of one color.
  struct Values
  {
    double error = 0.0;
    double slope = 0.0;
  };

  double FindError(Color color, Id p) const;
  double FindSlope(Color color, Id p) const;
  const Values* AtHub(Color color, Id p) const;

  template <typename AtPoint>
  std::vector<double> Along(const RidgeTrace& trace, const AtPoint& atPoint) const;

  const TriangleMesh& Mesh_;
  const MongeField& Field_;
  const FitErrorSource& Errors_;
  /// Found once at points of so many triangles that ridges may pass them thousands of times.
  std::unordered_map<Id, std::array<Values, 2>> Hubs_;
};

} // namespace ridges

#endif
