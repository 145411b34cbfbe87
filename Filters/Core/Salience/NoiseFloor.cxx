// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/NoiseFloor.h"

#include "Fit/Batch/JetBatchFiller.h"
#include "Fit/JetFit.h"
#include "Mesh/RingNeighborhood.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace ridges
{
namespace
{

/// Bits that depend on all bits of x: the finaliser of SplitMix64.
std::uint64_t Mixed(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

/// In (0, 1].
double Uniform(std::uint64_t bits)
{
  return static_cast<double>((bits >> 11) + 1) * 0x1p-53;
}

} // namespace

void NoiseMeter::Measure(Span<Id> sample, std::vector<double>& heights) const
{
  constexpr int degree = 4;
  NeighborhoodRule rule;
  rule.kind = NeighborhoodRule::Kind::RingsAndPointCount;
  rule.numberOfRings = 3;
  rule.minimumNumberOfPoints = 30;
  RingNeighborhood neighborhood(this->Mesh_, this->Rings_);
  const std::vector<JetBatchKernel>& kernels = JetBatchKernels();
  JetBatchFiller batches(this->Mesh_, this->Rings_, degree);
  JetFitter fitter;
  Eigen::Matrix3Xd offsets;
  const auto fitAll = [&batches, &kernels, &heights]()
  {
    batches.Fit(kernels.front(),
      [&heights](const JetBatch& batch, Span<Id> vertices)
      {
        for (Id lane = 0; lane < vertices.size(); ++lane)
        {
          if (batch.good[lane] != 0.0)
          {
            heights.push_back(batch.residual[lane] * batch.radius[lane]);
          }
        }
      });
  };
  for (const Id p : sample)
  {
    const Span<Id> points = neighborhood.Gather(p, rule);
    if (!kernels.empty() && batches.Add(p, points))
    {
      if (batches.IsFull())
      {
        fitAll();
      }
      continue;
    }
    offsets.resize(3, points.size());
    for (Id i = 0; i < points.size(); ++i)
    {
      offsets.col(i) = this->Mesh_.Point(points[i]) - this->Mesh_.Point(p);
    }
    const JetFit fit = fitter.Fit(offsets, degree, this->Mesh_.PointNormal(p));
    if (fit.status == FitGood)
    {
      heights.push_back(fit.residual * fit.radius);
    }
  }
  if (!batches.IsEmpty())
  {
    fitAll();
  }
}

double NoiseMeter::Deviation(std::vector<double> heights)
{
  // What 37 points scatter around 15 coefficients: the tenth part of them has less than this share
  // of the deviation.
  constexpr double part = 0.1;
  constexpr double deviationsPerQuantile = 1.60;
  if (heights.empty())
  {
    return 0.0;
  }
  const auto which =
    heights.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(heights.size() - 1));
  std::nth_element(heights.begin(), which, heights.end());
  return deviationsPerQuantile * *which;
}

double NormalNoise(const Eigen::Vector3d& point)
{
  std::uint64_t hash = 0;
  for (const double x : point)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    hash = Mixed(hash ^ bits);
  }
  // Box and Muller.
  const double radius = std::sqrt(-2.0 * std::log(Uniform(hash)));
  return radius * std::cos(2.0 * EIGEN_PI * Uniform(Mixed(hash)));
}

double MedianCurvatureError(const TriangleMesh& mesh, const FitErrorSource& source)
{
  std::vector<double> errors;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if (mesh.TrianglesAround(p).size() > 0)
    {
      errors.push_back(GapError(mesh, source, p));
    }
  }
  if (errors.empty())
  {
    return 0.0;
  }
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return std::isfinite(*middle) ? *middle / std::sqrt(2.0) : 0.0; // k1 and k2 have half of it each
}

double SquaredDifference(const MongeField& field, Id p, const MongeForm& other)
{
  const Eigen::Matrix3d tensor = field.k1[p] * field.D1(p) * field.D1(p).transpose() +
    field.k2[p] * field.D2(p) * field.D2(p).transpose();
  return (tensor - other.k1 * other.d1 * other.d1.transpose() -
    other.k2 * other.d2 * other.d2.transpose())
    .squaredNorm();
}

double CurvatureDeviation(const TriangleMesh& mesh, const std::vector<double>& differences)
{
  std::vector<double> squares;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if (mesh.TrianglesAround(p).size() > 0)
    {
      squares.push_back(differences[p]);
    }
  }
  if (squares.empty())
  {
    return 0.0;
  }
  const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
  std::nth_element(squares.begin(), middle, squares.end());
  // The squares off the diagonal count twice and have half the variance: 8/3 of it in all. The
  // median of the sum is 0.80 of its mean.
  return std::sqrt(3.0 / 8.0 * *middle / 0.80);
}

} // namespace ridges
