// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Hyperboloids, which go on to infinity: of one sheet, x^2/a^2 + y^2/b^2 - z^2/c^2 = 1, without
// umbilics, and of two, ... = -1, a > b, with two on each sheet, at
//   (0, +-b sqrt((a^2 - b^2) / (b^2 + c^2)), +-c sqrt((a^2 + c^2) / (b^2 + c^2))),
// of index +1/2 and with one ridge of each colour: the formula for the ellipsoid, with other signs
// of the squared semi-axes.

#include "AnalyticSurface.h"
#include "ExactUmbilics.h"
#include "FilterTestTools.h"
#include "ParametricMesh.h"
#include "TestMeshes.h"

#include "vtkImplicitMongeForm.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;
using Eigen::Vector3d;

namespace
{

constexpr double A = 1.3;
constexpr double B = 1.0;
constexpr double C = 0.8;
const char* const Formula = "x^2/1.69 + y^2 - z^2/0.64";

//------------------------------------------------------------------------------
AnalyticSurface Hyperboloid(double right)
{
  return AnalyticSurface([right](auto x, auto y, auto z)
    { return x * x / (A * A) + y * y / (B * B) - z * z / (C * C) - right; });
}

//------------------------------------------------------------------------------
// On the upper sheet.
std::array<Vector3d, 2> UmbilicsOfSheet()
{
  const double y = B * std::sqrt((A * A - B * B) / (B * B + C * C));
  const double z = C * std::sqrt((A * A + C * C) / (B * B + C * C));
  return { Vector3d(0.0, y, z), Vector3d(0.0, -y, z) };
}

//------------------------------------------------------------------------------
Mesh UpperSheet(int cells)
{
  return GraphPatch([](double x, double y)
    { return C * std::sqrt(1.0 + x * x / (A * A) + y * y / (B * B)); },
    1.5, cells, 0.2, 1);
}

//------------------------------------------------------------------------------
Mesh Below(Mesh mesh)
{
  for (std::size_t p = 0; p < mesh.PointCount(); ++p)
  {
    mesh.points[3 * p + 2] = -mesh.points[3 * p + 2];
  }
  return mesh;
}

//------------------------------------------------------------------------------
// Detects umbilics with exact forms and with fits, and hands them to the check.
template <typename Check>
void WithBothForms(const Mesh& mesh, const std::string& formula, Check check)
{
  vtkNew<vtkImplicitMongeForm> exact;
  exact->SetInputData(ToPolyData(mesh));
  exact->SetFormula(formula.c_str());
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(ToPolyData(mesh));
  for (vtkAlgorithm* forms :
    { static_cast<vtkAlgorithm*>(exact), static_cast<vtkAlgorithm*>(jets) })
  {
    SCOPED_TRACE(forms->GetClassName());
    vtkNew<vtkUmbilicDetection> detection;
    detection->SetInputConnection(forms->GetOutputPort());
    detection->Update();
    check(detection->GetOutput(1));
  }
}

} // namespace

//------------------------------------------------------------------------------
TEST(Hyperboloids, ClosedFormIsThatOfTheSurface)
{
  const AnalyticSurface surface = Hyperboloid(-1.0);
  for (const Vector3d& umbilic : UmbilicsOfSheet())
  {
    EXPECT_NEAR(surface.Value(umbilic), 0.0, 1e-14);
    const ExactMonge form = surface.Monge(umbilic);
    // The square root of round-off.
    EXPECT_LT(form.k1 - form.k2, 1e-7);
    EXPECT_EQ(IndexOnCircle(surface, umbilic, 1e-3), 0.5);
  }
  EXPECT_EQ(FindUmbilics(surface, UpperSheet(60)).size(), 2u);
}

//------------------------------------------------------------------------------
TEST(Hyperboloids, OfTwoSheetsHaveTwoUmbilicsOnEach)
{
  for (const int cells : { 40, 80 })
  {
    const Mesh upper = UpperSheet(cells);
    for (const double side : { 1.0, -1.0 })
    {
      WithBothForms(side > 0.0 ? upper : Below(upper), std::string(Formula) + " + 1",
        [&](vtkPolyData* found)
        {
          ASSERT_EQ(found->GetNumberOfPoints(), 2);
          vtkPointData* values = found->GetPointData();
          for (vtkIdType i = 0; i < 2; ++i)
          {
            EXPECT_EQ(Value(values, names::Index, i), 0.5);
            EXPECT_EQ(Value(values, names::RidgeCount, i), 1.0);
            EXPECT_EQ(Value(values, names::Pattern, i), 1.0);
            EXPECT_EQ(Value(values, names::NearBorder, i), 0.0);
            Vector3d expected = UmbilicsOfSheet()[PointAt(found, i).y() > 0.0 ? 0 : 1];
            expected.z() *= side;
            // Linear interpolation in a triangle: a share of its size.
            EXPECT_LT((PointAt(found, i) - expected).norm(), 0.1 * 3.0 / cells);
          }
        });
    }
  }
}

//------------------------------------------------------------------------------
TEST(Hyperboloids, OfOneSheetHaveNone)
{
  const Mesh mesh = ParametricMesh(
    [](double u, double v)
    {
      const double radius = std::sqrt(1.0 + v * v / (C * C));
      return Vector3d(A * radius * std::cos(u), B * radius * std::sin(u), v);
    },
    { 0.0, 2.0 * 3.14159265358979323846, -1.5, 1.5, 120, 60, true, false, 0.2 });
  ASSERT_TRUE(Topology(mesh).oriented);
  EXPECT_TRUE(FindUmbilics(Hyperboloid(1.0), mesh).empty());
  WithBothForms(mesh, std::string(Formula) + " - 1",
    [](vtkPolyData* found) { EXPECT_EQ(found->GetNumberOfPoints(), 0); });
}
