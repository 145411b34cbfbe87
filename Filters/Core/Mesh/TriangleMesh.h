// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_TriangleMesh_h
#define ridges_TriangleMesh_h

#include "Base/Buffer.h"
#include "Mesh/MeshPart.h"
#include "Mesh/PointRanks.h"
#include "Mesh/Triangle.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace ridges
{

/**
 * Triangles over points that the caller keeps, with the adjacency all later steps walk on: the
 * triangles around a point (compressed rows) and the edges, each numbered once.
 *
 * Any triangles whose corners are three different points are accepted; where more than two meet
 * in an edge the edge is NonManifold and separates them, as a border does.
 */
class TriangleMesh
{
public:
  static constexpr Id Border = -1;
  static constexpr Id NonManifold = -2;

  TriangleMesh() = default;

  /// Whether the edges are numbered, which takes most of the time.
  enum class Edges
  {
    Built,
    NotBuilt
  };

  /// `points` holds x, y, z of each point and must outlive the mesh. No triangle may repeat a
  /// corner or name a point that is not there. The work is split into `shares`, each of which takes
  /// 4 bytes per point meanwhile; the result does not depend on their number.
  TriangleMesh(const double* points, Id numberOfPoints, Buffer<Triangle> triangles,
    Edges edges = Edges::Built, const RangeLoop& loop = InOneRange, Id shares = 1);
  TriangleMesh(const double* points, Id numberOfPoints, const std::vector<Triangle>& triangles,
    Edges edges = Edges::Built);

  /// Numbers the edges: for whatever speaks of edges, neighbours or borders. By the smaller of
  /// their points, and there by the larger, whatever the loop.
  void BuildEdges(const RangeLoop& loop = InOneRange);
  static void InOneRange(Id count, const std::function<void(Id, Id)>& body) { body(0, count); }

  Id NumberOfPoints() const { return this->NumberOfPoints_; }
  Id NumberOfTriangles() const { return static_cast<Id>(this->Triangles_.size()); }
  Id NumberOfEdges() const { return static_cast<Id>(this->Edges_.size()); }

  Eigen::Map<const Eigen::Vector3d> Point(Id p) const
  {
    return Eigen::Map<const Eigen::Vector3d>(this->Points_ + 3 * static_cast<std::size_t>(p));
  }
  const Triangle& Corners(Id t) const { return this->Triangles_[t]; }
  Span<Triangle> Triangles() const { return { this->Triangles_.begin(), this->Triangles_.end() }; }
  const Edge& EdgeAt(Id e) const { return this->Edges_[e]; }

  /// The edge of triangle t that joins its corners i and i + 1 (modulo 3).
  Id EdgeOf(Id t, int i) const { return this->TriangleEdges_[t][i]; }

  /// Which edge of triangle t, one of whose it is, an edge is.
  int SideOf(Id t, Id edge) const
  {
    return this->EdgeOf(t, 0) == edge ? 0 : (this->EdgeOf(t, 1) == edge ? 1 : 2);
  }

  /// Where on the border of triangle t, from 0 to 3 all around, a point of its edge i is, at this
  /// fraction of the way from the edge's smaller point id to its larger.
  double PlaceOnBorder(Id t, int i, double parameter) const
  {
    const bool forward = this->Corners(t)[i] == this->EdgeAt(this->EdgeOf(t, i)).v0;
    return i + (forward ? parameter : 1.0 - parameter);
  }

  /// The triangle across edge i of triangle t, or Border, or NonManifold.
  Id Neighbor(Id t, int i) const
  {
    const Edge& edge = this->Edges_[this->TriangleEdges_[t][i]];
    return edge.t1 < 0 ? edge.t1 : edge.t0 + edge.t1 - t;
  }

  /// The triangles that have p as a corner, in ascending order.
  Span<Id> TrianglesAround(Id p) const
  {
    const Id* base = this->Incident_.data();
    return { base + this->Offsets_[p], base + this->Offsets_[p + 1] };
  }

  /// Where TrianglesAround(p) begin among those of all points.
  Id Offset(Id p) const { return this->Offsets_[p]; }

  /// Tells points at one place apart, whatever the numbering: see PointRanks.
  std::uint64_t RankAtPlace(Id p) const { return this->Ranks_->RankOf(*this, p); }

  /// The same from whoever knows more of the mesh than is here: by point, in ascending order, those
  /// that share a place.
  void SetRanksAtPlace(std::vector<std::pair<Id, std::uint64_t>> ranks)
  {
    this->Ranks_->Set(std::move(ranks));
  }

  /// The larger mesh that this one is a part of; null if it is none. Kept by the caller.
  const MeshPart* Part() const { return this->Part_; }
  void SetPart(const MeshPart* part) { this->Part_ = part; }

  /// To be called where the triangles around a point are looked at, and it is not known that this
  /// mesh has all of them.
  void LookAt(Id p, int numberOfRings = 1) const
  {
    if (this->Part_)
    {
      this->Part_->LookAt(p, numberOfRings);
    }
  }

  /// Whether p is an end of an edge that does not have exactly two triangles.
  bool OnBorder(Id p) const { return this->OnBorder_[p] != 0; }

  Eigen::Vector3d Centroid(Id t) const;

  /// Normal of a triangle, as long as twice its area.
  Eigen::Vector3d AreaNormal(Id t) const;

  /// Sum of the area normals around p: not of unit length, zero where p has no triangle, or such
  /// that are folded flat.
  Eigen::Vector3d PointNormal(Id p) const;

  /// 0 without edges.
  double MeanEdgeLength() const;

  /// The fans of triangles that meet at a point, each joined by edges that have exactly two: as
  /// many points of the surface it counts as. 0 for a point without triangles, more than 1 for a
  /// pinch point, where fans touch in the point alone; else 1.
  Id NumberOfFans(Id p) const;

  /**
   * Points - edges + triangles of the surface, where the mesh is cut apart at pinch points and at
   * edges with more than two triangles: two spheres that touch in a point have 4. Points of no
   * triangle are left out.
   */
  Id EulerCharacteristic(const RangeLoop& loop = InOneRange) const;

  /// Edges whose two triangles run through them in the same direction.
  Id NumberOfInconsistentEdges() const;

  /// The same triangles, some of them turned around so that neighbours run through their edge in
  /// opposite senses wherever that is possible: each connected part in the sense of its first.
  TriangleMesh ConsistentlyOriented() const;

  /// Edges with more than two triangles.
  Id NumberOfNonManifoldEdges() const;

private:
  void BuildIncidence(const RangeLoop& loop, Id shares);
  bool IsSmallClosedFan(Id p) const;
  Id CountFans(Id p) const;
  void FindEdges(Id begin, Id end, std::vector<Edge>& edges, std::vector<Id>& border);

  const double* Points_ = nullptr;
  Id NumberOfPoints_ = 0;
  Buffer<Triangle> Triangles_;
  Buffer<Triangle> TriangleEdges_;
  Buffer<Edge> Edges_;
  Buffer<Id> Offsets_;
  Buffer<Id> Incident_;
  std::vector<std::uint8_t> OnBorder_;
  std::unique_ptr<PointRanks> Ranks_ = std::make_unique<PointRanks>();
  const MeshPart* Part_ = nullptr;
};

} // namespace ridges

#endif
