// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
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
/// has its end or ends. The points lie where their edges and parameters say, turning points on the
/// piece between two such.
///
/// If umbilics are marked on the mesh that is so outside their patches and the regions where they
/// have cancelled each other, contours included. Inside, ridges end nowhere but at the umbilic,
/// as many as have to meet there as far as enough cross the contour.
void ExpectCompleteRidgeGraph(vtkPolyData* mesh, vtkPolyData* ridges);

/// Pieces run inside triangles, and none crosses another of its colour there.
void ExpectNoRidgesCross(vtkPolyData* mesh, vtkPolyData* ridges);

/// Consecutive polylines of a ridge share their end point; a closed ridge comes back. Ids count
/// the ridges in the order of the polylines.
void ExpectJoinedPolylines(vtkPolyData* ridges);

} // namespace testing
} // namespace ridges

#endif
