// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RefinedPatch_h
#define ridges_RefinedPatch_h

#include "Monge/MongeField.h"
#include "Ridges/Patch/PatchContour.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ridges
{

struct PatchTriangleForms;

/**
 * The triangles of a patch around an umbilic cut into many small ones, with the extremality of the
 * interpolated Monge form at their corners. So near to an umbilic its triangle is cut into rings
 * around it, ever smaller ones towards the umbilic, on rays that keep the ridges apart that start
 * there. What is left is a small hole; each ridge of the umbilic crosses its rim once.
 *
 * Along the edges of the mesh, values are those of MongeInterpolation, so that what an edge is
 * crossed by fits to whether the edge of the mesh is.
 */
class RefinedPatch
{
public:
  using Corners = std::array<int, 3>;

  /// A part of an edge of the mesh, between fractions of the way from the first of EndsInOrder.
  struct Part
  {
    Id edge;
    double from;
    double to;
  };

  RefinedPatch(const TriangleMesh& mesh, const MongeField& field, Color color,
    const std::vector<Id>& triangles, Id umbilic);

  /// False if the interpolated form has no umbilic inside that triangle.
  bool IsValid() const { return this->IsValid_; }

  /// Oriented as the triangles of the mesh.
  const std::vector<Corners>& Triangles() const { return this->Triangles_; }
  /// The triangle of the mesh that a small one is in.
  Id OwnerOf(int triangle) const { return this->Owners_[triangle]; }

  /// The corners of the rings around the umbilic, each in order, from the border of its triangle to
  /// the hole; those of the same number are on one ray.
  const std::vector<std::vector<int>>& Rings() const { return this->Rings_; }

  /// Of a side between two corners, in either direction.
  static std::uint64_t Key(int v, int w);

  int NumberOfCorners() const { return static_cast<int>(this->Vertices_.size()); }
  const Eigen::Vector3d& Position(int v) const { return this->Vertices_[v].position; }
  bool IsCrossed(int v, int w) const;

  /// The part of an edge of the mesh between two corners, from v to w; its edge is -1 if they are
  /// not both on one.
  Part PartBetween(int v, int w) const;
  /// Where that is crossed.
  double ParameterOn(const Part& part, int v, int w) const;

private:
  struct Vertex
  {
    Eigen::Vector3d position;
    Eigen::Vector3d d1;
    double extremality;
  };
  struct EdgeVertices
  {
    std::vector<std::pair<double, int>> all; ///< From the first of EndsInOrder.
    std::vector<int> even;                   ///< Those at equal distances.
  };

  /// An edge of the mesh, and whether it starts at a point in the order of EndsInOrder.
  struct DirectedEdge
  {
    Id edge;
    bool forward;
  };

  DirectedEdge EdgeBetween(Id triangle, Id p, Id q) const;
  int AddOnEdge(Id edge, double parameter);
  int AddInside(const PatchTriangleForms& forms, const Eigen::Vector3d& weights);
  int AtPoint(Id point);
  EdgeVertices& OnEdge(Id edge);
  void AddToEdge(Id edge, double parameter);
  void NoteParts(Id edge);
  /// On the edge between two corners, from p.
  std::vector<int> EvenFrom(Id triangle, Id p, Id q);
  void Cut(Id triangle);
  void CutAroundUmbilic(const PatchTriangleForms& forms);
  bool AddRays(const PatchTriangleForms& forms);
  void AddTriangle(Id owner, const Corners& corners);

  const TriangleMesh& Mesh_;
  MongeField Field_;
  Color Color_;
  bool IsValid_ = false;
  std::vector<Vertex> Vertices_;
  std::vector<Corners> Triangles_;
  std::vector<Id> Owners_;
  std::vector<std::vector<int>> Rings_;
  std::unordered_map<Id, int> OfPoint_;
  std::unordered_map<Id, EdgeVertices> OfEdge_;
  std::unordered_map<std::uint64_t, Part> Parts_;               ///< From the smaller number.
  std::unordered_map<std::uint64_t, std::vector<int>> Between_; ///< From the smaller number.
};

} // namespace ridges

#endif
