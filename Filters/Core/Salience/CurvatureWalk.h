// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_CurvatureWalk_h
#define ridges_CurvatureWalk_h

#include "Monge/AcuteRule.h"

#include <array>
#include <vector>

namespace ridges
{

/**
 * A walk along a curvature line, from edge to edge of the mesh, that watches the curvature.
 *
 * SurfaceWalk follows the same lines more carefully, and about 20 times as slowly. Here each
 * triangle is one step of the midpoint rule. Triangles are laid into the plane as FlatTriangle does
 * it; those met last are kept, as the walks of neighbouring points of a ridge meet the same ones.
 *
 * No result depends on how points and triangles are numbered. Holds scratch memory: use one per
 * thread.
 */
class CurvatureWalk
{
public:
  CurvatureWalk(const TriangleMesh& mesh, const MongeField& field);

  /// Begins at a point of an edge and goes into one of its triangles. False if it has no area.
  bool Start(Color color, Id triangle, Id edge, const Eigen::Vector3d& point);

  /**
   * On to the next edge. False where there is no way: at borders and non-manifold edges, before
   * triangles without area, at an umbilic, and where the walk makes no progress.
   */
  bool Step();

  /// The colour's curvature at the current point.
  double Curvature() const { return this->Curvature_; }
  double StepLength() const { return this->StepLength_; }

private:
  /// A triangle in the plane: corner 0 at the origin, corner 1 on the first axis. Corner 0 is the
  /// first by position. Side i goes from corner i to the next.
  struct Face
  {
    Id triangle = -1;
    bool hasArea = false;
    std::array<Eigen::Vector2d, 3> corners;
    std::array<Id, 3> edges;
    std::array<bool, 3> forward; ///< Whether a side runs from the edge's first end by position.
    /// At the corners: k1 - k2 as a vector at twice the angle of d1, and k1 + k2.
    std::array<Eigen::Vector2d, 3> turnings;
    std::array<double, 3> sums;
  };

  const Face& FaceOf(Id triangle);
  void Fill(Face& face, Id triangle) const;
  Eigen::Vector2d TurningAt(Id p, const Eigen::Vector3d& axisX, const Eigen::Vector3d& axisY,
    const Eigen::Vector3d& normal) const;

  /// The values of the field at a point of the face.
  struct Local
  {
    Eigen::Vector2d turning;
    double sum;
  };
  Local At(const Face& face, const Eigen::Vector2d& x) const;
  /// On the side of `along`, of no particular length; zero at an umbilic.
  Eigen::Vector2d Direction(const Eigen::Vector2d& turning, const Eigen::Vector2d& along) const;
  Eigen::Vector2d TurnedInward(const Face& face, const Eigen::Vector2d& direction) const;
  int FindExit(const Face& face, const Eigen::Vector2d& x, const Eigen::Vector2d& direction,
    double& distance) const;
  double CurvatureOf(const Local& local) const;

  const TriangleMesh& Mesh_;
  MongeField Field_;
  std::vector<Face> Faces_;

  Color Color_ = Color::Blue;
  Id Triangle_ = 0;
  int Side_ = 0;          ///< Of the triangle, which the walk enters through.
  double Fraction_ = 0.0; ///< Of that side, from its start.
  double Along_ = 0.0;    ///< The direction in which it enters: along the side,
  double Inward_ = 1.0;   ///< and from it into the triangle.
  bool HasNext_ = false;  ///< Whether there is a triangle to enter.
  double Curvature_ = 0.0;
  double StepLength_ = 0.0;
  int ShortSteps_ = 0;
};

} // namespace ridges

#endif
