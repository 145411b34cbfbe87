// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/PointwiseFunction.h"

#include <algorithm>

namespace ridges
{
namespace
{

using Jet = Taylor3<4>;

Eigen::Vector3d LaneOf(const LaneVector3& x, int lane)
{
  return { x[0][lane], x[1][lane], x[2][lane] };
}

/// The polynomial with these coefficients, of three polynomials: by Horner's rule.
Jet Substituted(const std::array<double, Jet::Size>& values, const std::array<Jet, 3>& offset)
{
  Jet inX;
  for (int i = 4; i >= 0; --i)
  {
    Jet inY;
    for (int j = 4 - i; j >= 0; --j)
    {
      Jet inZ;
      for (int k = 4 - i - j; k >= 0; --k)
      {
        inZ = inZ * offset[2] + Jet(values[Jet::Index(i, j, k)]);
      }
      inY = inY * offset[1] + inZ;
    }
    inX = inX * offset[0] + inY;
  }
  return inX;
}

template <int Degree>
void SetLane(Taylor3<Degree, Lanes>& lanes, const Taylor3<Degree>& jet, int lane)
{
  for (int i = 0; i <= Degree; ++i)
  {
    for (int j = 0; i + j <= Degree; ++j)
    {
      for (int k = 0; i + j + k <= Degree; ++k)
      {
        Lanes value = lanes(i, j, k);
        value[lane] = jet(i, j, k);
        lanes.Set(i, j, k, value);
      }
    }
  }
}

/// The first lane with the same point as a lane.
int FirstEqual(const LaneVector3& x, int lane)
{
  int first = 0;
  while (first < lane && LaneOf(x, first) != LaneOf(x, lane))
  {
    ++first;
  }
  return first;
}

/// Whether a lane repeats the point and the axes of the one before.
bool IsSameAsBefore(const LaneVector3& x, const std::array<LaneVector3, 3>& axes, int lane)
{
  return LaneOf(x, lane) == LaneOf(x, lane - 1) &&
    std::all_of(axes.begin(), axes.end(),
      [lane](const LaneVector3& axis) { return LaneOf(axis, lane) == LaneOf(axis, lane - 1); });
}

Jet LaneOf(const Taylor3<4, Lanes>& lanes, int lane)
{
  Jet jet;
  for (int i = 0; i <= 4; ++i)
  {
    for (int j = 0; i + j <= 4; ++j)
    {
      for (int k = 0; i + j + k <= 4; ++k)
      {
        jet.Set(i, j, k, lanes(i, j, k)[lane]);
      }
    }
  }
  return jet;
}

void CopyLane(Taylor3<1, Lanes>& lanes, int from, int to)
{
  Taylor3<1> jet;
  jet.Set(0, 0, 0, lanes(0, 0, 0)[from]);
  jet.Set(1, 0, 0, lanes(1, 0, 0)[from]);
  jet.Set(0, 1, 0, lanes(0, 1, 0)[from]);
  jet.Set(0, 0, 1, lanes(0, 0, 1)[from]);
  SetLane(lanes, jet, to);
}

} // namespace

JetFunction::Jet1 PointwiseFunction::Linear(const LaneVector3& x) const
{
  Jet1 result;
  for (int lane = 0; lane < Lanes::Count; ++lane)
  {
    const int before = FirstEqual(x, lane);
    if (before < lane)
    {
      CopyLane(result, before, lane);
      continue;
    }
    std::array<double, Jet1::Size> values{};
    this->Evaluate(LaneOf(x, lane), 1, values.data());
    const Eigen::Vector3d gradient =
      this->ToOwn_.transpose() * Eigen::Map<const Eigen::Vector3d>(&values[1]);
    SetLane(result, Taylor3<1>::Linear(values[0], gradient[0], gradient[1], gradient[2]), lane);
  }
  return result;
}

JetFunction::Jet4 PointwiseFunction::Full(
  const LaneVector3& x, const std::array<LaneVector3, 3>& axes) const
{
  Jet4 result;
  for (int lane = 0; lane < Lanes::Count; ++lane)
  {
    if (lane > 0 && IsSameAsBefore(x, axes, lane))
    {
      SetLane(result, LaneOf(result, lane - 1), lane);
      continue;
    }
    std::array<double, Jet4::Size> values{};
    this->Evaluate(LaneOf(x, lane), 4, values.data());
    Eigen::Matrix3d frame;
    for (int axis = 0; axis < 3; ++axis)
    {
      frame.col(axis) = this->ToOwn_ * LaneOf(axes[axis], lane);
    }
    std::array<Jet, 3> offset;
    for (int i = 0; i < 3; ++i)
    {
      offset[i] = Jet::Linear(0.0, frame(i, 0), frame(i, 1), frame(i, 2));
    }
    SetLane(result, Substituted(values, offset), lane);
  }
  return result;
}

} // namespace ridges
