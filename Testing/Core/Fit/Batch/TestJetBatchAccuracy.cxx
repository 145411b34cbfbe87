// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// The batched fits, with every instruction set of this machine, against the pivoted orthogonal
// solver in long double.

#include "Fixtures/BatchFits.h"
#include "Fixtures/MongeComparison.h"
#include "Fixtures/TestFields.h"

#include "Fit/JetFit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

// The same fit in long double: principal frame by Jacobi's method, pivoted Householder QR.
MongeForm Reference(const Eigen::Matrix3Xd& offsets, const Vector3d& side, int degree)
{
  using Real = long double;
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Real, 3, 1>;
  const Matrix points = offsets.cast<Real>();
  const Vector mean = points.rowwise().mean();
  const Matrix centered = points.colwise() - mean;
  const Eigen::Matrix<Real, 3, 3> covariance = centered * centered.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, 3, 3>> eigen(covariance);
  Eigen::Matrix<Real, 3, 3> frame;
  frame.col(2) = eigen.eigenvectors().col(0);
  if (frame.col(2).dot(side.cast<Real>()) < 0)
  {
    frame.col(2) = -frame.col(2);
  }
  frame.col(0) = eigen.eigenvectors().col(2);
  frame.col(1) = frame.col(2).cross(frame.col(0));

  const Real radius = std::sqrt(points.colwise().squaredNorm().maxCoeff());
  const Matrix local = frame.transpose() * points / radius;
  Matrix system(local.cols(), HeightJet::Size(degree));
  for (Eigen::Index row = 0; row < local.cols(); ++row)
  {
    for (int d = 0; d <= degree; ++d)
    {
      for (int j = 0; j <= d; ++j)
      {
        system(row, HeightJet::Index(d - j, j)) =
          std::pow(local(0, row), Real(d - j)) * std::pow(local(1, row), Real(j));
      }
    }
  }
  const Matrix solution = system.colPivHouseholderQr().solve(local.row(2).transpose());
  HeightJet jet;
  const Real factorials[] = { 1, 1, 2, 6, 24 };
  for (int d = 0; d <= 4; ++d)
  {
    for (int j = 0; j <= d; ++j)
    {
      const int i = HeightJet::Index(d - j, j);
      jet.derivatives[i] = static_cast<double>(
        solution(i) * factorials[d - j] * factorials[j] * std::pow(radius, Real(1 - d)));
    }
  }
  return MongeFormOfHeightJet(jet, frame.cast<double>());
}

// Fits with larger condition numbers are done once more by the solver for single points.
constexpr double LargestConditionNumber = 2000.0;

void CompareWithReference(const char* name, const Mesh& input, int degree = 4, Id step = 7)
{
  const MeshedSurface surface(input);
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  std::vector<Id> sample;
  std::vector<MongeForm> references;
  const NeighborhoodRule rule = RuleFor(degree);
  for (Id p = 0; p < mesh.NumberOfPoints(); p += step)
  {
    const Eigen::Matrix3Xd offsets = OffsetsAround(mesh, p, neighborhood, rule);
    sample.push_back(p);
    references.push_back(Reference(offsets, mesh.PointNormal(p), degree));
  }
  for (const JetBatchKernel& kernel : JetBatchKernels())
  {
    const auto fits = FitAll(mesh, kernel, degree, rule.minimumNumberOfPoints);
    const auto batched = [](const BatchFit& fit)
    { return fit.good && fit.conditionNumber <= LargestConditionNumber; };
    const auto notBatched =
      static_cast<std::size_t>(std::count_if(fits.begin(), fits.end(), std::not_fn(batched)));
    RelativeErrors errors;
    std::size_t compared = 0;
    for (std::size_t i = 0; i < sample.size(); ++i)
    {
      const BatchFit& fit = fits[sample[i]];
      const MongeForm& expected = references[i];
      // Next to an umbilic principal directions, and so b and P, are not determined.
      const double gap = (expected.k1 - expected.k2) / (std::abs(expected.k1) + 1e-300);
      if (batched(fit) && gap > 1e-3)
      {
        errors.Add(fit.form, expected);
        ++compared;
      }
    }
    std::printf("%-10s degree %d %-8s against long double: k %.1e, b %.1e, P %.1e at %zu points; "
                "%zu of all %zu not batched\n",
      name, degree, kernel.name, errors.k, errors.b, errors.P, compared, notBatched, fits.size());
    EXPECT_GT(compared, sample.size() * 9 / 10);
    EXPECT_LT(notBatched, fits.size() / 100);
    EXPECT_LT(errors.k, 1e-8);
    EXPECT_LT(errors.b, 1e-6);
    EXPECT_LT(errors.P, 1e-5);
  }
}

} // namespace

//------------------------------------------------------------------------------
TEST(JetBatchAccuracy, AgreesWithLongDouble)
{
  CompareWithReference("ellipsoid", EllipsoidMesh(32, 1.4, 1.0, 0.6));
  CompareWithReference("noisy", AddNormalNoise(EllipsoidMesh(32, 1.4, 1.0, 0.6), 1e-3, 5));
  CompareWithReference("far away",
    Transform(EllipsoidMesh(24, 1.4, 1.0, 0.6), GenericRotation(), Vector3d(100, -50, 70)));
  CompareWithReference("blend", ToMesh(MeshSurface(BlendSurface(), 24)));
}

//------------------------------------------------------------------------------
TEST(JetBatchAccuracy, HighDegreesAgreeWithLongDouble)
{
  for (const int degree : { 5, 6, 7, 8 })
  {
    constexpr Id step = 113;
    CompareWithReference("ellipsoid", EllipsoidMesh(24, 1.4, 1.0, 0.6), degree, step);
    CompareWithReference(
      "noisy", AddNormalNoise(EllipsoidMesh(24, 1.4, 1.0, 0.6), 1e-3, 5), degree, step);
    CompareWithReference("far away",
      Transform(EllipsoidMesh(24, 1.4, 1.0, 0.6), GenericRotation(), Vector3d(100, -50, 70)),
      degree, step);
    CompareWithReference("blend", ToMesh(MeshSurface(BlendSurface(), 24)), degree, step);
    // Up to twice as dense in one direction as in the other.
    CompareWithReference(
      "torus", AddNormalNoise(TorusMesh(2.0, 0.8, 200, 60), 1e-4, 5), degree, 2 * step);
  }
}

//------------------------------------------------------------------------------
TEST(JetBatchAccuracy, AgreesWithLongDoubleOnAScan)
{
  const std::string path = RIDGES_MESH_DIRECTORY "/bunny00.off";
  const Mesh scan = ReadOff(path);
  if (scan.PointCount() == 0)
  {
    GTEST_SKIP() << path << " is absent";
  }
  CompareWithReference("bunny00", scan);
}
