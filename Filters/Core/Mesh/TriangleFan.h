// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_TriangleFan_h
#define ridges_TriangleFan_h

#include "Mesh/TriangleMesh.h"

namespace ridges
{

/// A corner of a triangle.
struct FanCorner
{
  Id triangle;
  int corner;
};

/// The size of a fan, and whether its last triangle is joined to its first.
struct FanExtent
{
  Id size = 0;
  bool closed = false;
};

/**
 * The fan that a triangle belongs to at one of its corners: the triangles that are joined by edges
 * at this point, one after the other in the sense of their orientation. A fan ends at an edge that
 * does not have two triangles of one orientation.
 *
 * `fan` has to have room for as many as there are triangles around the point. A closed fan begins
 * with the triangle asked for, an open one where it begins.
 */
FanExtent GatherFan(const TriangleMesh& mesh, FanCorner from, FanCorner* fan);

} // namespace ridges

#endif
