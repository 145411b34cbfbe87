// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RidgeTrace_h
#define ridges_RidgeTrace_h

#include "Ridges/RidgeAssembly.h"

#include <functional>

namespace ridges
{

/// A point of a ridge: on an edge of the mesh, at an umbilic, or, where neither, a turning point
/// inside a triangle.
struct RidgeVertex
{
  static constexpr Id None = -1;

  RidgePoint point;
  Id edge = None;
  Id umbilic = None; ///< The triangle of the umbilic.
};

/**
 * A whole ridge as a polyline: a type for each piece between two vertices. A loop repeats its first
 * vertex at its end.
 */
struct RidgeTrace
{
  std::vector<RidgeVertex> vertices;
  std::vector<RidgeType> types;
  bool closed = false;

  /// Of each piece, what SureLengthsOf in TypeRuns.h gives; empty if it was not asked for.
  std::vector<double> sureLengths;

  /// Whether a piece is a crest line: elliptic, and the own curvature is the larger in absolute
  /// value (section 7.2).
  bool IsCrest(Id piece) const;
};

/// What tracing asks about umbilics. Both may be empty: then umbilics lie where the forms of their
/// triangle say, and no triangle is in a patch.
struct UmbilicLookup
{
  std::function<Eigen::Vector3d(Id triangle)> positionOf;
  std::function<Id(Id triangle)> patchOf; ///< Negative outside.
};

/**
 * The polyline of a ridge. By the fourth order its type changes where P, linear between two
 * crossings, is zero: a vertex is put there. From an umbilic to the contour of its patch it is
 * hyperbolic (section 6.5): there neighbours' frames differ by any angle, and P means little.
 */
RidgeTrace TraceRidge(const Ridge& ridge, const std::vector<RidgeSegment>& segments,
  const std::vector<RidgePath>& paths, const RidgeCrossings& crossings, TypeRule rule,
  const UmbilicLookup& umbilics);

/// A run of pieces [first, last) of one type, and all or none of them crest lines.
struct RidgeRun
{
  Id first;
  Id last;
};

/// The runs of a ridge in order. Those of a loop are whole if it was made canonical.
std::vector<RidgeRun> RunsOf(const RidgeTrace& trace);

/**
 * Turns a ridge so that its start and sense do not depend on the numbering: it starts at the end
 * that comes first by x, then y, then z, a loop at the first of its points where a run starts. Of
 * points at one place, as where a ridge passes through points of the mesh, that is first whose edge
 * is.
 */
void MakeCanonical(const TriangleMesh& mesh, RidgeTrace& trace);

/// Lets a loop start at another of its vertices.
void RotateLoop(RidgeTrace& trace, std::size_t start);

/// An order of canonical ridges by their points.
bool ComesBefore(const TriangleMesh& mesh, const RidgeTrace& a, const RidgeTrace& b);

} // namespace ridges

#endif
