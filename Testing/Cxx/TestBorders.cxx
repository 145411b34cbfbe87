// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Open patches of surfaces whose forms and umbilics are known, with their borders anywhere: what
// automatic fits are worth there, and which umbilics are certain.

#include "ExactUmbilics.h"
#include "FilterTestTools.h"

#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRidgesArrayNames.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;
using Eigen::Vector3d;

constexpr int Cells = 50;

struct Patch
{
  std::string name;
  AnalyticSurface surface;
  HeightField height;
  double halfSize;
  Vector3d middle;
};

//------------------------------------------------------------------------------
// One sheet of x^2/1.69 + y^2 - z^2/0.64 = -1, with umbilics at y = +-0.6487 on x = 0.
Patch Hyperboloid(double x, double y)
{
  return { "hyperboloid",
    AnalyticSurface(
      [](auto u, auto v, auto w) { return w - 0.8 * sqrt(u * u / 1.69 + v * v + 1.0); }),
    [x, y](double u, double v)
    { return 0.8 * std::sqrt((u + x) * (u + x) / 1.69 + (v + y) * (v + y) + 1.0); },
    1.2, { x, y, 0.0 } };
}

//------------------------------------------------------------------------------
// The lower part of an ellipsoid of semi-axes 2, 1.6 and 1.
Patch Ellipsoid(double x, double y)
{
  return { "ellipsoid",
    AnalyticSurface(
      [](auto u, auto v, auto w) { return w + sqrt(1.0 - u * u / 4.0 - v * v / 2.56); }),
    [x, y](double u, double v)
    { return -std::sqrt(1.0 - (u + x) * (u + x) / 4.0 - (v + y) * (v + y) / 2.56); },
    0.6, { x, y, 0.0 } };
}

//------------------------------------------------------------------------------
Patch Saddle()
{
  return { "saddle",
    AnalyticSurface(
      [](auto u, auto v, auto w) { return w - 0.3 * sin(2.0 * u) * cos(1.5 * v) - 0.2 * u * v; }),
    [](double u, double v) { return 0.3 * std::sin(2.0 * u) * std::cos(1.5 * v) + 0.2 * u * v; },
    1.0, Vector3d::Zero() };
}

//------------------------------------------------------------------------------
// Around `middle`, so that the border can be anywhere.
Mesh MeshOf(const Patch& patch)
{
  Mesh mesh = GraphPatch(patch.height, patch.halfSize, Cells, 0.2, 1);
  for (std::size_t p = 0; p < mesh.PointCount(); ++p)
  {
    mesh.SetPoint(p, mesh.Point(p) + patch.middle);
  }
  return mesh;
}

//------------------------------------------------------------------------------
double DistanceFromBorder(const Patch& patch, const Vector3d& point)
{
  const Vector3d inside = (point - patch.middle).cwiseAbs();
  return patch.halfSize - std::max(inside.x(), inside.y());
}

//------------------------------------------------------------------------------
struct Errors
{
  double k = 0.0;
  double b = 0.0;
};

//------------------------------------------------------------------------------
// Root mean squares of the errors of k1 and k2, and of the norm of the third-order form, which no
// frame changes, over the points so far from the border.
Errors ErrorsOf(const Patch& patch, const Mesh& mesh, vtkPolyData* fitted, double from, double to)
{
  Errors sum;
  int count = 0;
  const auto norm = [](double b0, double b1, double b2, double b3)
  { return std::sqrt(b0 * b0 + 3.0 * b1 * b1 + 3.0 * b2 * b2 + b3 * b3); };
  for (std::size_t p = 0; p < mesh.PointCount(); ++p)
  {
    const double distance = DistanceFromBorder(patch, mesh.Point(p));
    if (distance < from || distance > to)
    {
      continue;
    }
    const ExactMonge exact = patch.surface.Monge(patch.surface.Project(mesh.Point(p)));
    const auto id = static_cast<vtkIdType>(p);
    vtkPointData* data = fitted->GetPointData();
    const auto b = [data, id](int i) { return Value(data, names::ThirdOrder, id, i); };
    sum.k += std::pow(Value(data, names::MaximumCurvature, id) - exact.k1, 2) +
      std::pow(Value(data, names::MinimumCurvature, id) - exact.k2, 2);
    sum.b += std::pow(
      norm(b(0), b(1), b(2), b(3)) - norm(exact.b[0], exact.b[1], exact.b[2], exact.b[3]), 2);
    ++count;
  }
  return { std::sqrt(sum.k / count), std::sqrt(sum.b / count) };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Fit(const Mesh& mesh, bool automatic)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(ToPolyData(mesh));
  if (!automatic)
  {
    jets->SetNeighborhoodToPointCount();
    jets->SetDegree(4);
    jets->SetMinimumNumberOfPoints(18);
  }
  jets->Update();
  return jets->GetOutput();
}

} // namespace

//------------------------------------------------------------------------------
// Inside, errors of automatic fits, of degree up to 8, fall so far that those at the border cannot
// follow. They are to be less than ten times those of fits of degree 4 inside, and than those of
// these fits at the border.
TEST(Borders, AutomaticFitsAreAsGoodAsThoseOfDegreeFourInside)
{
  for (const Patch& patch : { Hyperboloid(0.0, 0.0), Ellipsoid(0.3, 0.2), Saddle() })
  {
    const Mesh mesh = MeshOf(patch);
    const double edge = 2.0 * patch.halfSize / Cells;
    const auto automatic = Fit(mesh, true);
    const auto fixed = Fit(mesh, false);
    const Errors inside = ErrorsOf(patch, mesh, fixed, 10.0 * edge, 1e3);
    for (int edges = 0; edges < 4; ++edges)
    {
      const double from = (edges - 0.5) * edge;
      const Errors here = ErrorsOf(patch, mesh, automatic, from, from + edge);
      const Errors fixedHere = ErrorsOf(patch, mesh, fixed, from, from + edge);
      SCOPED_TRACE(patch.name + ", " + std::to_string(edges) + " edges from the border");
      EXPECT_LT(here.k, 10.0 * inside.k);
      EXPECT_LT(here.b, 10.0 * inside.b);
      EXPECT_LT(here.k, fixedHere.k);
      EXPECT_LT(here.b, fixedHere.b);
    }
  }
}

//------------------------------------------------------------------------------
TEST(Borders, PointsThereAreFlaggedAndNoOthers)
{
  const Patch patch = Saddle();
  const Mesh mesh = MeshOf(patch);
  const auto fitted = Fit(mesh, true);
  for (std::size_t p = 0; p < mesh.PointCount(); ++p)
  {
    const auto status =
      static_cast<int>(Value(fitted->GetPointData(), names::FitStatus, static_cast<vtkIdType>(p)));
    const bool isOnBorder = DistanceFromBorder(patch, mesh.Point(p)) < 1e-9;
    EXPECT_EQ((status & vtkJetFitting::FIT_BOUNDARY) != 0, isOnBorder) << p;
  }
}

//------------------------------------------------------------------------------
// The border goes over two umbilics. Those that are certain are all true, and none is on the
// border. With noise the places of umbilics are less exact.
TEST(Borders, UmbilicsNearThemAreNotCertain)
{
  const double edge = 2.0 * 1.2 / Cells;
  for (const double noise : { 0.0, 0.01 })
  {
    int certain = 0;
    int uncertain = 0;
    for (int edges = -2; edges <= 23; edges += noise > 0.0 ? 5 : 2)
    {
      // The border at x = so many edges beyond the umbilics, which are on x = 0.
      const Patch patch = Hyperboloid(edges * edge - 1.2, 0.1);
      const Mesh mesh = MeshOf(patch);
      const auto truth = FindUmbilics(patch.surface, mesh);
      vtkNew<vtkJetFitting> jets;
      jets->SetInputData(ToPolyData(AddNormalNoise(mesh, noise * edge, 1)));
      vtkNew<vtkUmbilicDetection> detection;
      detection->SetInputConnection(jets->GetOutputPort());
      detection->Update();
      vtkPolyData* found = detection->GetOutput(1);
      SCOPED_TRACE(std::to_string(edges) + " edges");
      for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
      {
        const double far = noise > 0.0 ? 4.0 : 0.5;
        const bool isTrue = std::any_of(truth.begin(), truth.end(),
          [found, edge, far, i](const ExactUmbilic& umbilic)
          {
            return (umbilic.position - PointAt(found, i)).norm() < far * edge &&
              umbilic.index == Value(found->GetPointData(), names::Index, i);
          });
        const double distance = DistanceFromBorder(patch, PointAt(found, i));
        const bool isFlagged = Value(found->GetPointData(), names::NearBorder, i) != 0.0;
        EXPECT_TRUE(isTrue || isFlagged) << PointAt(found, i).transpose();
        EXPECT_TRUE(distance > edge || isFlagged) << PointAt(found, i).transpose();
        ++(isFlagged ? uncertain : certain);
      }
    }
    EXPECT_GE(certain, noise > 0.0 ? 2 : 12);
    EXPECT_GE(uncertain, 4);
  }
}
