// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_UmbilicDetection_h
#define ridges_UmbilicDetection_h

#include "AcuteRule.h"
#include "SymmetricTensor.h"
#include "UmbilicPatch.h"

namespace ridges
{

/// A point where k1 = k2, and the patch of triangles that stands for its neighbourhood.
struct Umbilic
{
  Id triangle; ///< The singular triangle where it lies: a ridge's end, see MarchingTriangles.h.
  Eigen::Vector3d position;
  double index;        ///< +1/2 or -1/2: turns of d1 around it.
  int ridgeCount;      ///< Ridges of each colour that meet there: 1 or 3.
  int thirdOrderIndex; ///< Sign of S (section 8.2): the sign of the index, from third order.
  std::vector<Id> patch;
};

/// The value of k1 - k2 that a triangle is judged by: the mean of those at its corners.
double TriangleGap(const TriangleMesh& mesh, const MongeField& field, Id triangle);

/**
 * Whether no triangle that shares a corner with this one has a smaller gap. As a patch contains
 * these triangles, only such a triangle can minimise the gap over its patch: a cheap first test.
 */
bool MinimizesGapInOneRing(const TriangleMesh& mesh, const MongeField& field, Id triangle);

/**
 * Turns of the direction field d1 along a closed contour of points, in the chart that projects on
 * the plane with this normal, counted counter-clockwise: a multiple of 1/2.
 */
double ContourIndex(
  const MongeField& field, const std::vector<Id>& contour, const Eigen::Vector3d& normal);

/**
 * The cubic form b0 x^3 + 3 b1 x^2 y + 3 b2 x y^2 + b3 y^3 of a triangle: the mean over its
 * corners, each turned into one frame of the triangle's plane first. (Near an umbilic the principal
 * frames of neighbours differ by any angle, so that a mean of their coefficients means nothing.)
 */
SymmetricTensor<3> TriangleCubicForm(
  const TriangleMesh& mesh, const MongeField& field, Id triangle);

/// The number of real roots of the cubic form, as directions: 1 or 3.
int RidgeCountOf(const SymmetricTensor<3>& cubicForm);

/// Sign of S = (b0 - b2) b2 - b1 (b1 - b3), section 8.2.
int ThirdOrderIndexOf(const SymmetricTensor<3>& cubicForm);

/**
 * The umbilics of a mesh after section 8: triangles that minimise k1 - k2 over their patch and on
 * whose contour the index is +1/2 or -1/2, by growing gap. Where two patches would share a
 * triangle the one of smaller gap stands, so that no umbilic is counted twice.
 */
class UmbilicDetector
{
public:
  UmbilicDetector(const TriangleMesh& mesh, const MongeField& field, double patchSize);

  /// Whether the triangle is a candidate; the costly part, one call per triangle.
  bool Minimizes(Id triangle);

  /// The umbilics among candidate triangles.
  std::vector<Umbilic> Select(std::vector<Id> candidates);

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
