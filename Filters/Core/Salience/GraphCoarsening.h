// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_GraphCoarsening_h
#define ridges_GraphCoarsening_h

#include "Salience/RingGraph.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace ridges
{

/// How the cells of a graph are joined to those of a coarser one.
struct Coarsening
{
  RingGraph graph;         ///< The coarser one.
  std::vector<Id> coarse;  ///< By fine cell, the one that it is a part of.
  std::vector<Id> begins;  ///< By coarse cell, in the list below; one more at the end.
  std::vector<Id> members; ///< Fine cells, in an order that the numbering has no part in.

  /// Of what a coarse cell is made of around its position, along either axis of the surface.
  std::vector<double> variances;

  Span<Id> Members(Id cell) const
  {
    const Id* base = this->members.data();
    return { base + this->begins[cell], base + this->begins[cell + 1] };
  }
};

/**
 * Joins each cell that `joins` to the nearest of some chosen neighbours: no two of these are
 * neighbours of each other, and each of the others has one. A coarse cell is made of four to five,
 * and lies at their centroid. Cells that do not join stay as they are.
 *
 * Which cells are chosen depends on positions only, as if by chance; of cells at one place those of
 * lower rank come first. Cells that join must be neighbours of their neighbours.
 */
Coarsening Coarsen(const RingGraph& fine, const std::vector<std::uint8_t>& joins,
  const std::function<std::uint64_t(Id)>& rank, const RangeLoop& loop);

} // namespace ridges

#endif
