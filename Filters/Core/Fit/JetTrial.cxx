// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/JetTrial.h"

#include "Monge/MongeForm.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

constexpr int HighestDegree = JetTrial::DegreeOf(JetTrial::NumberOfBands - 1);
static_assert(HighestDegree <= LegendreSums::HighestDegree, "sums are of too low a degree");

/// Of the derivatives uu, uv, vv, uuu, uuv, uvv, vvv.
constexpr int NumberOfDerivatives = 7;
constexpr int Orders[NumberOfDerivatives][2] = { { 2, 0 }, { 1, 1 }, { 0, 2 }, { 3, 0 }, { 2, 1 },
  { 1, 2 }, { 0, 3 } };

} // namespace

JetProbe::JetProbe(const TriangleMesh& mesh, const OrderedRings& rings)
  : Mesh_(mesh)
  , Neighborhood_(mesh, rings)
{
}

JetTrial JetProbe::Try(Id vertex, int numberOfRings, int bands)
{
  JetTrial trial;
  if (!this->SetHeights(vertex, numberOfRings))
  {
    return trial;
  }
  trial.radius = this->Radius_;
  trial.isSteep = this->IsSteep_;
  while (bands > 0 && this->Local_.cols() < FewestPoints(JetTrial::DegreeOf(bands - 1)))
  {
    --bands;
  }
  if (bands > 0)
  {
    this->Sums_.Add(this->Local_, JetTrial::DegreeOf(bands - 1));
    this->AddBands(bands, trial);
  }
  return trial;
}

JetRemains JetProbe::RemainsOf(Id vertex, int numberOfRings, int degree)
{
  JetRemains remains;
  if (!this->SetHeights(vertex, numberOfRings) || this->Local_.cols() < FewestPoints(degree))
  {
    return remains;
  }
  this->SetBasis(degree);
  const Eigen::Index size = this->Basis_.rows();
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(size, size);
  gram.selfadjointView<Eigen::Lower>().rankUpdate(this->Basis_);
  const Eigen::LLT<Eigen::MatrixXd> factor(gram.selfadjointView<Eigen::Lower>());
  if (factor.info() != Eigen::Success)
  {
    return remains;
  }
  const Eigen::VectorXd coefficients = factor.solve(this->Basis_ * this->Local_.row(2).transpose());
  const Eigen::VectorXd influence = factor.solve(this->Basis_.col(0));
  const Eigen::VectorXd heights =
    this->Local_.row(2).transpose() - this->Basis_.transpose() * coefficients;
  const double meanSquare = heights.squaredNorm() / static_cast<double>(heights.size());
  if (!(meanSquare > 0.0))
  {
    return remains;
  }
  // The vertex is the first of the points, its neighbours are the next ones.
  const auto last =
    std::min<Eigen::Index>(this->Mesh_.TrianglesAround(vertex).size(), this->Local_.cols() - 1);
  for (Eigen::Index i = 0; i <= last; ++i)
  {
    const double left = heights[i] / std::sqrt(meanSquare);
    const double shared = -this->Basis_.col(i).dot(influence);
    if (i == 0)
    {
      remains.own = left;
      remains.variance = 1.0 + shared;
      continue;
    }
    remains.around += left / static_cast<double>(last);
    remains.covariance += shared / static_cast<double>(last);
  }
  return remains;
}

double NeighborCorrelation(const std::vector<JetRemains>& remains)
{
  double square = 0.0;
  double product = 0.0;
  double variance = 0.0;
  double covariance = 0.0;
  for (const JetRemains& of : remains)
  {
    square += of.own * of.own;
    product += of.own * of.around;
    variance += of.variance;
    covariance += of.covariance;
  }
  return square > 0.0 && variance > 0.0 ? product / square - covariance / variance : 0.0;
}

Eigen::Vector3d JetProbe::NormalAt(Id point)
{
  if (this->Mesh_.TrianglesAround(point).size() <= OrderedRings::LargestFan)
  {
    return this->Mesh_.PointNormal(point);
  }
  const auto found = this->NormalsOfLargeFans_.find(point);
  return found != this->NormalsOfLargeFans_.end()
    ? found->second
    : this->NormalsOfLargeFans_.emplace(point, this->Mesh_.PointNormal(point)).first->second;
}

/// Over a plane along which the area around the vertex lies.
bool JetProbe::SetHeights(Id vertex, int numberOfRings)
{
  NeighborhoodRule rule;
  rule.kind = NeighborhoodRule::Kind::Rings;
  rule.numberOfRings = numberOfRings;
  const Span<Id> points = this->Neighborhood_.Gather(vertex, rule);
  const Eigen::Vector3d origin = this->Mesh_.Point(vertex);
  constexpr Id fewest = 7;
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  for (Id i = 0; i < std::min(points.size(), fewest); ++i)
  {
    axis += this->NormalAt(points[i]);
  }
  if (points.size() < fewest || !(axis.norm() > 0.0))
  {
    return false;
  }
  axis.normalize();
  Eigen::Matrix3d frame;
  frame.col(2) = axis;
  frame.col(0) = axis.unitOrthogonal();
  frame.col(1) = axis.cross(frame.col(0));
  this->Local_.resize(3, points.size());
  for (Id i = 0; i < points.size(); ++i)
  {
    this->Local_.col(i) = frame.transpose() * (this->Mesh_.Point(points[i]) - origin);
  }
  this->Radius_ = std::sqrt(this->Local_.topRows<2>().colwise().squaredNorm().maxCoeff());
  this->Local_ /= this->Radius_;
  if (!(this->Radius_ > 0.0) || !this->Local_.allFinite())
  {
    return false;
  }
  this->IsSteep_ = this->IsSteep();
  this->TurnToPrincipalAxes();
  return true;
}

/// By the chords from the vertex: on a circle that turns by 44 degrees they get so steep.
bool JetProbe::IsSteep() const
{
  constexpr double steep = 0.4;
  return (
    this->Local_.row(2).array().abs() > steep * this->Local_.topRows<2>().colwise().norm().array())
    .any();
}

/// So that the basis is as good on points that lie more densely in one direction as in the other.
void JetProbe::TurnToPrincipalAxes()
{
  const auto plane = this->Local_.topRows<2>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(
    Eigen::Matrix2d(plane * plane.transpose()));
  const Eigen::Matrix2Xd turned = axes.eigenvectors().transpose() * plane;
  this->Extents_ = turned.cwiseAbs().rowwise().maxCoeff();
  this->Local_.topRows<2>() = this->Extents_.cwiseInverse().asDiagonal() * turned;
}

void JetProbe::SetBasis(int degree)
{
  this->Basis_.resize(HeightJet::Size(degree), this->Local_.cols());
  std::array<double, HighestDegree + 1> u{};
  std::array<double, HighestDegree + 1> v{};
  for (Eigen::Index i = 0; i < this->Local_.cols(); ++i)
  {
    LegendreSums::Values(this->Local_(0, i), degree, u.data());
    LegendreSums::Values(this->Local_(1, i), degree, v.data());
    double* column = this->Basis_.col(i).data();
    for (int d = 0, row = 0; d <= degree; ++d)
    {
      for (int j = 0; j <= d; ++j, ++row)
      {
        column[row] = u[d - j] * v[j];
      }
    }
  }
}

void JetProbe::AddBands(int bands, JetTrial& trial)
{
  static const Eigen::MatrixXd functionals =
    LegendreSums::DerivativesAtZero(Orders, NumberOfDerivatives);
  const Eigen::MatrixXd gram = this->Sums_.Gram();
  const Eigen::Index size = gram.rows();
  // Polynomials of some degree on lattices of few points may be 0 on all of them: such a pivot, and
  // all after it, means nothing.
  const Eigen::LLT<Eigen::MatrixXd> factor(gram.selfadjointView<Eigen::Lower>());
  if (factor.info() != Eigen::Success)
  {
    return;
  }
  constexpr double leastPivot = 0.005;
  const Eigen::VectorXd pivots =
    factor.matrixLLT().diagonal() / std::sqrt(static_cast<double>(this->Local_.cols()));
  Eigen::MatrixXd columns(size, NumberOfDerivatives + 1);
  columns.leftCols(NumberOfDerivatives) = functionals.topRows(size);
  columns.col(NumberOfDerivatives) = this->Sums_.Heights();
  factor.matrixL().solveInPlace(columns);
  const auto heights = columns.col(NumberOfDerivatives);
  constexpr int times[] = { 1, 2, 1, 1, 3, 3, 1 };
  std::array<double, NumberOfDerivatives> units{};
  for (int f = 0; f < NumberOfDerivatives; ++f)
  {
    units[f] = 1.0 / this->Radius_;
    for (int i = 0; i < Orders[f][0] + Orders[f][1]; ++i)
    {
      units[f] /= this->Extents_[i < Orders[f][0] ? 0 : 1] * (i > 1 ? this->Radius_ : 1.0);
    }
  }
  const double perRadius = 1.0 / this->Radius_;
  int first = 0;
  for (int b = 0; b < bands; ++b)
  {
    const int count = HeightJet::Size(JetTrial::DegreeOf(b)) - first;
    if (pivots.segment(first, count).minCoeff() < leastPivot)
    {
      break;
    }
    JetTrial::Band& band = trial.band[b];
    for (int f = 0; f < NumberOfDerivatives; ++f)
    {
      JetTrial::Derivative& derivative = f < 3 ? band.second : band.third;
      const double unit = units[f];
      const auto column = columns.col(f).segment(first, count);
      derivative.values[f < 3 ? f : f - 3] = unit * column.dot(heights.segment(first, count));
      derivative.variance += times[f] * unit * unit * perRadius * perRadius * column.squaredNorm();
    }
    band.meanSquare =
      this->Radius_ * this->Radius_ * heights.segment(first, count).squaredNorm() / count;
    first += count;
    trial.bands = b + 1;
  }
  if (first > 0 && this->Local_.cols() < 2 * first)
  {
    const auto triangle =
      factor.matrixLLT().topLeftCorner(first, first).triangularView<Eigen::Lower>();
    this->AddVariance(triangle.transpose().solve(heights.head(first)), trial);
  }
}

/// From the heights themselves: where there is hardly any noise, sums of squares do not show it.
void JetProbe::AddVariance(const Eigen::VectorXd& coefficients, JetTrial& trial)
{
  this->SetBasis(JetTrial::DegreeOf(trial.bands - 1));
  const double square =
    (this->Local_.row(2) - coefficients.transpose() * this->Basis_).squaredNorm();
  trial.freedom = static_cast<int>(this->Local_.cols() - coefficients.size());
  trial.variance = this->Radius_ * this->Radius_ * square / trial.freedom;
}

} // namespace ridges
