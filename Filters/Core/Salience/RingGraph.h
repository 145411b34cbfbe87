// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RingGraph_h
#define ridges_RingGraph_h

#include "Salience/OneRings.h"

#include <Eigen/Core>

#include <vector>

namespace ridges
{

/**
 * What averages over one-rings need to know of a mesh, or of a coarser version of it: cells that
 * stand for a part of the surface each, and their neighbours. Of a mesh the cells are its points.
 */
struct RingGraph
{
  std::vector<Id> begins;    ///< By cell, in the list below; one more at the end.
  std::vector<Id> neighbors; ///< In an order that the numbering has no part in.
  std::vector<double> areas;
  std::vector<Eigen::Vector3d> positions;
  /// Of length 1, and zero where there is none and at borders; may be empty.
  std::vector<Eigen::Vector3d> normals;
  /// By what the area of each neighbour is multiplied in averages; may be empty.
  std::vector<float> factors;
  /// Of a coarser graph: squares of the distances to which interpolation takes of each cell.
  std::vector<double> reaches;

  RingGraph() = default;

  /// The points of a mesh, in this order.
  RingGraph(const OneRings& rings, const std::vector<Id>& points);

  Id NumberOfCells() const { return static_cast<Id>(this->areas.size()); }
  Span<Id> Around(Id cell) const
  {
    const Id* base = this->neighbors.data();
    return { base + this->begins[cell], base + this->begins[cell + 1] };
  }
  double Factor(Id i) const { return this->factors.empty() ? 1.0 : double{ this->factors[i] }; }

  /// The variance, along either axis of the surface, of the average over a cell and its neighbours.
  double Variance(Id cell) const;

  /// Of the points that the graph was made of.
  void SetNormals(const OneRings& rings, const std::vector<Id>& points, const RangeLoop& loop);

  /**
   * Chooses the factors so that averages are around the cell itself. Weighted by area alone they
   * are around a place on the side of the larger neighbours, and many of them wander there: where
   * the density of the mesh changes by as much as half of the scale. Needs normals; at borders
   * averages stay as they are.
   */
  void SetFactors(const RangeLoop& loop);

  void SetReaches();

private:
  void SetFactorsAround(Id cell);
};

} // namespace ridges

#endif
