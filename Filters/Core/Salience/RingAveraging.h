// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RingAveraging_h
#define ridges_RingAveraging_h

#include "Salience/RingGraph.h"

#include <array>

namespace ridges
{

/// What is done in one sweep over all cells.
struct AveragingSweep
{
  int step = 0;   ///< Of a box, counted from 1; 0 is a plain average.
  int length = 0; ///< Of the box, in steps.
};

/**
 * Replaces the values of all cells, again and again, by their averages over one-rings, weighted by
 * area and the factors of the graph. Each average is a diffusion: many of them are a Gaussian on
 * the surface.
 *
 * A box smooths farther with as many sweeps. With the operator A of a plain average and Chebyshev
 * polynomials T, one of n steps is (1 + 2 T_1(A) + ... + 2 T_n(A)) / (2 n + 1): along a row of
 * points the mean of 2 n + 1 of them. It has the variance of n (n + 1) / 3 averages.
 *
 * Set or Gather, and Prepare, are for cells; then Step on ranges of cells and Swap take turns.
 * Ranges of one step may be done at the same time.
 */
template <int Components>
class RingAveraging
{
public:
  using Values = std::array<double, Components>;

  /// Refers to the graph.
  explicit RingAveraging(const RingGraph& graph, bool hasBoxes = false);
  RingAveraging(const RingAveraging&) = delete;
  RingAveraging& operator=(const RingAveraging&) = delete;

  /// The values of a cell at the start. Where it does not count they are ignored.
  void Set(Id cell, const Values& values, bool counts = true);

  /// The mean of these cells of a finer graph at the start.
  void Gather(Id cell, const RingAveraging& fine, Span<Id> members);

  /// How much of each average a cell takes, 0 to 1: the variance of a step is that part of
  /// RingGraph::Variance. After all cells are set.
  void Prepare(Id cell, double share);

  /// The values of a cell of a coarser graph that is this one. A cell that does not count stays so.
  void Take(Id cell, const RingAveraging& coarse, Id from);

  /// The values interpolated between those of a coarser graph, one of whose cells this one belongs
  /// to.
  void Interpolate(Id cell, const RingAveraging& coarse, Id from);

  /// The steps of a box follow each other.
  void Step(Id begin, Id end, const AveragingSweep& sweep = {});
  void Swap(const AveragingSweep& sweep = {});

  /// The values of a cell after the last step; false if it does not count.
  bool Get(Id cell, Values& values) const;

private:
  static double* At(Buffer<double>& values, Id cell)
  {
    return values.data() + static_cast<std::size_t>(Components) * cell;
  }
  static const double* At(const Buffer<double>& values, Id cell)
  {
    return values.data() + static_cast<std::size_t>(Components) * cell;
  }
  template <bool HasFactors>
  void StepWith(Id begin, Id end, const AveragingSweep& sweep);

  const RingGraph& Graph_;
  // Values times area, and the area that counts, so that a step has less to multiply with.
  Buffer<double> Now_;
  Buffer<double> Next_; ///< In a box what T of the step before gives, until it is overwritten.
  Buffer<double> Sum_;  ///< Of a box.
  Buffer<double> Areas_;
  Buffer<double> Own_;  ///< What of the own value stays.
  Buffer<double> Ring_; ///< What is taken of the sum over the cell and its neighbours.
};

} // namespace ridges

#endif
