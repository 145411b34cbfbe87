// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_GraphInterpolation_h
#define ridges_GraphInterpolation_h

#include "Salience/RingGraph.h"

#include <array>

namespace ridges
{

/**
 * What is taken of the cells of a coarser graph for a place of the surface: of the cell that the
 * place belongs to and of its neighbours, the more the nearer they are. What is linear stays so.
 */
class GraphInterpolation
{
public:
  struct Part
  {
    Id cell;
    double factor; ///< Of its area.
  };

  /// For a place that belongs to this cell. Without a normal, which is zero, nothing is corrected.
  GraphInterpolation(
    const RingGraph& coarse, Id cell, const Eigen::Vector3d& place, const Eigen::Vector3d& normal);

  const Part* begin() const { return this->Parts_.data(); }
  const Part* end() const { return this->Parts_.data() + this->Size_; }

  /// What it adds, along either axis of the surface.
  double Variance() const;

private:
  void Add(Id cell);

  /// Of a cell with more neighbours those that come first are enough.
  static constexpr int MostParts = 32;

  const RingGraph& Coarse_;
  const Eigen::Vector3d& Place_;
  std::array<Part, MostParts> Parts_;
  int Size_ = 0;
};

} // namespace ridges

#endif
