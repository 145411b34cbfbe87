// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SurfaceWalk_h
#define ridges_SurfaceWalk_h

#include "Foliation/FlatTriangle.h"

#include <cstdint>
#include <vector>

namespace ridges
{

/// What a walk follows: the curvature line of a colour, or its own direction, straight on.
enum class WalkRule
{
  Blue,
  Red,
  Straight
};

/**
 * A walk over the triangles of a mesh, a step inside one triangle after the other. From a triangle
 * to the next its direction is folded over the edge between them.
 *
 * A step goes along the direction half way of it (the midpoint rule), to the edge if that is near
 * enough; it is halved until the direction turns by less than 0.05 radians to half way.
 */
class SurfaceWalk
{
public:
  /// Triangles t with closed[t] != 0 are not entered. All has to outlive the walk.
  SurfaceWalk(
    const TriangleMesh& mesh, const MongeField& field, const std::vector<std::uint8_t>& closed);

  /// Begins at a point of a triangle, on the side of `along`.
  void Start(
    WalkRule rule, Id triangle, const Eigen::Vector3d& point, const Eigen::Vector2d& along);

  /**
   * A step, no longer than half as much again as `longest`. False where there is none: at borders
   * and non-manifold edges, before closed triangles and those without area, at an umbilic, and
   * where the directions of neighbours are so far apart that there is no way between them.
   */
  bool Step(double longest);

  /// The triangle of the last step, which holds both its ends.
  Id CurrentTriangle() const { return this->Triangle_; }
  const FlatTriangle& Face() const { return this->Face_; }
  const Eigen::Vector3d& Position() const { return this->Position_; }
  const Eigen::Vector2d& FlatPosition() const { return this->Flat_; }
  /// In the plane of the current triangle.
  const Eigen::Vector2d& Direction() const { return this->Direction_; }
  double StepLength() const { return this->StepLength_; }

private:
  struct Exit
  {
    int side = -1;
    double distance = 0.0;
  };

  bool Cross();
  Eigen::Vector2d DirectionAt(const Eigen::Vector2d& flat, const Eigen::Vector2d& along) const;
  Eigen::Vector2d TurnedInward(const Eigen::Vector2d& direction) const;
  Exit FindExit(const Eigen::Vector2d& direction) const;
  bool MakesProgress();

  const TriangleMesh& Mesh_;
  MongeField Field_;
  const std::vector<std::uint8_t>& Closed_;

  WalkRule Rule_ = WalkRule::Straight;
  Id Triangle_ = 0;
  FlatTriangle Face_;
  Eigen::Vector2d Flat_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d Direction_ = Eigen::Vector2d::UnitX();
  Eigen::Vector3d Position_ = Eigen::Vector3d::Zero();
  double StepLength_ = 0.0;
  int EntrySide_ = -1; ///< The side on which the next step starts, if it does.
  int ExitSide_ = -1;  ///< The side that the last step ended on, if it did.
  int ShortSteps_ = 0;
};

} // namespace ridges

#endif
