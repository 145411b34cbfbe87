// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_EvenTriangles_h
#define ridges_EvenTriangles_h

#include "Formula/EdgeOperations.h"
#include "Formula/ExactSurface.h"
#include "Formula/ExampleSurface.h"

namespace ridges
{

/// How often MakeEven runs a loop.
constexpr int MakeEvenLoops = 32;

/**
 * Makes the triangles of a mesh near a surface even, with edges of about a length and points on the
 * surface: long edges are divided, short ones contracted, others flipped to Delaunay's rule, and
 * points moved to the middle of their triangles and back to the surface, over and over. The border
 * stays as it is. The same for any loop. False if the loop was stopped; outside of loops the
 * monitor is told the fraction of a pass.
 *
 * All this is done on a surface that may be rough, and so fast; at the end points move from there
 * to the other one, if it is another.
 */
bool MakeEven(EditableMesh& mesh, const ExactSurface& rough, const ExactSurface& surface,
  double edgeLength, const StoppableLoop& loop = LoopAtOnce, const Monitor& monitor = NeverStops);

} // namespace ridges

#endif
