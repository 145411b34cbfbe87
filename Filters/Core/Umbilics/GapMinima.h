// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_GapMinima_h
#define ridges_GapMinima_h

#include "Base/Monitor.h"
#include "Umbilics/Umbilic.h"
#include "Umbilics/UmbilicPatch.h"

namespace ridges
{

/// The value of k1 - k2 that a triangle is judged by: the mean of those at its corners.
double TriangleGap(const TriangleMesh& mesh, const MongeField& field, Id triangle);

/// The triangle of the least gap around a point; of equal ones the first by position. -1 if there
/// is none.
Id SmallestGapAround(const TriangleMesh& mesh, const MongeField& field, Id point);

/**
 * Whether no triangle that shares a corner with this one has a smaller gap, given that of the least
 * around every point. As a patch contains these triangles, only such a triangle can minimise the
 * gap over its patch: a cheap first test. Of equal ones the first by position passes.
 */
bool MinimizesGapInOneRing(
  const TriangleMesh& mesh, const std::vector<Id>& smallestAround, Id triangle);

/**
 * Turns of the direction field d1 along a closed contour of points, in the chart that projects on
 * the plane with this normal, counted counter-clockwise: a multiple of 1/2.
 */
double ContourIndex(
  const MongeField& field, const std::vector<Id>& contour, const Eigen::Vector3d& normal);

/**
 * The umbilics of a mesh after section 8: triangles that minimise k1 - k2 over their patch and on
 * whose contour the index is +1/2 or -1/2, by growing gap. Where two patches would share a
 * triangle the one of smaller gap stands, so that no umbilic is counted twice.
 */
class GapMinima
{
public:
  GapMinima(const TriangleMesh& mesh, const MongeField& field, double patchSize);

  /// Whether a triangle that does so in its one-ring minimises the gap over its patch.
  bool Minimizes(Id triangle);

  /// The umbilics among candidate triangles; none if the monitor stops it.
  std::vector<Umbilic> Select(std::vector<Id> candidates, const Monitor& monitor = NeverStops);

private:
  /// The singular triangle of a patch nearest to its first triangle, or that one if there is none.
  Id NearestSingularTriangle(Span<Id> patch) const;

  const TriangleMesh& Mesh_;
  MongeField Field_;
  double PatchSize_;
  UmbilicPatch Patch_;
};

} // namespace ridges

#endif
