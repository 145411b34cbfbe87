// SPDX-License-Identifier: BSD-3-Clause
// Polylines of vtkRidgeExtraction as a graph on the edges of the mesh, found again without the
// library's help.

#ifndef RidgeGraph_h
#define RidgeGraph_h

#include "vtkPolyData.h"

namespace ridges
{
namespace testing
{

/// Checks every crossing of both colours on a mesh with Monge arrays: each edge that a colour
/// crosses by the acute rule is a point of its ridges, which go on from there on the other side;
/// they end on borders, at non-manifold edges and in singular triangles only, and each of those
/// has its end or ends. The points lie where their edges and parameters say.
void ExpectCompleteRidgeGraph(vtkPolyData* mesh, vtkPolyData* ridges);

/// Consecutive polylines of a ridge share their end point; a closed ridge comes back.
void ExpectJoinedPolylines(vtkPolyData* ridges);

} // namespace testing
} // namespace ridges

#endif
