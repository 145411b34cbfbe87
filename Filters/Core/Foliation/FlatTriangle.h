// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_FlatTriangle_h
#define ridges_FlatTriangle_h

#include "Mesh/TriangleMesh.h"
#include "Monge/MongeField.h"

#include <array>

namespace ridges
{

/**
 * A triangle laid into the plane, with the principal directions over it.
 *
 * The second fundamental form of each corner is turned into the triangle's plane, by the smallest
 * turn, and interpolated linearly. The principal directions are those of its traceless part, which
 * is a vector at twice the angle of d1 and as long as k1 - k2: no sign has to be chosen for it, it
 * follows the acute rule along every edge, and it vanishes at umbilics only.
 *
 * Corners and edges are taken in the order of their coordinates, so that all results are the same,
 * to the bit, however points and triangles are numbered.
 */
class FlatTriangle
{
public:
  /// An edge, from the first to the second of its ends in the order of coordinates.
  struct Side
  {
    Id edge = 0; ///< Its number in the mesh.
    Id neighbor = TriangleMesh::Border;
    Eigen::Vector2d start = Eigen::Vector2d::Zero();
    Eigen::Vector2d along = Eigen::Vector2d::UnitX();
    Eigen::Vector2d inward = Eigen::Vector2d::UnitY();
    double length = 0.0;
  };

  FlatTriangle() = default;
  FlatTriangle(const TriangleMesh& mesh, const MongeField& field, Id triangle);

  /// Whether it has no area, so that it has no plane either.
  bool IsDegenerate() const { return !(this->Height_ > 0.0); }

  const Side& SideAt(int i) const { return this->Sides_[i]; }
  /// The side that is this edge of the mesh.
  int SideOf(Id edge) const;

  Eigen::Vector3d ToSpace(const Eigen::Vector2d& flat) const;
  Eigen::Vector2d ToFlat(const Eigen::Vector3d& point) const;
  Eigen::Vector2d Centroid() const;

  /// The principal direction of a colour, on the side of `along`; zero at an umbilic. Outside the
  /// triangle the forms are extrapolated.
  Eigen::Vector2d Direction(
    Color color, const Eigen::Vector2d& flat, const Eigen::Vector2d& along) const;

  double Curvature(Color color, const Eigen::Vector2d& flat) const;

  /// k1 - k2.
  double Gap(const Eigen::Vector2d& flat) const { return this->Turning(flat).stableNorm(); }

private:
  Eigen::Vector3d Weights(const Eigen::Vector2d& flat) const;
  Eigen::Vector2d Turning(const Eigen::Vector2d& flat) const;

  Eigen::Vector3d Origin_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d AxisX_ = Eigen::Vector3d::UnitX();
  Eigen::Vector3d AxisY_ = Eigen::Vector3d::UnitY();
  double Base_ = 0.0; ///< Corner 1 is (Base, 0),
  double Apex_ = 0.0; ///< corner 2 is (Apex, Height).
  double Height_ = 0.0;
  std::array<Side, 3> Sides_;
  Eigen::Matrix<double, 2, 3> Turnings_ = Eigen::Matrix<double, 2, 3>::Zero();
  Eigen::Vector3d Sums_ = Eigen::Vector3d::Zero(); ///< k1 + k2 of the corners.
};

} // namespace ridges

#endif
