// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_OneRings_h
#define ridges_OneRings_h

#include "Mesh/OrderedRings.h"

namespace ridges
{

/**
 * The points around each point, and the area that each point stands for: what averages and
 * derivatives over a mesh are made of.
 *
 * OrderedRings leaves out points whose triangles form no single fan. Here they have neighbours too,
 * in the order of their coordinates. No result depends on how points and triangles are numbered.
 */
class OneRings
{
public:
  /// `rings` has to be built.
  OneRings(const TriangleMesh& mesh, const OrderedRings& rings);

  /// Finds the areas of the points [begin, end). Different ranges may be built at the same time.
  void Build(Id begin, Id end);

  /// The neighbours of p.
  Span<Id> Around(Id p) const
  {
    const Span<Id> ring = this->Rings_.Around(p);
    return ring.size() > 0 || this->IrregularPoints_.empty() ? ring : this->AroundIrregular(p);
  }

  /// Whether the neighbours of p are in order, as one fan of triangles, and whether it is closed.
  bool IsFan(Id p) const { return this->Rings_.IsRegular(p); }
  bool IsClosed(Id p) const { return this->Rings_.IsClosed(p); }

  const TriangleMesh& Mesh() const { return this->Mesh_; }

  /// A third of the area of the triangles around p.
  double Area(Id p) const { return this->Areas_[p]; }

  /// Of the triangles around p, as long as twice their area; zero where they are no fan.
  Eigen::Vector3d AreaNormal(Id p) const;

  /// The variance, along either axis of the surface, of the average over p and its neighbours that
  /// weights each by its area. Needs the areas of all points around p.
  double Variance(Id p) const;

private:
  Span<Id> AroundIrregular(Id p) const;
  void AddIrregular(Id p);
  double AreaOfFan(Id p) const;
  double AreaOfTriangles(Id p) const;

  const TriangleMesh& Mesh_;
  const OrderedRings& Rings_;
  Buffer<double> Areas_;
  std::vector<Id> IrregularPoints_; ///< In ascending order.
  std::vector<Id> IrregularBegins_; ///< In the list below; one more at the end.
  std::vector<Id> IrregularNeighbors_;
};

} // namespace ridges

#endif
