// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/FoldEvening.h"

#include "Salience/Trail.h"

#include <cmath>

namespace ridges
{
namespace
{

/// Farther than so many deviations the Gaussian adds nothing.
constexpr double Reach = 2.5;

/// The points of a ridge, and where on it folds are measured.
class FoldTrail : public Trail
{
public:
  explicit FoldTrail(const RidgeTrace& trace)
    : Trail(trace.vertices, trace.closed)
    , Trace_(trace)
  {
  }

  bool IsElliptic(Id piece) const
  {
    return piece >= 0 && ridges::IsElliptic(this->Trace_.types[piece]);
  }
  bool IsMeasured(Id point) const
  {
    return this->Trace_.vertices[point].edge != RidgeVertex::None &&
      (this->IsElliptic(this->PieceBefore(point)) || this->IsElliptic(this->PieceBehind(point)));
  }

private:
  const RidgeTrace& Trace_;
};

/// The weighted mean around a point: of both sides first, as which is which may be turned.
double EvenAngle(const FoldTrail& path, const RidgeFolds& folds, Id point, double sigma)
{
  double weights[2] = { 0.0, 0.0 };
  double sums[2] = { 0.0, 0.0 };
  for (const bool forward : { false, true })
  {
    double distance = 0.0;
    Id at = point;
    for (Id step = 1; step < path.NumberOfPoints(); ++step)
    {
      const Id piece = path.Piece(at, forward);
      distance += path.LengthOf(piece);
      at = path.Next(at, forward);
      if (piece < 0 || !path.IsElliptic(piece) || distance > Reach * sigma || !path.IsMeasured(at))
      {
        break;
      }
      const double ratio = distance / sigma;
      const double weight = path.LengthAt(at) * std::exp(-0.5 * ratio * ratio);
      weights[forward ? 1 : 0] += weight;
      sums[forward ? 1 : 0] += weight * folds[at].angle;
    }
  }
  const double own = path.LengthAt(point);
  const double weight = (weights[0] + weights[1]) + own;
  return weight > 0.0 ? ((sums[0] + sums[1]) + own * folds[point].angle) / weight
                      : folds[point].angle;
}

} // namespace

void EvenFolds(const RidgeTrace& trace, double sigma, double leastRise, RidgeFolds& folds)
{
  for (Fold& fold : folds)
  {
    if (fold.height < leastRise * (fold.height + fold.foot))
    {
      fold.angle = 0.0;
    }
  }
  if (!(sigma > 0.0))
  {
    return;
  }
  const FoldTrail path(trace);
  const RidgeFolds measured = folds;
  for (Id i = 0; i < path.NumberOfPoints(); ++i)
  {
    if (path.IsMeasured(i))
    {
      folds[i].angle = EvenAngle(path, measured, i, sigma);
    }
  }
  if (trace.closed && !folds.empty())
  {
    folds.back().angle = folds.front().angle;
  }
}

} // namespace ridges
