// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RidgeCrossings_h
#define ridges_RidgeCrossings_h

#include "Ridges/RidgePoint.h"

#include <vector>

namespace ridges
{

/**
 * The edges that ridges of one colour cross, and the points where they do, each found once: an edge
 * has two triangles, and the point is asked for again when the ridge is put together.
 *
 * Find looks at ranges of edges, all of which are to be looked at; Place finds ranges of points.
 * Ranges of one step may be done at the same time; Build does all.
 */
class RidgeCrossings
{
public:
  /// With the Gaussian rule the colour does not matter: each point has that of what changes there.
  RidgeCrossings(const TriangleMesh& mesh, const MongeField& field, Color color, CrossingRule rule,
    ExtremalityRule extremality = ExtremalityRule::Principal);

  /// Appends the edges of a range that are crossed.
  void Find(Id beginEdge, Id endEdge, std::vector<Id>& crossed);
  /// Takes all that Find has found.
  void SetCrossed(std::vector<Id> edges);
  void Place(Id begin, Id end);

  void Build();

  const TriangleMesh& Mesh() const { return this->Mesh_; }
  const MongeField& Field() const { return this->Field_; }
  Color RidgeColor() const { return this->Color_; }

  Id Size() const { return static_cast<Id>(this->Edges_.size()); }
  bool IsCrossed(Id edge) const { return this->Numbers_[edge] >= 0; }

  /// Counts the edges that are crossed, in no order that matters.
  Id NumberOf(Id edge) const { return this->Numbers_[edge]; }

  /// The point on an edge that is crossed.
  const RidgePoint& PointOn(Id edge) const { return this->Points_[this->Numbers_[edge]]; }

private:
  static constexpr Id NotCrossed = -1;

  const TriangleMesh& Mesh_;
  MongeField Field_;
  Color Color_;
  CrossingRule Rule_;
  ExtremalityRule Extremality_;
  Buffer<Id> Numbers_;    ///< Per edge.
  std::vector<Id> Edges_; ///< Per crossing.
  std::vector<RidgePoint> Points_;
};

} // namespace ridges

#endif
