// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/ExactSurface.h"

#include "Formula/ImplicitHeight.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ridges
{
namespace
{

constexpr int MaximumSteps = 60;

/// How far apart numbers like the coordinates of a point are.
double Resolution(const Eigen::Vector3d& position)
{
  return std::numeric_limits<double>::epsilon() * position.cwiseAbs().maxCoeff();
}

/// Lanes without a point of their own repeat the first.
LaneVector3 Positions(const SurfacePoints& points)
{
  LaneVector3 x;
  for (int lane = 0; lane < Lanes::Count; ++lane)
  {
    const Eigen::Vector3d& position = points.position[lane < points.count ? lane : 0];
    for (int i = 0; i < 3; ++i)
    {
      x[i][lane] = position[i];
    }
  }
  return x;
}

Taylor3<4> LaneOf(const Taylor3<4, Lanes>& jets, int lane)
{
  Taylor3<4> jet;
  for (int i = 0; i <= 4; ++i)
  {
    for (int j = 0; i + j <= 4; ++j)
    {
      for (int k = 0; i + j + k <= 4; ++k)
      {
        jet.Set(i, j, k, jets.Coefficients()[Taylor3<4>::Index(i, j, k)][lane]);
      }
    }
  }
  return jet;
}

/// Value and gradient of f at the points of the lanes.
struct Linearization
{
  std::array<double, Lanes::Count> value;
  std::array<Eigen::Vector3d, Lanes::Count> gradient;

  Linearization(const JetFunction& function, const SurfacePoints& points)
  {
    const JetFunction::Jet1 f = function.Linear(Positions(points));
    for (int lane = 0; lane < Lanes::Count; ++lane)
    {
      this->value[lane] = f.Constant()[lane];
      this->gradient[lane] = { f.Coefficients()[1][lane], f.Coefficients()[2][lane],
        f.Coefficients()[3][lane] };
    }
  }

  bool IsFinite(int lane) const
  {
    return std::isfinite(this->value[lane]) && this->gradient[lane].allFinite();
  }

  Eigen::Vector3d NewtonStep(int lane) const
  {
    const Eigen::Vector3d& g = this->gradient[lane];
    return g * (-this->value[lane] / g.squaredNorm());
  }
};

/// Any frame with this normal; the same for the same normal.
Eigen::Matrix3d FrameOf(const Eigen::Vector3d& normal)
{
  Eigen::Matrix3d frame;
  frame.col(0) = normal.unitOrthogonal();
  frame.col(1) = normal.cross(frame.col(0));
  frame.col(2) = normal;
  return frame;
}

std::array<Eigen::Matrix3d, Lanes::Count> FramesOf(const SurfacePoints& points)
{
  std::array<Eigen::Matrix3d, Lanes::Count> frames;
  for (int lane = 0; lane < Lanes::Count; ++lane)
  {
    const bool isGood = lane < points.count && points.fault[lane] == ExactFault::None;
    frames[lane] = isGood ? FrameOf(points.normal[lane]) : Eigen::Matrix3d::Identity();
  }
  return frames;
}

bool IsFinite(const MongeForm& form)
{
  const auto isFinite = [](double value) { return std::isfinite(value); };
  return std::isfinite(form.k1) && std::isfinite(form.k2) &&
    std::all_of(form.b.begin(), form.b.end(), isFinite) &&
    std::all_of(form.c.begin(), form.c.end(), isFinite) && std::isfinite(form.P1()) &&
    std::isfinite(form.P2());
}

/// Whether the gradient is 0 within the precision of coordinates, as on f² = 0: there its length
/// falls to that of its change over the root of what is lost to round-off.
bool IsSingular(const Taylor3<4>& f, double resolution, double size)
{
  double second = 0.0;
  for (int i = Taylor3<4>::Offset(2); i < Taylor3<4>::Offset(3); ++i)
  {
    second = std::max(second, std::abs(f.Coefficients()[i]));
  }
  return !(std::abs(f(0, 0, 1)) > std::sqrt(resolution * size) * second);
}

/// Whether what a point would still have to move is nothing beside where it is and came from.
bool IsSettled(double step, const Eigen::Vector3d& start, const Eigen::Vector3d& end)
{
  constexpr double enough = 1e-10;
  const double moved = (end - start).norm();
  return step <=
    std::max(enough * std::max(end.cwiseAbs().maxCoeff(), moved), 64.0 * Resolution(end));
}

/// Whether a point is on the surface as well as the curvature there lets one see.
bool IsClose(double distance, const MongeForm& form, double resolution)
{
  constexpr double enough = 1e-9;
  const double curvature = std::max(std::abs(form.k1), std::abs(form.k2));
  return distance * curvature <= enough || distance <= 8.0 * resolution;
}

/// Newton's method for the points of all lanes, each until it is done.
class NewtonIteration
{
public:
  NewtonIteration(const JetFunction& function, SurfacePoints& points)
    : Function_(function)
    , Points_(points)
    , Trial_(points)
    , Here_(function, points)
    , Left_(points.count)
  {
    this->Share_.fill(1.0);
    for (int lane = 0; lane < points.count; ++lane)
    {
      points.fault[lane] = this->Here_.IsFinite(lane) ? ExactFault::None : ExactFault::NotFinite;
      if (points.fault[lane] != ExactFault::None)
      {
        this->MarkDone(lane);
      }
    }
  }

  bool GoesOn() const { return this->Left_ > 0; }

  void Step()
  {
    for (int lane = 0; lane < this->Points_.count; ++lane)
    {
      if (!this->IsDone_[lane])
      {
        this->Aim(lane);
      }
    }
    if (!this->GoesOn())
    {
      return;
    }
    this->RepeatOneThatGoesOn();
    const Linearization there(this->Function_, this->Trial_);
    for (int lane = 0; lane < this->Points_.count; ++lane)
    {
      if (!this->IsDone_[lane])
      {
        this->Accept(lane, there);
      }
    }
  }

  /// Normals and faults.
  void Finish(const SurfacePoints& start)
  {
    for (int lane = 0; lane < this->Points_.count; ++lane)
    {
      ExactFault& fault = this->Points_.fault[lane];
      const double length = this->Here_.gradient[lane].norm();
      if (fault == ExactFault::None)
      {
        fault = this->FaultOf(lane, length, start.position[lane]);
      }
      this->Points_.normal[lane] = fault == ExactFault::None
        ? Eigen::Vector3d(this->Here_.gradient[lane] / length)
        : Eigen::Vector3d::Zero();
    }
  }

private:
  void MarkDone(int lane)
  {
    this->IsDone_[lane] = true;
    --this->Left_;
  }

  /// Lanes that are done take the point of another, as what is evaluated point by point need not
  /// be evaluated for them again.
  void RepeatOneThatGoesOn()
  {
    const auto first = static_cast<std::size_t>(
      std::find(this->IsDone_.begin(), this->IsDone_.end(), false) - this->IsDone_.begin());
    for (int lane = 0; lane < this->Points_.count; ++lane)
    {
      if (this->IsDone_[lane])
      {
        this->Trial_.position[lane] = this->Trial_.position[first];
      }
    }
  }

  void Aim(int lane)
  {
    const Eigen::Vector3d& position = this->Points_.position[lane];
    const Eigen::Vector3d move = this->Share_[lane] * this->Here_.NewtonStep(lane);
    this->Length_[lane] = move.norm();
    this->Trial_.position[lane] = position + move;
    // A gradient of 0 makes it infinite or, on the surface, not a number.
    if (!std::isfinite(this->Length_[lane]) || this->Length_[lane] <= 2.0 * Resolution(position))
    {
      this->Trial_.position[lane] = position;
      this->MarkDone(lane);
    }
  }

  void Accept(int lane, const Linearization& there)
  {
    double& share = this->Share_[lane];
    if (there.IsFinite(lane) && std::abs(there.value[lane]) < std::abs(this->Here_.value[lane]))
    {
      this->Points_.position[lane] = this->Trial_.position[lane];
      this->Here_.value[lane] = there.value[lane];
      this->Here_.gradient[lane] = there.gradient[lane];
      share = 1.0;
    }
    else if (share == 1.0 && this->Length_[lane] <= 64.0 * Resolution(this->Points_.position[lane]))
    {
      this->MarkDone(lane); // no better point can be represented
    }
    else
    {
      share *= 0.5;
    }
  }

  ExactFault FaultOf(int lane, double gradient, const Eigen::Vector3d& start) const
  {
    if (!(gradient > 0.0))
    {
      return this->Here_.value[lane] == 0.0 ? ExactFault::Singular : ExactFault::NoConvergence;
    }
    const double step = this->Here_.NewtonStep(lane).norm();
    return IsSettled(step, start, this->Points_.position[lane]) ? ExactFault::None
                                                                : ExactFault::NoConvergence;
  }

  const JetFunction& Function_;
  SurfacePoints& Points_;
  SurfacePoints Trial_;
  Linearization Here_;
  std::array<double, Lanes::Count> Share_; ///< Of Newton's step that is made.
  std::array<double, Lanes::Count> Length_{};
  std::array<bool, Lanes::Count> IsDone_{};
  int Left_;
};

} // namespace

void ImplicitExactSurface::Locate(SurfacePoints& points) const
{
  const SurfacePoints start = points;
  NewtonIteration iteration(this->Function_, points);
  for (int step = 0; step < MaximumSteps && iteration.GoesOn(); ++step)
  {
    iteration.Step();
  }
  iteration.Finish(start);
}

void ImplicitExactSurface::Differentiate(SurfacePoints& points) const
{
  const std::array<Eigen::Matrix3d, Lanes::Count> frames = FramesOf(points);
  std::array<LaneVector3, 3> axes;
  for (int lane = 0; lane < Lanes::Count; ++lane)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < 3; ++i)
      {
        axes[axis][i][lane] = frames[lane](i, axis);
      }
    }
  }
  const JetFunction::Jet4 jets = this->Function_.Full(Positions(points), axes);
  for (int lane = 0; lane < points.count; ++lane)
  {
    if (points.fault[lane] != ExactFault::None)
    {
      continue;
    }
    const Taylor3<4> f = LaneOf(jets, lane);
    const double resolution = Resolution(points.position[lane]);
    const double size = points.position[lane].cwiseAbs().maxCoeff();
    MongeForm& form = points.form[lane];
    form = MongeFormOfHeightJet(HeightOfImplicit(f), frames[lane]);
    points.steepness[lane] = std::abs(f(0, 0, 1)); // along the normal
    const double distance = std::abs(f.Constant() / f(0, 0, 1));
    if (IsSingular(f, resolution, size))
    {
      points.fault[lane] = ExactFault::Singular;
    }
    else if (!IsFinite(form))
    {
      points.fault[lane] = ExactFault::NotFinite;
    }
    else if (!IsClose(distance, form, resolution))
    {
      points.fault[lane] = ExactFault::NoConvergence;
    }
  }
}

// -------------------------------------------------------------------------------- parametric

namespace
{

/// r(u + us s + ut t, v + vs s + vt t) as polynomials in s and t.
template <int Degree>
std::array<Taylor3<Degree, Lanes>, 3> Evaluate(const std::array<FormulaProgram, 3>& r,
  const SurfacePoints& points, const std::array<Eigen::Matrix2d, Lanes::Count>& slopes)
{
  using Jet = Taylor3<Degree, Lanes>;
  std::array<Jet, 2> variables;
  for (int i = 0; i < 2; ++i)
  {
    Lanes at;
    Lanes byS;
    Lanes byT;
    for (int lane = 0; lane < Lanes::Count; ++lane)
    {
      at[lane] = points.parameters[lane < points.count ? lane : 0][i];
      byS[lane] = slopes[lane](i, 0);
      byT[lane] = slopes[lane](i, 1);
    }
    variables[i] = Jet::Linear(at, byS, byT, 0.0);
  }
  std::array<Jet, 3> values;
  for (int i = 0; i < 3; ++i)
  {
    values[i] = r[i].Evaluate(variables.data());
  }
  return values;
}

} // namespace

void ParametricExactSurface::Locate(SurfacePoints& points) const
{
  std::array<Eigen::Matrix2d, Lanes::Count> slopes;
  slopes.fill(Eigen::Matrix2d::Identity());
  const auto r = Evaluate<1>(this->R_, points, slopes);
  for (int lane = 0; lane < points.count; ++lane)
  {
    Eigen::Matrix3d columns; // the point and its two derivatives
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        columns(i, j) = r[i].Coefficients()[j][lane];
      }
    }
    const Eigen::Vector3d normal = columns.col(1).cross(columns.col(2));
    const double size = columns.rightCols<2>().squaredNorm();
    // As round-off leaves it at the poles of a sphere, say.
    const bool isRegular = normal.norm() > std::numeric_limits<double>::epsilon() * size;
    points.fault[lane] = !columns.allFinite() ? ExactFault::NotFinite
      : !isRegular                            ? ExactFault::Singular
                                              : ExactFault::None;
    points.normal[lane] = Eigen::Vector3d::Zero();
    if (points.fault[lane] != ExactFault::NotFinite)
    {
      points.position[lane] = columns.col(0);
    }
    if (points.fault[lane] == ExactFault::None)
    {
      points.normal[lane] = normal.normalized();
    }
  }
}

void ParametricExactSurface::Differentiate(SurfacePoints& points) const
{
  const std::array<Eigen::Matrix3d, Lanes::Count> frames = FramesOf(points);
  std::array<Eigen::Matrix2d, Lanes::Count> slopes;
  slopes.fill(Eigen::Matrix2d::Identity());
  const auto linear = Evaluate<1>(this->R_, points, slopes);
  for (int lane = 0; lane < points.count; ++lane)
  {
    if (points.fault[lane] == ExactFault::None)
    {
      Eigen::Matrix<double, 3, 2> derivatives;
      for (int i = 0; i < 3; ++i)
      {
        derivatives.row(i) << linear[i].Coefficients()[1][lane], linear[i].Coefficients()[2][lane];
      }
      slopes[lane] = (frames[lane].leftCols<2>().transpose() * derivatives).inverse();
    }
  }
  const auto r = Evaluate<4>(this->R_, points, slopes);
  for (int lane = 0; lane < points.count; ++lane)
  {
    if (points.fault[lane] != ExactFault::None)
    {
      continue;
    }
    const std::array<Taylor3<4>, 3> xyz{ LaneOf(r[0], lane), LaneOf(r[1], lane),
      LaneOf(r[2], lane) };
    std::array<Taylor3<4>, 3> local;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < 3; ++i)
      {
        local[axis] += frames[lane](i, axis) * xyz[i];
      }
    }
    points.form[lane] = MongeFormOfHeightJet(HeightOfParametric(local), frames[lane]);
    if (!IsFinite(points.form[lane]))
    {
      points.fault[lane] = ExactFault::NotFinite;
    }
  }
}

} // namespace ridges
