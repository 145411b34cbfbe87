// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/GraphInterpolation.h"

#include "Salience/LinearWeights.h"

#include <algorithm>

namespace ridges
{

GraphInterpolation::GraphInterpolation(
  const RingGraph& coarse, Id cell, const Eigen::Vector3d& place, const Eigen::Vector3d& normal)
  : Coarse_(coarse)
  , Place_(place)
{
  this->Add(cell);
  for (const Id other : coarse.Around(cell))
  {
    this->Add(other);
  }
  if (this->Size_ == 0)
  {
    this->Parts_[this->Size_++] = { cell, 1.0 };
    return;
  }
  LinearWeights weights(normal);
  for (const Part& part : *this)
  {
    weights.Add(part.factor * coarse.areas[part.cell], coarse.positions[part.cell] - place);
  }
  weights.Solve();
  // Beside the last cells of a surface the others have to be gone on from, but not far.
  constexpr double least = -1.0;
  for (int i = 0; i < this->Size_; ++i)
  {
    Part& part = this->Parts_[i];
    part.factor *= std::max(least, 1.0 + weights.Slope(coarse.positions[part.cell] - place));
  }
}

void GraphInterpolation::Add(Id cell)
{
  const double square = (this->Coarse_.positions[cell] - this->Place_).squaredNorm();
  const double rest = 1.0 - square / this->Coarse_.reaches[cell];
  if (rest > 0.0 && this->Size_ < MostParts)
  {
    this->Parts_[this->Size_++] = { cell, rest * rest };
  }
}

double GraphInterpolation::Variance() const
{
  double weights = 0.0;
  double sum = 0.0;
  for (const Part& part : *this)
  {
    const double weight = part.factor * this->Coarse_.areas[part.cell];
    weights += weight;
    sum += weight * (this->Coarse_.positions[part.cell] - this->Place_).squaredNorm();
  }
  return weights > 0.0 ? 0.5 * std::max(0.0, sum / weights) : 0.0;
}

} // namespace ridges
