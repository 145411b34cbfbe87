// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_ExactSurface_h
#define ridges_ExactSurface_h

#include "Formula/JetFunction.h"
#include "Monge/MongeForm.h"

#include <Eigen/Core>

#include <array>

namespace ridges
{

/// Why there is no Monge form at a point.
enum class ExactFault
{
  None,
  NotFinite,     ///< The function or one of its derivatives is not.
  NoConvergence, ///< No point of the surface was found from there.
  Singular       ///< The surface has no normal.
};

/// As many points as are computed with at once.
struct SurfacePoints
{
  int count = 0;
  std::array<Eigen::Vector3d, Lanes::Count> position;
  std::array<Eigen::Vector2d, Lanes::Count> parameters; ///< Of parametric surfaces.
  std::array<Eigen::Vector3d, Lanes::Count> normal;
  std::array<MongeForm, Lanes::Count> form;
  std::array<double, Lanes::Count> steepness{}; ///< Of f, per length, if the surface is f = 0.
  std::array<ExactFault, Lanes::Count> fault{};
};

/// A surface of which the Monge forms are known exactly, to order 4.
class ExactSurface
{
public:
  ExactSurface() = default;
  virtual ~ExactSurface() = default;
  ExactSurface(const ExactSurface&) = delete;
  ExactSurface& operator=(const ExactSurface&) = delete;

  /// Moves points to the surface, and gives them normals or a fault. Those with a fault stay.
  virtual void Locate(SurfacePoints& points) const = 0;

  /// The Monge forms at points that have been located, with these normals; or a fault.
  virtual void Differentiate(SurfacePoints& points) const = 0;
};

/**
 * f = 0. Points move along the gradient by Newton's method, whose steps are halved while |f| does
 * not fall, until they are as close to the surface as the precision of their coordinates allows.
 * Normals point along the gradient.
 */
class ImplicitExactSurface : public ExactSurface
{
public:
  explicit ImplicitExactSurface(const JetFunction& function)
    : Function_(function)
  {
  }

  void Locate(SurfacePoints& points) const override;
  void Differentiate(SurfacePoints& points) const override;

private:
  const JetFunction& Function_;
};

/// r(u, v), at given parameters; the normal is that of dr/du x dr/dv.
class ParametricExactSurface : public ExactSurface
{
public:
  explicit ParametricExactSurface(const std::array<FormulaProgram, 3>& r)
    : R_(r)
  {
  }

  void Locate(SurfacePoints& points) const override;
  void Differentiate(SurfacePoints& points) const override;

private:
  const std::array<FormulaProgram, 3>& R_;
};

} // namespace ridges

#endif
