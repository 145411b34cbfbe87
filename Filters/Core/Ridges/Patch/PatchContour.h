// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PatchContour_h
#define ridges_PatchContour_h

#include "Mesh/TriangleMesh.h"

namespace ridges
{

/**
 * The contour of connected triangles, as one closed walk around them.
 *
 * They are taken as glued along all edges between them if that leaves one contour, as for a disk.
 * Else, where they enclose others or meet themselves, they are glued along the edges of a tree
 * only, as if cut along the rest: any connected triangles are a disk then.
 */
class PatchContour
{
public:
  /// A step of the walk: an edge of the contour, and what lies around the point at its end.
  struct Side
  {
    Id triangle; ///< Inside, next to the edge.
    Id edge;
    Id end;                 ///< The point that the walk comes to.
    std::vector<Id> spokes; ///< The inner edges at that point, in the order of the walk.
  };

  PatchContour(const TriangleMesh& mesh, const std::vector<Id>& triangles);

  const std::vector<Side>& Sides() const { return this->Sides_; }

  bool Contains(Id triangle) const { return this->Find(triangle) != nullptr; }

  /// The triangle across one of the edges of a triangle that it is glued to, or -1.
  Id Across(Id triangle, Id edge) const;

private:
  /// Where a walk is: on an edge of the contour, on the way to one of its ends.
  struct Place
  {
    Id triangle = -1; ///< Inside, next to the edge.
    Id edge = -1;
    Id end = -1;
  };

  /// A triangle inside, with a bit for each side that is glued.
  struct Glued
  {
    Id triangle;
    unsigned sides;
    bool Has(int side) const { return (this->sides >> side & 1U) != 0; }
    bool operator<(const Glued& other) const { return this->triangle < other.triangle; }
  };

  /// Null outside.
  const Glued* Find(Id triangle) const;
  void GlueAll(const std::vector<Id>& triangles);
  void GlueTree(Id root);
  std::size_t NumberOfSides() const;
  /// Walks around the triangles; false if there is not one contour.
  bool Walk();
  bool FindStart(Place& start) const;
  /// The side that a walk passes from here to the next place.
  Side Advance(Place& place) const;

  const TriangleMesh& Mesh_;
  std::vector<Glued> Glued_; ///< By triangle.
  std::vector<Side> Sides_;
};

} // namespace ridges

#endif
