// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_UmbilicForm_h
#define ridges_UmbilicForm_h

#include "Base/SymmetricTensor.h"
#include "Mesh/TriangleMesh.h"
#include "Monge/MongeField.h"

namespace ridges
{

/// The corners of a triangle from that which comes first (FieldOrder.h): what is computed from them
/// in this order does not depend on the numbering.
Triangle CornersInOrder(const TriangleMesh& mesh, const MongeField& field, Id triangle);

/**
 * The traceless part of the second fundamental form at the corners of a triangle, in one frame of
 * its plane, a column each. It is a vector of length k1 - k2 that turns twice as fast as d1, and
 * vanishes at umbilics.
 */
Eigen::Matrix<double, 2, 3> TracelessForms(
  const TriangleMesh& mesh, const MongeField& field, const Triangle& corners);

/**
 * The umbilic of a singular triangle, as barycentric weights of its corners, in order: where the
 * traceless part of the second fundamental form, interpolated linearly between the corners,
 * vanishes, or else where on the sides it is least. Second-order accurate.
 */
Eigen::Vector3d UmbilicWeights(const TriangleMesh& mesh, const MongeField& field, Id triangle);

/// The point with these weights.
Eigen::Vector3d UmbilicInTriangle(const TriangleMesh& mesh, const MongeField& field, Id triangle);

/**
 * The cubic form b0 x^3 + 3 b1 x^2 y + 3 b2 x y^2 + b3 y^3 at the point with these weights in a
 * triangle: the mean of those of its corners, each turned into one frame of the triangle's plane
 * first. (Near an umbilic the principal frames of neighbours differ by any angle, so that a mean of
 * their coefficients means nothing.)
 */
SymmetricTensor<3> CubicFormAt(
  const TriangleMesh& mesh, const MongeField& field, Id triangle, const Eigen::Vector3d& weights);

/// The number of real roots of the cubic form, as directions: 1 or 3.
int RidgeCountOf(const SymmetricTensor<3>& cubicForm);

/// Sign of S = (b0 - b2) b2 - b1 (b1 - b3), section 8.2: that of the index.
int ThirdOrderIndexOf(const SymmetricTensor<3>& cubicForm);

/// How the curvature lines run around an umbilic, after Darboux.
enum class UmbilicPattern : std::uint8_t
{
  Lemon = 1,   ///< Index +1/2, one line of each colour runs into it.
  Monstar = 2, ///< Index +1/2, three lines of each colour do.
  Star = 3     ///< Index -1/2, three lines of each colour do.
};

/**
 * The pattern of an umbilic of this index: the directions of the lines that run into it are those
 * where the cubic form is extremal on the circle, one or three.
 */
UmbilicPattern PatternOf(const SymmetricTensor<3>& cubicForm, double index);

} // namespace ridges

#endif
