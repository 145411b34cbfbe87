// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_CurveOrder_h
#define ridges_CurveOrder_h

#include "Mesh/TriangleMesh.h"

namespace ridges
{

/**
 * The points along a curve through space that fills it (Morton's): points that are near each other
 * are mostly near each other in this list, whatever their ids.
 *
 * What goes over all points again and again and looks at their neighbours is several times as fast
 * in this order, once the mesh is larger than the caches.
 */
std::vector<Id> PointsAlongCurve(const TriangleMesh& mesh);

/// The same of the first points of a mesh alone.
std::vector<Id> PointsAlongCurve(const TriangleMesh& mesh, Id count);

} // namespace ridges

#endif
