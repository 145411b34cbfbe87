// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Open patches, graphs of random polynomials over a square: automatic fits show no umbilic that is
// not there, and all that are inside, on 5,000 and 20,000 points. The checks of coherence pass.
// Umbilics are compared within four edges.

#include "CoherenceRows.h"
#include "ExactUmbilics.h"
#include "FilterTestTools.h"
#include "RandomPolynomial.h"

#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace
{

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;
using Eigen::Vector3d;

constexpr double Size = 0.15; // of the coefficients

// So many points along each side of the square from -1 to 1.
Mesh GraphMesh(const RandomPolynomial& height, int n)
{
  Mesh mesh;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const double x = 2.0 * i / (n - 1) - 1.0;
      const double y = 2.0 * j / (n - 1) - 1.0;
      mesh.AddPoint({ x, y, Size * height(x, y, 0.0) });
    }
  }
  for (int i = 0; i + 1 < n; ++i)
  {
    for (int j = 0; j + 1 < n; ++j)
    {
      const int a = i * n + j;
      const int b = a + n;
      if ((i + j) % 2 == 0)
      {
        mesh.AddTriangle(a, b, b + 1);
        mesh.AddTriangle(a, b + 1, a + 1);
      }
      else
      {
        mesh.AddTriangle(a, b, a + 1);
        mesh.AddTriangle(b, b + 1, a + 1);
      }
    }
  }
  return mesh;
}

class OpenMeshes : public ::testing::TestWithParam<int>
{
};

} // namespace

//------------------------------------------------------------------------------
TEST_P(OpenMeshes, HaveTheirUmbilicsAndNoOthers)
{
  const RandomPolynomial height(2, 5, static_cast<std::uint64_t>(GetParam()));
  const AnalyticSurface surface(
    [height](auto x, auto y, auto z) { return z - Size * height(x, y, 0.0 * z); });
  const auto truth = FindUmbilics(surface, GraphMesh(height, 101));
  for (const int n : { 71, 141 })
  {
    const Mesh mesh = GraphMesh(height, n);
    const double edge = MeanEdgeLength(mesh);
    vtkNew<vtkJetFitting> jets;
    jets->SetInputData(ToPolyData(mesh));
    vtkNew<vtkUmbilicDetection> detection;
    detection->SetInputConnection(jets->GetOutputPort());
    vtkNew<vtkRidgeExtraction> ridges;
    ridges->SetInputConnection(detection->GetOutputPort());
    ridges->Update();
    vtkPolyData* found = detection->GetOutput(1);
    const auto isNear = [edge, found](const ExactUmbilic& umbilic, vtkIdType i)
    {
      return (umbilic.position - PointAt(found, i)).norm() < 4.0 * edge &&
        umbilic.index == Value(found->GetPointData(), names::Index, i);
    };
    for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
    {
      EXPECT_TRUE(std::any_of(truth.begin(), truth.end(),
        [&isNear, i](const ExactUmbilic& umbilic) { return isNear(umbilic, i); }))
        << n << ": none at " << PointAt(found, i).transpose();
    }
    for (const ExactUmbilic& umbilic : truth)
    {
      const double inside =
        1.0 - std::max(std::abs(umbilic.position.x()), std::abs(umbilic.position.y()));
      bool isThere = inside < edge;
      for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
      {
        isThere = isThere || isNear(umbilic, i);
      }
      EXPECT_TRUE(isThere) << n << ": missing at " << umbilic.position.transpose();
    }
    EXPECT_EQ(Failed(Check(detection->GetOutput(0), ridges->GetOutput(), found)), "") << n;
  }
}

INSTANTIATE_TEST_SUITE_P(Graphs, OpenMeshes, ::testing::Range(1, 9));
