// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_TriangleContent_h
#define ridges_TriangleContent_h

#include "Fit/FitErrors.h"
#include "Mesh/Triangle.h"
#include "Monge/MongeField.h"

#include <vector>

namespace ridges
{

/// What may be in a triangle.
enum class TriangleContent : std::uint8_t
{
  Nothing,
  Ridge,
  Umbilic ///< It turns, or k1 - k2 is not significant there.
};

/**
 * Finds the triangles in which there is certainly nothing, whatever lies around them, by what is
 * known at their corners. Elsewhere there may be nothing, either: DirectionIndex, which looks
 * around the corners, and IsWeak decide.
 */
class TriangleContents
{
public:
  /// `significance` is that of IsWeak.
  TriangleContents(
    const MongeField& field, const FitErrorSource& errors, double significance, Id numberOfPoints);

  TriangleContent At(const Triangle& corners) const;

private:
  MongeField Field_;
  FitErrorSource Errors_;
  double Significance_;
  std::vector<std::uint8_t> IsPlain_; ///< Points at which nothing can be weak or turn.
};

} // namespace ridges

#endif
