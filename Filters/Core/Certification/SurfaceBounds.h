// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SurfaceBounds_h
#define ridges_SurfaceBounds_h

#include "Certification/Interval.h"
#include "Formula/JetFunction.h"

#include <Eigen/Core>

#include <array>

namespace ridges
{

using IntervalVector = std::array<Interval, 3>;

/// Coordinates u, v, w around a point. The origin may be known up to an interval only.
struct LocalFrame
{
  IntervalVector origin;
  Eigen::Matrix3d axes; ///< Orthonormal columns, up to round-off.
};

/// The Taylor polynomial of f at the origin of a frame, and one whose coefficients are intervals
/// that contain those at all points of a box around it.
struct JetBounds
{
  Taylor3<4, Interval> atOrigin;
  Taylor3<4, Interval> inBox;
};

/// A function f of which the derivatives to order 4 are known at points, and bounded in boxes. If
/// it is reversed it is -f: normals and colours are those of the surface's other side.
class SurfaceBounds
{
public:
  explicit SurfaceBounds(bool isReversed)
    : Sign_(isReversed ? -1.0 : 1.0)
  {
  }
  virtual ~SurfaceBounds() = default;
  SurfaceBounds(const SurfaceBounds&) = delete;
  SurfaceBounds& operator=(const SurfaceBounds&) = delete;

  /// At a point, by x, y and z.
  virtual Taylor3<4> At(const Eigen::Vector3d& x) const = 0;
  /// The same to second order, and faster.
  virtual Taylor3<2> CurvatureAt(const Eigen::Vector3d& x) const = 0;

  /// In a box of u, v and w around the origin, by these.
  JetBounds In(const LocalFrame& frame, const IntervalVector& box) const;

protected:
  /// At the origin, and the terms of degree 4 anywhere in the box.
  virtual JetBounds Raw(const LocalFrame& frame, const IntervalVector& box) const = 0;

  double Sign() const { return this->Sign_; }

private:
  double Sign_;
};

/// PROVED: the formula in interval arithmetic.
class IntervalBounds : public SurfaceBounds
{
public:
  explicit IntervalBounds(const FormulaFunction& function, bool isReversed = false)
    : SurfaceBounds(isReversed)
    , Function_(function)
  {
  }
  Taylor3<4> At(const Eigen::Vector3d& x) const override;
  Taylor3<2> CurvatureAt(const Eigen::Vector3d& x) const override;

protected:
  JetBounds Raw(const LocalFrame& frame, const IntervalVector& box) const override;

private:
  const FormulaFunction& Function_;
};

/**
 * CHECKED: the derivatives of order 4 are evaluated at the origin, at four corners and at the lids
 * of a box, and are assumed not to leave the range of these values by more than its length. All
 * bounds of lower order follow from that.
 */
class SampledBounds : public SurfaceBounds
{
public:
  explicit SampledBounds(const JetFunction& function, bool isReversed = false)
    : SurfaceBounds(isReversed)
    , Function_(function)
  {
  }
  Taylor3<4> At(const Eigen::Vector3d& x) const override;
  Taylor3<2> CurvatureAt(const Eigen::Vector3d& x) const override;

protected:
  JetBounds Raw(const LocalFrame& frame, const IntervalVector& box) const override;

private:
  const JetFunction& Function_;
};

} // namespace ridges

#endif
