// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// The batched fits, with every instruction set of this machine, against the pivoted orthogonal
// solver in long double.

#include "Fixtures/MongeComparison.h"
#include "Fixtures/TestFields.h"

#include "Fit/Batch/JetBatch.h"
#include "Fit/Batch/JetBatchFiller.h"
#include "Fit/JetErrors.h"
#include "Fit/JetFit.h"
#include "Formula/ExampleSurface.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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

struct BatchFit
{
  MongeForm form;
  double P1 = 0.0;
  double P2 = 0.0;
  double conditionNumber = 0.0;
  double residual = 0.0;
  double radius = 0.0;
  double noiseGain = 0.0;
  bool good = false;
  bool doubtful = false;
  std::array<double, JetBatch::NumberOfErrors> errors{};
};

// Fits what has been added.
void FitAdded(JetBatchFiller& filler, const JetBatchKernel& kernel, std::vector<BatchFit>& fits)
{
  filler.Fit(kernel,
    [&](const JetBatch& batch, Span<Id> vertices)
    {
      for (int lane = 0; lane < vertices.size(); ++lane)
      {
        BatchFit& fit = fits[vertices[lane]];
        fit.good = TakeResult(batch, kernel.lanes, lane, fit.form);
        fit.P1 = batch.P1[lane];
        fit.P2 = batch.P2[lane];
        fit.conditionNumber = batch.conditionNumber[lane];
        fit.residual = batch.residual[lane];
        fit.radius = batch.radius[lane];
        fit.noiseGain = batch.noiseGain[lane];
        fit.doubtful = batch.doubtful[lane] != 0.0;
        for (int i = 0; batch.standardErrors && i < JetBatch::NumberOfErrors; ++i)
        {
          fit.errors[i] = batch.errors[i * kernel.lanes + lane];
        }
      }
    });
}

// All points of a mesh, from `first` on.
std::vector<BatchFit> FitAll(const TriangleMesh& mesh, const JetBatchKernel& kernel, int degree,
  int minimumNumberOfPoints, Id first = 0, Weighting weighting = Weighting::Uniform,
  bool standardErrors = false)
{
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  NeighborhoodRule rule;
  rule.minimumNumberOfPoints = minimumNumberOfPoints;
  std::vector<BatchFit> fits(mesh.NumberOfPoints());
  JetBatchFiller filler(mesh, rings, degree, weighting, standardErrors);
  for (Id i = 0; i < mesh.NumberOfPoints(); ++i)
  {
    const Id p = (i + first) % mesh.NumberOfPoints();
    filler.Add(p, neighborhood.Gather(p, rule));
    if (filler.IsFull())
    {
      FitAdded(filler, kernel, fits);
    }
  }
  FitAdded(filler, kernel, fits);
  return fits;
}

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

struct Errors
{
  double k = 0.0;
  double b = 0.0;
  double P = 0.0;

  void Add(const MongeForm& form, const MongeForm& expected)
  {
    const double sign = form.d1.dot(expected.d1) < 0.0 ? -1.0 : 1.0;
    const double scaleK = std::max(std::abs(expected.k1), std::abs(expected.k2));
    double scaleB = 0.0;
    double scaleC = 0.0;
    for (const double value : expected.b)
    {
      scaleB = std::max(scaleB, std::abs(value));
    }
    for (const double value : expected.c)
    {
      scaleC = std::max(scaleC, std::abs(value));
    }
    const double scaleP =
      3.0 * scaleB * scaleB + 2.0 * scaleK * (scaleC + 3.0 * std::pow(scaleK, 3));
    this->k = std::max({ this->k, std::abs(form.k1 - expected.k1) / scaleK,
      std::abs(form.k2 - expected.k2) / scaleK });
    this->P = std::max({ this->P, std::abs(form.P1() - expected.P1()) / scaleP,
      std::abs(form.P2() - expected.P2()) / scaleP });
    for (int i = 0; i < 4; ++i)
    {
      this->b = std::max(this->b, std::abs(sign * form.b[i] - expected.b[i]) / scaleB);
    }
  }
};

// Fits with larger condition numbers are done once more by the solver for single points.
constexpr double LargestConditionNumber = 2000.0;

NeighborhoodRule RuleFor(int degree)
{
  NeighborhoodRule rule;
  rule.minimumNumberOfPoints = std::max(18, JetFitter::FewestPoints(degree));
  return rule;
}

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
    Errors errors;
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

Mesh ToMesh(const PointsAndTriangles& input)
{
  Mesh mesh;
  for (Eigen::Index p = 0; p < input.points.cols(); ++p)
  {
    mesh.AddPoint(input.points.col(p));
  }
  for (const Triangle& t : input.triangles)
  {
    mesh.AddTriangle(t[0], t[1], t[2]);
  }
  return mesh;
}

} // namespace

//------------------------------------------------------------------------------
TEST(JetBatch, AgreesWithLongDouble)
{
  CompareWithReference("ellipsoid", EllipsoidMesh(32, 1.4, 1.0, 0.6));
  CompareWithReference("noisy", AddNormalNoise(EllipsoidMesh(32, 1.4, 1.0, 0.6), 1e-3, 5));
  CompareWithReference("far away",
    Transform(EllipsoidMesh(24, 1.4, 1.0, 0.6), GenericRotation(), Vector3d(100, -50, 70)));
  CompareWithReference("blend", ToMesh(MeshSurface(BlendSurface(), 24)));
}

//------------------------------------------------------------------------------
TEST(JetBatch, HighDegreesAgreeWithLongDouble)
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
TEST(JetBatch, AgreesWithLongDoubleOnAScan)
{
  const std::string path = RIDGES_MESH_DIRECTORY "/bunny00.off";
  const Mesh scan = ReadOff(path);
  if (scan.PointCount() == 0)
  {
    GTEST_SKIP() << path << " is absent";
  }
  CompareWithReference("bunny00", scan);
}

//------------------------------------------------------------------------------
TEST(JetBatch, DoesNotDependOnTheBatch)
{
  const MeshedSurface surface(AddNormalNoise(EllipsoidMesh(12, 1.4, 1.0, 0.6), 1e-3, 5));
  for (const JetBatchKernel& kernel : JetBatchKernels())
  {
    const auto fits = FitAll(surface.Triangles(), kernel, 4, 18);
    const auto shifted = FitAll(surface.Triangles(), kernel, 4, 18, 3);
    for (std::size_t p = 0; p < fits.size(); ++p)
    {
      ASSERT_TRUE(fits[p].good);
      ASSERT_EQ(fits[p].form.k1, shifted[p].form.k1);
      ASSERT_EQ(fits[p].form.d1, shifted[p].form.d1);
      ASSERT_EQ(fits[p].form.b, shifted[p].form.b);
      ASSERT_EQ(fits[p].form.c, shifted[p].form.c);
      ASSERT_EQ(fits[p].P1, shifted[p].P1);
      ASSERT_EQ(fits[p].P2, shifted[p].P2);
      ASSERT_EQ(fits[p].residual, shifted[p].residual);
      ASSERT_EQ(fits[p].conditionNumber, shifted[p].conditionNumber);
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetBatch, InstructionSetsDifferByRoundOffOnly)
{
  const MeshedSurface surface(AddNormalNoise(EllipsoidMesh(24, 1.4, 1.0, 0.6), 1e-3, 5));
  const std::vector<JetBatchKernel>& kernels = JetBatchKernels();
  const auto expected = FitAll(surface.Triangles(), kernels.back(), 4, 18);
  for (const JetBatchKernel& kernel : kernels)
  {
    const auto fits = FitAll(surface.Triangles(), kernel, 4, 18);
    Errors errors;
    for (std::size_t p = 0; p < fits.size(); ++p)
    {
      errors.Add(fits[p].form, expected[p].form);
      ASSERT_NEAR(fits[p].residual, expected[p].residual, 1e-15);
    }
    std::printf("%-8s against %s: k %.1e, b %.1e, P %.1e\n", kernel.name, kernels.back().name,
      errors.k, errors.b, errors.P);
    // Fused multiply-add rounds once where the baseline rounds twice; magnified by condition
    // numbers of up to some hundreds, and for b and P by the noise of a thirtieth of an edge.
    EXPECT_LT(errors.k, 1e-12);
    EXPECT_LT(errors.b, 1e-10);
    EXPECT_LT(errors.P, 1e-10);
  }
}

//------------------------------------------------------------------------------
TEST(JetBatch, LowerDegreesAgreeWithTheSolverForSinglePoints)
{
  const MeshedSurface surface(AddNormalNoise(EllipsoidMesh(12, 1.4, 1.0, 0.6), 1e-3, 5));
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  JetFitter fitter;
  for (const int degree : { 2, 3, 4 })
  {
    for (const JetBatchKernel& kernel : JetBatchKernels())
    {
      const auto fits = FitAll(mesh, kernel, degree, 18);
      for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
      {
        const Eigen::Matrix3Xd offsets = OffsetsAround(mesh, p, neighborhood, NeighborhoodRule());
        const JetFit fit = fitter.Fit(offsets, degree, mesh.PointNormal(p));
        const MongeForm expected = MongeFormOfHeightJet(fit.jet, fit.frame);
        ASSERT_TRUE(fits[p].good);
        // Round-off, magnified by condition numbers of up to some hundreds.
        const double k = std::abs(expected.k2);
        ASSERT_NEAR(fits[p].form.k1, expected.k1, 1e-11 * k);
        ASSERT_NEAR(fits[p].form.k2, expected.k2, 1e-11 * k);
        ASSERT_NEAR((fits[p].form.n - expected.n).norm(), 0.0, 1e-11);
        ASSERT_NEAR(fits[p].residual, fit.residual, 1e-13);
        if (degree < 4)
        {
          ASSERT_EQ(fits[p].form.c[0] == 0.0, expected.c[0] == 0.0);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetBatch, LeavesIllConditionedPointsToTheSingleSolver)
{
  // A flat grid: three rows of points at the border do not determine a quartic across it.
  const MeshedSurface surface(GraphPatch([](double, double) { return 0.0; }, 1.0, 10));
  const TriangleMesh& mesh = surface.Triangles();
  for (const JetBatchKernel& kernel : JetBatchKernels())
  {
    const auto fits = FitAll(mesh, kernel, 4, 18);
    int refused = 0;
    for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
    {
      const bool bad = !fits[p].good || fits[p].conditionNumber > 1e5;
      refused += bad ? 1 : 0;
      ASSERT_TRUE(!bad || mesh.Point(p).cwiseAbs().maxCoeff() > 0.7) << "inside";
    }
    EXPECT_GT(refused, 20);
  }

  // Too many and too few points, and points on a line.
  const OrderedRings rings = RingsOf(mesh);
  JetBatchFiller filler(mesh, rings, 4);
  const std::vector<Id> many(JetBatch::MaximumRows + 1, 0);
  const std::vector<Id> few(14, 0);
  EXPECT_FALSE(filler.Add(0, { many.data(), many.data() + many.size() }));
  EXPECT_FALSE(filler.Add(0, { few.data(), few.data() + few.size() }));
  EXPECT_TRUE(filler.IsEmpty());
}

//------------------------------------------------------------------------------
// On a grid the neighbourhood of a border point is three or four rows of points: a polynomial of
// degree 4 vanishes on all of them. Its coefficients depend on the axes of the batch, which are
// any; so turn the grid.
TEST(JetBatch, ConditionNumberFindsNullPolynomialsInAnyAxes)
{
  const Mesh flat = AddNormalNoise(CylinderPatch(1.0, 3.0, 1.0, 30, 10), 1e-6, 3);
  int singular = 0;
  for (int turn = 0; turn < 16; ++turn)
  {
    const Eigen::Matrix3d rotation =
      (Eigen::AngleAxisd(0.4 * turn, Vector3d(1.0, 0.3 * turn - 2.0, 0.5).normalized()) *
        Eigen::AngleAxisd(0.1 * turn, Vector3d::UnitX()))
        .toRotationMatrix();
    const MeshedSurface surface(Transform(flat, rotation, Vector3d::Zero()));
    const TriangleMesh& mesh = surface.Triangles();
    const OrderedRings rings = RingsOf(mesh);
    RingNeighborhood neighborhood(mesh, rings);
    std::vector<double> expected(mesh.NumberOfPoints());
    JetFitter fitter;
    for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
    {
      const Eigen::Matrix3Xd offsets = OffsetsAround(mesh, p, neighborhood, NeighborhoodRule());
      expected[p] = fitter.Fit(offsets, 4, mesh.PointNormal(p)).conditionNumber;
      singular += expected[p] > 1e5 ? 1 : 0;
    }
    for (const JetBatchKernel& kernel : JetBatchKernels())
    {
      const auto fits = FitAll(mesh, kernel, 4, 18);
      for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
      {
        // Singular values are not quite the same in other axes and units, and neither number is
        // exact. What normal equations cannot tell from singular is refused.
        const double found = fits[p].good ? fits[p].conditionNumber : 1e300;
        ASSERT_GT(found, expected[p] / 5.0) << kernel.name << ", turn " << turn << ", point " << p;
        ASSERT_LT(std::min(found, 1e4), 10.0 * expected[p])
          << kernel.name << ", turn " << turn << ", point " << p;
      }
    }
  }
  EXPECT_GT(singular, 16 * 15);
}

//------------------------------------------------------------------------------
// Regular and irregular meshes, and the borders of grids, which growing rings determine badly.
TEST(JetBatch, HighDegreesFindTheConditionNumberAndNoiseGainOfTheSinglePointSolver)
{
  const Mesh meshes[] = { EllipsoidMesh(12, 1.4, 1.0, 0.6), ToMesh(MeshSurface(BlendSurface(), 12)),
    AddNormalNoise(GraphPatch([](double x, double y) { return x * y; }, 1.0, 20, 0.24), 1e-3, 2) };
  for (const int degree : { 5, 6, 7, 8 })
  {
    double least = 1e300;
    double most = 0.0;
    int singular = 0;
    for (const Mesh& input : meshes)
    {
      const MeshedSurface surface(input);
      const TriangleMesh& mesh = surface.Triangles();
      const OrderedRings rings = RingsOf(mesh);
      RingNeighborhood neighborhood(mesh, rings);
      const NeighborhoodRule rule = RuleFor(degree);
      JetFitter fitter;
      std::vector<JetFit> expected;
      for (Id p = 0; p < mesh.NumberOfPoints(); p += 3)
      {
        expected.push_back(
          fitter.Fit(OffsetsAround(mesh, p, neighborhood, rule), degree, mesh.PointNormal(p)));
      }
      for (const JetBatchKernel& kernel : JetBatchKernels())
      {
        const auto fits = FitAll(mesh, kernel, degree, rule.minimumNumberOfPoints);
        for (std::size_t i = 0; i < expected.size(); ++i)
        {
          const BatchFit& fit = fits[3 * i];
          const double condition = expected[i].conditionNumber;
          const bool isFrameLost = fit.conditionNumber == 0.0;
          if (isFrameLost)
          {
            ASSERT_FALSE(fit.good);
          }
          else if (fit.good && condition < 1e5)
          {
            // Axes, and so extents, are any where the neighbourhood is round: the condition number
            // differs most in such harmless places.
            const double ratio = fit.conditionNumber / condition;
            ASSERT_GT(ratio, 0.05) << kernel.name << " " << 3 * i;
            least = condition > 500.0 ? std::min(least, ratio) : least;
            most = std::max(most, ratio);
            // The same formula; round-off is magnified by the condition number.
            ASSERT_NEAR(fit.noiseGain, expected[i].noiseGain, 1e-4 * expected[i].noiseGain);
          }
          else
          {
            ++singular;
            ASSERT_TRUE(!fit.good || fit.conditionNumber > 2e4) << kernel.name << " " << 3 * i;
            ASSERT_GT(condition, 1e4) << kernel.name << " " << 3 * i;
          }
        }
      }
    }
    std::printf("degree %d: large condition numbers are %.2f to %.2f times those of single points, "
                "%d singular\n",
      degree, least, most, singular);
    EXPECT_GT(least, 0.1);
    EXPECT_LT(most, 5.0);
  }
}

//------------------------------------------------------------------------------
TEST(JetBatch, NoiseGainIsAboutThatOfTheSolverForSinglePoints)
{
  for (const Mesh& input : { EllipsoidMesh(12, 1.4, 1.0, 0.6),
         AddNormalNoise(
           GraphPatch([](double x, double y) { return x * y; }, 1.0, 20, 0.24), 1e-3, 2) })
  {
    const MeshedSurface surface(input);
    const TriangleMesh& mesh = surface.Triangles();
    const OrderedRings rings = RingsOf(mesh);
    RingNeighborhood neighborhood(mesh, rings);
    JetFitter fitter;
    for (const int degree : { 2, 3, 4 })
    {
      for (const JetBatchKernel& kernel : JetBatchKernels())
      {
        const auto fits = FitAll(mesh, kernel, degree, 18);
        for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
        {
          const JetFit fit = fitter.Fit(
            OffsetsAround(mesh, p, neighborhood, NeighborhoodRule()), degree, mesh.PointNormal(p));
          if (fits[p].good && fits[p].conditionNumber < 1000.0)
          {
            // By experience: there is no closed form.
            ASSERT_GE(fits[p].noiseGain, 0.25 * fit.noiseGain) << kernel.name << " " << p;
            ASSERT_LE(fits[p].noiseGain, 4.0 * fit.noiseGain) << kernel.name << " " << p;
            ASSERT_EQ(fits[p].noiseGain > 0.0, degree > 2);
          }
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetBatch, IsInDoubtWhereTheSurfaceMayFoldOver)
{
  // 18 points of the coarse sphere reach to its equator, of the fine one to 17 degrees.
  for (const auto& [frequency, doubtful] : { std::pair(2, true), std::pair(8, false) })
  {
    const MeshedSurface surface(Icosphere(frequency));
    for (const JetBatchKernel& kernel : JetBatchKernels())
    {
      for (const BatchFit& fit : FitAll(surface.Triangles(), kernel, 4, 18))
      {
        ASSERT_EQ(fit.doubtful, doubtful) << kernel.name;
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetBatch, WeightedFitsAgreeWithTheSolverForSinglePoints)
{
  const MeshedSurface surface(AddNormalNoise(EllipsoidMesh(12, 1.4, 1.0, 0.6), 1e-3, 5));
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  NeighborhoodRule rule;
  rule.minimumNumberOfPoints = 30;
  JetFitter fitter;
  for (const JetBatchKernel& kernel : JetBatchKernels())
  {
    const auto fits = FitAll(mesh, kernel, 4, 30, 0, Weighting::Gaussian);
    for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
    {
      const JetFit fit = fitter.Fit(
        OffsetsAround(mesh, p, neighborhood, rule), 4, mesh.PointNormal(p), Weighting::Gaussian);
      const MongeForm expected = MongeFormOfHeightJet(fit.jet, fit.frame);
      ASSERT_TRUE(fits[p].good);
      // Round-off, magnified by condition numbers of up to some hundreds.
      const double k = std::abs(expected.k2);
      ASSERT_NEAR(fits[p].form.k1, expected.k1, 1e-10 * k);
      ASSERT_NEAR(fits[p].form.k2, expected.k2, 1e-10 * k);
      ASSERT_NEAR(fits[p].residual, fit.residual, 1e-13);
      ASSERT_NEAR(fits[p].radius, fit.radius, 1e-15);
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetBatch, StandardErrorsAreThoseOfTheSolverForSinglePoints)
{
  const MeshedSurface surface(AddNormalNoise(EllipsoidMesh(10, 1.4, 1.0, 0.6), 1e-3, 5));
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  for (const Weighting weighting : { Weighting::Uniform, Weighting::Gaussian })
  {
    for (int degree = 2; degree <= JetFitter::MaximumDegree; ++degree)
    {
      const NeighborhoodRule rule = RuleFor(degree);
      JetFitter fitter;
      std::vector<JetErrors> expected(mesh.NumberOfPoints());
      std::vector<bool> isCertain(mesh.NumberOfPoints(), false);
      for (Id p = 0; p < mesh.NumberOfPoints(); p += 7)
      {
        const JetFit fit = fitter.Fit(
          OffsetsAround(mesh, p, neighborhood, rule), degree, mesh.PointNormal(p), weighting);
        expected[p] = StandardErrors(fitter, fit);
        const MongeForm form = MongeFormOfHeightJet(fit.jet, fit.frame);
        isCertain[p] = form.k1 - form.k2 > 1e-2 * std::abs(form.k2);
      }
      for (const JetBatchKernel& kernel : JetBatchKernels())
      {
        const auto plain = FitAll(mesh, kernel, degree, rule.minimumNumberOfPoints, 0, weighting);
        const auto fits =
          FitAll(mesh, kernel, degree, rule.minimumNumberOfPoints, 0, weighting, true);
        for (std::size_t p = 0; p < fits.size(); ++p)
        {
          const JetErrors& e = expected[p];
          const double values[] = { e.k1, e.k2, e.b[0], e.b[1], e.b[2], e.b[3], e.P1, e.P2 };
          for (int i = 0; isCertain[p] && i < JetBatch::NumberOfErrors; ++i)
          {
            // Round-off, magnified by condition numbers and by 1 / (k1 - k2).
            ASSERT_NEAR(fits[p].errors[i], values[i], 1e-6 * std::abs(values[i]))
              << kernel.name << " degree " << degree << " point " << p << " quantity " << i
              << (weighting == Weighting::Gaussian ? " weighted" : "");
          }
          // All else is the same to the last digit.
          ASSERT_EQ(fits[p].form.k1, plain[p].form.k1);
          ASSERT_EQ(fits[p].form.b, plain[p].form.b);
          ASSERT_EQ(fits[p].form.c, plain[p].form.c);
          ASSERT_EQ(fits[p].P2, plain[p].P2);
          ASSERT_EQ(fits[p].conditionNumber, plain[p].conditionNumber);
          ASSERT_EQ(fits[p].noiseGain, plain[p].noiseGain);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetBatch, StandardErrorsAreUnknownWithoutFreedomAndAtUmbilics)
{
  // Regular neighbourhoods of 19 points, and 15 of a cap of a sphere are as many as coefficients.
  const MeshedSurface surface(EllipsoidMesh(6, 1.0, 1.0, 1.0));
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  for (const JetBatchKernel& kernel : JetBatchKernels())
  {
    std::vector<BatchFit> fits(mesh.NumberOfPoints());
    JetBatchFiller filler(mesh, rings, 4, Weighting::Uniform, true);
    for (Id p = 0; p < 8; ++p)
    {
      const Span<Id> points = neighborhood.Gather(p + 50, NeighborhoodRule());
      filler.Add(p, { points.begin(), points.begin() + 15 }, false);
    }
    FitAdded(filler, kernel, fits);
    for (Id p = 0; p < 8; ++p)
    {
      for (const double error : fits[p].errors)
      {
        ASSERT_EQ(error, JetBatch::UnknownError) << kernel.name;
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(JetBatch, NormalsPointToTheSideOfTheFan)
{
  // Open fans, closed ones, and, with the neighbourhoods cut off, normals that are given.
  const MeshedSurface surface(
    GraphPatch([](double x, double y) { return 0.3 * x * x - 0.2 * y * y; }, 1.0, 12));
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  NeighborhoodRule rule;
  rule.minimumNumberOfPoints = 30;
  for (const JetBatchKernel& kernel : JetBatchKernels())
  {
    for (const bool wholeRings : { true, false })
    {
      std::vector<BatchFit> fits(mesh.NumberOfPoints());
      JetBatchFiller filler(mesh, rings, 4);
      for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
      {
        ASSERT_TRUE(filler.Add(p, neighborhood.Gather(p, rule), wholeRings));
        if (filler.IsFull() || p + 1 == mesh.NumberOfPoints())
        {
          FitAdded(filler, kernel, fits);
        }
      }
      for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
      {
        ASSERT_GT(fits[p].form.n.dot(mesh.PointNormal(p)), 0.0);
      }
    }
  }
}
