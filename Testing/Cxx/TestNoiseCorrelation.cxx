// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Noise that is not independent from point to point, as after smoothing, is reported. The
// correlation of some 300 points with the means of their six neighbours scatters by about
// 1 / sqrt(6 * 300) = 0.024 if there is none: the limit is four times that.

#include "FilterTestTools.h"
#include "ParametricMesh.h"

#include "vtkFieldData.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRidgesArrayNames.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace
{

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

constexpr double Limit = 0.1;

// Each point half way to the mean of its neighbours.
Mesh SmoothOnce(const Mesh& mesh)
{
  std::vector<std::set<std::int32_t>> neighbors(mesh.PointCount());
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int32_t p = mesh.triangles[i + k];
      const std::int32_t q = mesh.triangles[i + (k + 1) % 3];
      neighbors[p].insert(q);
      neighbors[q].insert(p);
    }
  }
  Mesh smoothed = mesh;
  for (std::size_t p = 0; p < mesh.PointCount(); ++p)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::int32_t q : neighbors[p])
    {
      sum += mesh.Point(q);
    }
    smoothed.SetPoint(
      p, 0.5 * mesh.Point(p) + 0.5 / static_cast<double>(neighbors[p].size()) * sum);
  }
  return smoothed;
}

struct Report
{
  double correlation;
  bool saysUnreliable;
};

Report ReportOf(const Mesh& mesh)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(ToPolyData(mesh));
  jets->Update();
  vtkFieldData* field = jets->GetOutput()->GetFieldData();
  const std::string text =
    vtkStringArray::SafeDownCast(field->GetAbstractArray(names::SelectedFit))->GetValue(0);
  return { Value(field, names::NoiseCorrelation, 0),
    text.find("not a reliable estimate") != std::string::npos };
}

} // namespace

//------------------------------------------------------------------------------
TEST(NoiseCorrelation, TellsSmoothedNoiseFromIndependentNoise)
{
  const Mesh clean = EllipsoidMesh(32, 1.4, 1.0, 0.6);
  EXPECT_FALSE(ReportOf(clean).saysUnreliable); // there is none
  for (const double noise : { 1e-3, 1e-2, 5e-2 })
  {
    Mesh mesh = AddNormalNoise(clean, noise * MeanEdgeLength(clean), 3);
    const Report independent = ReportOf(mesh);
    EXPECT_LT(std::abs(independent.correlation), Limit) << noise;
    EXPECT_FALSE(independent.saysUnreliable) << noise;
    for (int steps = 1; steps <= 10; ++steps)
    {
      mesh = SmoothOnce(mesh);
      if (steps == 1 || steps == 3 || steps == 10)
      {
        const Report smoothed = ReportOf(mesh);
        EXPECT_GT(smoothed.correlation, Limit) << noise << " after " << steps << " steps";
        // Of little noise hardly any is left to be said anything of.
        if (noise > 2e-3 || steps < 10)
        {
          EXPECT_TRUE(smoothed.saysUnreliable) << noise << " after " << steps << " steps";
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// On many rings degree 4 leaves over some of the surface, which is alike from point to point.
TEST(NoiseCorrelation, TakesNoneOfTheSurfaceForNoise)
{
  constexpr double pi = 3.14159265358979323846;
  const auto sphere = [](double u, double v)
  { return Eigen::Vector3d(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), std::cos(v)); };
  const Mesh cap = ParametricMesh(sphere, { 0.0, 2.0 * pi, 0.4, 1.4, 224, 45, true, false, 0.0 });
  for (const double noise : { 1e-3, 1e-2 })
  {
    const Report report = ReportOf(AddNormalNoise(cap, noise * MeanEdgeLength(cap), 3));
    EXPECT_LT(std::abs(report.correlation), Limit) << noise;
    EXPECT_FALSE(report.saysUnreliable) << noise;
  }
}
