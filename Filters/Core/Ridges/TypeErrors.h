// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_TypeErrors_h
#define ridges_TypeErrors_h

#include "Base/Buffer.h"
#include "Fit/FitErrors.h"
#include "Monge/MongeField.h"
#include "Ridges/RidgeTrace.h"

#include <array>
#include <cstddef>
#include <cstdint>
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

  /// What is asked for has to be required first, and then found at all points. Ranges of points may
  /// be done at the same time.
  void Require(Color color, Id p);
  void Require(const RidgeTrace& trace);
  void Find(Id begin, Id end);

  /// The standard error of P at a point; 0 where nothing is known of fits.
  double ErrorAt(Color color, Id p) const { return this->OfColor(color).values[p].error; }

  /// k1 - k2 times the slope of the extremality, with the sign that P has.
  double SlopeAt(Color color, Id p) const { return this->OfColor(color).values[p].slope; }

  /// At the vertices of a ridge: between the ends of their edges; of other vertices, those of the
  /// vertex before or else after.
  std::vector<double> ErrorsOf(const RidgeTrace& trace) const;
  std::vector<double> SlopesOf(const RidgeTrace& trace) const;
  /// Radii of the fits, 0 where they are not known.
  std::vector<double> ScalesOf(const RidgeTrace& trace) const;

private:
  struct Values
  {
    double error;
    double slope;
  };
  /// Of points; no memory before any is required.
  struct PointValues
  {
    Buffer<Values> values;
    std::vector<std::uint8_t> isRequired;
  };

  static std::size_t IndexOf(Color color) { return color == Color::Blue ? 0 : 1; }
  const PointValues& OfColor(Color color) const { return this->Colors_[IndexOf(color)]; }
  double FindError(Color color, Id p) const;
  double FindSlope(Color color, Id p) const;

  template <typename AtPoint>
  std::vector<double> Along(const RidgeTrace& trace, const AtPoint& atPoint) const;

  const TriangleMesh& Mesh_;
  const MongeField& Field_;
  const FitErrorSource& Errors_;
  std::array<PointValues, 2> Colors_;
};

} // namespace ridges

#endif
