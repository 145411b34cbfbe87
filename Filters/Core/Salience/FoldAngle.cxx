// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/FoldAngle.h"

#include <algorithm>
#include <limits>

namespace ridges
{

FoldMeter::FoldMeter(const TriangleMesh& mesh, const MongeField& field, const FoldRule& rule)
  : Mesh_(mesh)
  , Rule_(rule)
  , Walk_(mesh, field)
{
}

Fold FoldMeter::Measure(Color color, Id edge, const Eigen::Vector3d& point)
{
  const Edge& sides = this->Mesh_.EdgeAt(edge);
  double peak = -std::numeric_limits<double>::infinity();
  const double leastLeft = this->Walk(color, sides.t0, edge, point, 0.0, peak, this->Left_);
  const double leastRight =
    this->Walk(color, sides.t1, edge, point, std::max(0.0, leastLeft), peak, this->Right_);
  Fold fold;
  const double foot = std::max({ 0.0, leastLeft, leastRight });
  if (!(peak > foot))
  {
    return fold;
  }
  // Side by side first: which of them is left depends on the numbering.
  const Fold left = FoldOf(this->Left_, foot + this->Rule_.floor);
  const Fold right = FoldOf(this->Right_, foot + this->Rule_.floor);
  fold.angle = left.angle + right.angle;
  fold.width = left.width + right.width;
  fold.height = peak - foot;
  fold.foot = foot;
  return fold;
}

/// Samples one side; the result is the least f, or 0 where there is no way. Once f is down at
/// `stop` the foot, which is not below that, does not depend on this side, and the fold ends there.
double FoldMeter::Walk(Color color, Id triangle, Id edge, const Eigen::Vector3d& point, double stop,
  double& peak, Samples& samples)
{
  samples.clear();
  if (triangle < 0 || !this->Walk_.Start(color, triangle, edge, point))
  {
    return 0.0;
  }
  const double sign = color == Color::Blue ? 1.0 : -1.0;
  double least = sign * this->Walk_.Curvature();
  double own = least;
  double arc = 0.0;
  samples.push_back({ 0.0, least });
  const auto isDecided = [this, &arc, &least, stop]()
  { return arc > this->Rule_.slack && least <= stop; };
  // A feature is some hundred edges wide at most. Where a few points are very far away, so that the
  // reach is a million edges of the rest, walks would go around in circles.
  constexpr std::size_t mostSamples = 10'000;
  while (
    arc < this->Rule_.reach && samples.size() < mostSamples && !isDecided() && this->Walk_.Step())
  {
    const double step = this->Walk_.StepLength();
    double f = sign * this->Walk_.Curvature();
    if (arc + step > this->Rule_.reach)
    {
      // As far as the reach only: the foot must not depend on where the last triangle ends.
      f = samples.back().f + (this->Rule_.reach - arc) / step * (f - samples.back().f);
      arc = this->Rule_.reach;
    }
    else
    {
      arc += step;
    }
    if (f > own)
    {
      if (arc > this->Rule_.slack)
      {
        break;
      }
      own = f;
    }
    samples.push_back({ arc, f });
    least = std::min(least, f);
  }
  peak = std::max(peak, own);
  return least;
}

Fold FoldMeter::FoldOf(const Samples& samples, double foot)
{
  Fold fold;
  for (std::size_t i = 1; i < samples.size(); ++i)
  {
    const double a = samples[i - 1].f - foot;
    const double b = samples[i].f - foot;
    const double step = samples[i].arc - samples[i - 1].arc;
    if (!(a > 0.0))
    {
      break;
    }
    const double part = b >= 0.0 ? step : step * a / (a - b);
    fold.angle += 0.5 * part * (a + std::max(0.0, b));
    fold.width += part;
  }
  return fold;
}

} // namespace ridges
