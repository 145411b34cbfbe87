// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PatchTriangleForms_h
#define ridges_PatchTriangleForms_h

#include "Base/SymmetricTensor.h"
#include "Mesh/TriangleMesh.h"
#include "Monge/MongeField.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace ridges
{

/// The second and third-order forms at the corners of a triangle in one frame of its plane, and
/// what they are between: linear.
struct PatchTriangleForms
{
  PatchTriangleForms(const TriangleMesh& mesh, const MongeField& field, Id triangle);

  /// The angle of d1 with e1.
  double AngleAt(const Eigen::Vector3d& weights) const;
  Eigen::Vector3d DirectionAt(double angle) const;
  double ExtremalityAt(const Eigen::Vector3d& weights, Color color, double angle) const;

  /// How far the third order at the corners is from this one, over the size of it.
  double SpreadAround(const SymmetricTensor<3>& third) const;

  /// At the umbilic, by how much the slopes of the second order differ from the third order, which
  /// they are on a smooth surface, over the size of the latter.
  double DifferenceOfOrders(
    const TriangleMesh& mesh, const SymmetricTensor<3>& thirdAtUmbilic) const;

  SymmetricTensor<3> ThirdOrderAt(const Eigen::Vector3d& weights) const;

  /// How the weights change from the umbilic on to where d1 has this angle; 0 if there is no such
  /// way.
  Eigen::Vector3d WayTo(double angle) const;

  Id triangle;
  Triangle corners; ///< In order.
  Eigen::Vector3d e1;
  Eigen::Vector3d e2;
  Eigen::Matrix<double, 2, 3> second; ///< The traceless part, as of UmbilicForm.h.
  std::array<SymmetricTensor<3>, 3> third;
};

/// The angles in [0, pi) where a binary cubic form vanishes, in order: one or three.
std::vector<double> RootAngles(const SymmetricTensor<3>& form);

} // namespace ridges

#endif
