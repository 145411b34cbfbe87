// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_JetTrial_h
#define ridges_JetTrial_h

#include "Fit/LegendreSums.h"
#include "Mesh/RingNeighborhood.h"

#include <Eigen/Core>

#include <array>
#include <unordered_map>
#include <vector>

namespace ridges
{

/**
 * What polynomials of degree 2, 4, 6, 8 and 10 make of the points around one vertex, all fitted to
 * the same heights over one plane.
 *
 * In a basis that is orthonormal over the points and graded by degree, the coefficients of one
 * degree are those of the next without the last: each pair of degrees adds a band of coefficients.
 * White noise has the same variance in all of them. What a degree leaves out of the derivatives of
 * the surface is what the bands above it add.
 */
struct JetTrial
{
  static constexpr int NumberOfBands = 5;
  static constexpr int DegreeOf(int band) { return 2 * (band + 1); }

  /// The tensor of the derivatives of one order, off the diagonal counted as often as it is there.
  struct Derivative
  {
    std::array<double, 4> values{}; ///< Of order 2: uu, uv, vv. Of order 3: uuu, uuv, uvv, vvv.
    double variance = 0.0;          ///< Of the tensor's norm, for heights of unit variance.
  };

  /// What a band adds.
  struct Band
  {
    Derivative second;
    Derivative third;
    double meanSquare = 0.0; ///< Of the heights: the variance of noise, where it is all there is.
  };

  int bands = 0; ///< That the points determine well.
  double radius = 0.0;
  bool isSteep = false; ///< Whether the surface turns by more than 44 degrees somewhere.

  /// Of the heights left over by all these bands, on few points: the variance of noise, if none of
  /// the surface is left. `freedom` is how many more points than coefficients there are.
  double variance = 0.0;
  int freedom = 0;
  std::array<Band, NumberOfBands> band{};
};

/// What a fit leaves over at a vertex and beside it, in units of its rms over all points: else the
/// few places that polynomials cannot follow would be all that counts.
struct JetRemains
{
  double own = 0.0;    ///< At the vertex.
  double around = 0.0; ///< Mean of its neighbours.

  /// Of noise of unit variance that is independent from point to point: the variance of the one,
  /// and the covariance of both.
  double variance = 0.0;
  double covariance = 0.0;
};

/**
 * How much of the heights that fits leave over is the same at neighbours: about 0 where noise is
 * independent from point to point, up to 1 where it was smoothed or resampled, or where it is not
 * noise that is left over, but the surface.
 */
double NeighborCorrelation(const std::vector<JetRemains>& remains);

/// Makes the trials. Holds scratch memory: use one per thread.
class JetProbe
{
public:
  /// With hardly more points than coefficients a polynomial follows any noise.
  static constexpr int FewestPoints(int degree) { return (degree + 1) * (degree + 2) * 3 / 5; }

  JetProbe(const TriangleMesh& mesh, const OrderedRings& rings);

  /// With the points of some rings, in degrees up to that of the last band.
  JetTrial Try(Id vertex, int numberOfRings, int bands = JetTrial::NumberOfBands);

  /// All zero if there is no fit.
  JetRemains RemainsOf(Id vertex, int numberOfRings, int degree);

private:
  Eigen::Vector3d NormalAt(Id point);
  bool SetHeights(Id vertex, int numberOfRings);
  bool IsSteep() const;
  void TurnToPrincipalAxes();
  void SetBasis(int degree);
  void AddBands(int bands, JetTrial& trial);
  void AddVariance(const Eigen::VectorXd& coefficients, JetTrial& trial);

  const TriangleMesh& Mesh_;
  RingNeighborhood Neighborhood_;
  std::unordered_map<Id, Eigen::Vector3d> NormalsOfLargeFans_; ///< Beside many of the vertices.
  double Radius_ = 0.0;
  bool IsSteep_ = false;
  Eigen::Matrix3Xd Local_;  ///< Offsets over the plane, in units of the extents and the radius.
  Eigen::Vector2d Extents_; ///< Along the principal axes, in units of the radius.
  LegendreSums Sums_;
  Eigen::MatrixXd Basis_; ///< A column per point.
};

} // namespace ridges

#endif
