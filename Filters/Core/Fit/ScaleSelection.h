// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_ScaleSelection_h
#define ridges_ScaleSelection_h

#include "Fit/JetFit.h"
#include "Mesh/RingNeighborhood.h"

#include <Eigen/Cholesky>

#include <array>
#include <vector>

namespace ridges
{

/// The second derivatives of the surface at one vertex, fitted to 2, 3, ... 8 rings around it over
/// one and the same plane.
struct ScaleTrial
{
  static constexpr int FewestRings = 2;
  static constexpr int MostRings = 8;
  static constexpr int NumberOfScales = MostRings - FewestRings + 1;

  struct Fit
  {
    double radius = 0.0;
    std::array<double, 3> second{}; ///< uu, uv, vv.
    double spread = 0.0;  ///< Variance of the tensor they are, for heights of unit variance.
    double squares = 0.0; ///< Sum of the squared heights left over.
    int freedom = 0;      ///< Points less coefficients.
  };

  bool usable = false;
  std::array<Fit, NumberOfScales> fits{};

  /// What a polynomial two degrees higher leaves over at the second scale: hardly anything of the
  /// surface, but all of the noise.
  double noiseSquares = 0.0;
  int noiseFreedom = 0;
};

/// Makes the trials. Holds scratch memory: use one per thread.
class ScaleProbe
{
public:
  /// A scale that has less than `minimumNumberOfPoints` takes more rings.
  ScaleProbe(
    const TriangleMesh& mesh, const OrderedRings& rings, int degree, int minimumNumberOfPoints);

  /// Not usable where not even the smallest scale determines the polynomial well.
  ScaleTrial Try(Id vertex);

private:
  void AddPoints(Id vertex, Span<Id> points, const JetFit& smallest);
  bool FitPoints(double unit, ScaleTrial::Fit& fit);
  void FitHigherDegree(double unit, ScaleTrial& trial);

  const TriangleMesh& Mesh_;
  RingNeighborhood Neighborhood_;
  NeighborhoodRule Rule_;
  int Degree_;
  JetFitter Fitter_;
  Eigen::Matrix3Xd Offsets_;
  Eigen::MatrixXd Monomials_; ///< A column per point.
  Eigen::MatrixXd HigherMonomials_;
  Eigen::VectorXd Heights_;
  Eigen::MatrixXd Normal_;
  Eigen::VectorXd Projected_;
  Eigen::LLT<Eigen::MatrixXd> Solver_;
  Eigen::Index Count_ = 0; ///< Points in what stands above.
};

/// Some 2000 points, or all of a smaller mesh, in an order: both depend on coordinates only. Points
/// that coincide are left out, as nothing tells them apart.
std::vector<Id> ScaleSample(const TriangleMesh& mesh);

/**
 * The number of rings at which curvatures have the least error, by trials over a sample of a mesh.
 *
 * Noise at the points gives an error that falls with the scale, and its variance is known from that
 * of the noise, which the heights left over tell. What the polynomial cannot follow
 * gives one that grows with the scale: fits to nested neighbourhoods differ by the difference of
 * their variances, and what they differ more is the growth of this error.
 */
int SelectNumberOfRings(const std::vector<ScaleTrial>& trials, int degree);

} // namespace ridges

#endif
