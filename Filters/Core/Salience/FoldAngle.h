// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_FoldAngle_h
#define ridges_FoldAngle_h

#include "Salience/CurvatureWalk.h"

#include <vector>

namespace ridges
{

/// By how much a surface folds across a ridge.
struct Fold
{
  double angle = 0.0; ///< In radians.
  double width =
    0.0; ///< Of the stretch that folds, along the curvature line, in the unit of the points.
  double height = 0.0; ///< Curvature at the ridge less that at the foot of its feature.
  double foot = 0.0;   ///< That at the foot.
};

/// Folds at the vertices of a ridge; those that are not at edges with an elliptic piece have none.
using RidgeFolds = std::vector<Fold>;

/// How folds are measured. Lengths are in the unit of the points.
struct FoldRule
{
  double reach = 0.0; ///< How far a walk goes at most.
  double slack = 0.0; ///< A higher curvature within this distance is the same peak.
  double floor = 0.0; ///< What curvature has to exceed that of the foot by to count.
};

/**
 * The fold angle of a point of an elliptic ridge: by how much the surface turns there more than at
 * the foot of its feature.
 *
 * From the point a walk follows the curvature line to both sides, and watches f: k1 on blue ridges,
 * -k2 on red ones. It ends where f is higher than at the ridge, at the border, at an umbilic, after
 * `reach`, or after 10,000 triangles. The foot is the higher of the lowest f at the two sides, as
 * for the prominence of a mountain, and not below 0. The fold angle is the integral of f less the
 * foot and the floor, as long as that is positive around the point. It is 0 on spheres, planes,
 * cylinders, cones and tori, and the angle between its two sides at a sharp crease.
 *
 * Holds scratch memory: use one per thread.
 */
class FoldMeter
{
public:
  FoldMeter(const TriangleMesh& mesh, const MongeField& field, const FoldRule& rule);

  /// At a point of an edge.
  Fold Measure(Color color, Id edge, const Eigen::Vector3d& point);

private:
  struct Sample
  {
    double arc;
    double f;
  };
  using Samples = std::vector<Sample>;

  double Walk(Color color, Id triangle, Id edge, const Eigen::Vector3d& point, double stop,
    double& peak, Samples& samples);
  /// The part of one side.
  static Fold FoldOf(const Samples& samples, double foot);

  const TriangleMesh& Mesh_;
  FoldRule Rule_;
  CurvatureWalk Walk_;
  Samples Left_;
  Samples Right_;
};

} // namespace ridges

#endif
