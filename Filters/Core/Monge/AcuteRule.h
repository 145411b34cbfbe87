// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_AcuteRule_h
#define ridges_AcuteRule_h

#include "Mesh/TriangleMesh.h"
#include "Monge/MongeField.h"

namespace ridges
{

/**
 * The acute rule (RR-5294, definition 3): the frames at the ends of an edge are turned so that
 * their d1 make an acute angle. +1 where the stored ones already do, -1 where one of them is to
 * be turned. A right angle counts as acute: then every edge has a sign, and the crossings of an
 * edge do not depend on the side from which it is looked at.
 */
inline int AcuteSign(const MongeField& field, Id p, Id q)
{
  return field.D1(p).dot(field.D1(q)) >= 0.0 ? 1 : -1;
}

/// Sign of an extremality. Zero counts as positive in the stored frame, so that no crossing of
/// the edges around such a point is lost.
inline int ExtremalitySign(double b)
{
  return b >= 0.0 ? 1 : -1;
}

/// Whether a ridge of the colour crosses the edge between p and q (observation 2).
inline bool IsCrossed(const MongeField& field, Color color, Id p, Id q)
{
  return AcuteSign(field, p, q) * ExtremalitySign(field.Extremality(color, p)) *
    ExtremalitySign(field.Extremality(color, q)) <
    0;
}

/// Where the crossing lies, as a fraction of the way from p to q: equation (4).
double CrossingParameter(double extremalityAtP, double extremalityAtQ);

/**
 * Whether the acute rule is coherent around a triangle: the product of the signs of its edges is
 * +1. Each colour crosses a regular triangle's edges 0 or 2 times, a singular one's 1 or 3 times:
 * the signs of the extremality cancel in the product over the three edges. A singular triangle is
 * thus a discrete umbilic of index +1/2 or -1/2.
 */
bool IsRegular(const TriangleMesh& mesh, const MongeField& field, Id triangle);

} // namespace ridges

#endif
