// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/FoldEvening.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace ridges
{
namespace
{

/// Farther than so many deviations the Gaussian adds nothing.
constexpr double Reach = 2.5;

/// The points of a ridge, those of a loop going around.
class Trail
{
public:
  explicit Trail(const RidgeTrace& trace)
    : Trace_(trace)
    , Pieces_(static_cast<Id>(trace.types.size()))
    , Points_(trace.closed ? Pieces_ : Pieces_ + 1)
    , Lengths_(trace.types.size())
  {
    for (Id i = 0; i < this->Pieces_; ++i)
    {
      this->Lengths_[i] =
        (trace.vertices[i + 1].point.position - trace.vertices[i].point.position).norm();
    }
  }

  Id NumberOfPoints() const { return this->Points_; }

  /// The piece before or behind a point; negative where there is none.
  Id PieceBefore(Id point) const
  {
    return point > 0 ? point - 1 : (this->Trace_.closed ? this->Pieces_ - 1 : -1);
  }
  Id PieceBehind(Id point) const { return point < this->Pieces_ ? point : -1; }
  Id Next(Id point, bool forward) const
  {
    return forward ? (point + 1) % this->Points_ : (point + this->Points_ - 1) % this->Points_;
  }
  double LengthOf(Id piece) const { return piece < 0 ? 0.0 : this->Lengths_[piece]; }
  double LengthAt(Id point) const
  {
    return 0.5 *
      (this->LengthOf(this->PieceBefore(point)) + this->LengthOf(this->PieceBehind(point)));
  }
  bool IsElliptic(Id piece) const
  {
    return piece >= 0 && ridges::IsElliptic(this->Trace_.types[piece]);
  }
  /// Whether folds are measured there.
  bool IsMeasured(Id point) const
  {
    return this->Trace_.vertices[point].edge != RidgeVertex::None &&
      (this->IsElliptic(this->PieceBefore(point)) || this->IsElliptic(this->PieceBehind(point)));
  }

private:
  const RidgeTrace& Trace_;
  Id Pieces_;
  Id Points_;
  std::vector<double> Lengths_;
};

/// The weighted mean around a point: of both sides first, as which is which may be turned.
double EvenAngle(const Trail& path, const RidgeFolds& folds, Id point, double sigma)
{
  double weights[2] = { 0.0, 0.0 };
  double sums[2] = { 0.0, 0.0 };
  for (const bool forward : { false, true })
  {
    double distance = 0.0;
    Id at = point;
    for (Id step = 1; step < path.NumberOfPoints(); ++step)
    {
      const Id piece = forward ? path.PieceBehind(at) : path.PieceBefore(at);
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
  const Trail path(trace);
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
