// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Errors of fits of degree 4 on meshes of known surfaces, and how they fall with the edge length h.
//
// By theory a fit of degree n has curvatures with an error of order n - 1 in h, third-order
// coefficients of order n - 2 and fourth-order ones of n - 3: 3, 2 and 1 for n = 4. On stencils
// that are almost symmetric about the point, and so almost everywhere on these meshes, the leading
// terms of odd degree cancel, and the mean errors fall by up to one order more.

#include "Fixtures/TestFields.h"

#include "Fit/JetFit.h"
#include "Fixtures/MongeComparison.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Eigen::Vector3d;

struct Errors
{
  double edge = 0.0;
  double max[3] = { 0.0, 0.0, 0.0 }; // Of k, b, P, relative to the largest on the surface.
  double mean[3] = { 0.0, 0.0, 0.0 };
  int points = 0;
};

// The errors over the border, or over all other points. Directions, and with them b, have no limit
// at umbilics: b and P are compared where k1 - k2 is above a tenth of the largest, and on a sphere,
// where b and P are zero for any directions, everywhere.
Errors MeasureErrors(const Mesh& input, const AnalyticSurface& exactSurface, bool border)
{
  const MeshedSurface surface(input);
  const TriangleMesh& mesh = surface.Triangles();
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  JetFitter fitter;
  std::vector<ExactMonge> exact;
  double largestGap = 0.0;
  double scale[3] = { 0.0, 0.0, 0.0 };
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    exact.push_back(exactSurface.Monge(mesh.Point(p)));
    const ExactMonge& e = exact.back();
    const double k = std::max(std::abs(e.k1), std::abs(e.k2));
    largestGap = std::max(largestGap, e.k1 - e.k2);
    scale[0] = std::max(scale[0], k);
    scale[1] = std::max(scale[1], k * k); // b may vanish, on spheres and cylinders.
    scale[2] = std::max(scale[2], k * k * k * k);
  }
  Errors errors;
  errors.edge = surface.Triangles().MeanEdgeLength();
  int compared[3] = { 0, 0, 0 };
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    if (mesh.OnBorder(p) != border)
    {
      continue;
    }
    ++errors.points;
    const JetFit fit = fitter.Fit(OffsetsAround(mesh, p, neighborhood, {}), 4, mesh.PointNormal(p));
    EXPECT_EQ(fit.status, FitGood);
    const MongeForm form = MongeFormOfHeightJet(fit.jet, fit.frame);
    const MongeForm reference = ToMongeForm(exact[p]);
    const double sign = CommonSign(form, reference);
    const double error[3] = { DifferenceOfDegree(2, form, reference, sign) / scale[0],
      DifferenceOfDegree(3, form, reference, sign) / scale[1],
      std::max(std::abs(form.P1() - exact[p].P1), std::abs(form.P2() - exact[p].P2)) / scale[2] };
    const bool nearUmbilic = exact[p].k1 - exact[p].k2 < 0.1 * largestGap && largestGap > 1e-9;
    for (int i = 0; i < (nearUmbilic ? 1 : 3); ++i)
    {
      errors.max[i] = std::max(errors.max[i], error[i]);
      errors.mean[i] += error[i];
      ++compared[i];
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    errors.mean[i] /= std::max(1, compared[i]);
  }
  return errors;
}

// The least orders of the means and of the maxima of k, b and P, from the first to the last size.
struct Orders
{
  double mean[3];
  double max[3];
};

Orders PrintAndMeasureOrders(const std::string& name, const std::vector<Errors>& sizes)
{
  std::printf("%-24s%10s%11s%11s%11s%11s%11s%11s\n", name.c_str(), "edge", "k mean", "k max",
    "b mean", "b max", "P mean", "P max");
  for (const Errors& e : sizes)
  {
    std::printf("%16d points%11.4f%11.2e%11.2e%11.2e%11.2e%11.2e%11.2e\n", e.points, e.edge,
      e.mean[0], e.max[0], e.mean[1], e.max[1], e.mean[2], e.max[2]);
  }
  Orders orders{};
  const double h = std::log(sizes.front().edge / sizes.back().edge);
  std::printf("%23s%11s", "order", "");
  for (int i = 0; i < 3; ++i)
  {
    orders.mean[i] = std::log(sizes.front().mean[i] / sizes.back().mean[i]) / h;
    orders.max[i] = std::log(sizes.front().max[i] / sizes.back().max[i]) / h;
    std::printf("%11.2f%11.2f", orders.mean[i], orders.max[i]);
  }
  std::printf("\n");
  return orders;
}

// Means fall at the orders of theory at least. A maximum is that of one point, whose stencil is
// another one at each size: it is allowed half an order less.
void ExpectOrders(const Orders& orders, double k, double b, double P)
{
  const double expected[3] = { k, b, P };
  const char* const names[3] = { "k", "b", "P" };
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_GE(orders.mean[i], expected[i]) << names[i] << " mean";
    EXPECT_GE(orders.max[i], expected[i] - 0.5) << names[i] << " max";
  }
}

// Points of a mesh moved at random by at most this part of the mean edge, and back on the surface.
Mesh Jittered(Mesh mesh, const AnalyticSurface& surface, double part, bool keepBorder = false)
{
  std::mt19937_64 generator(51);
  const MeshedSurface before(mesh);
  const double radius = part * before.Triangles().MeanEdgeLength();
  for (std::size_t p = 0; p < mesh.PointCount(); ++p)
  {
    const Vector3d move = radius * InBall(generator);
    if (!keepBorder || !before.Triangles().OnBorder(static_cast<Id>(p)))
    {
      mesh.SetPoint(p, surface.Project(mesh.Point(p) + move));
    }
  }
  return mesh;
}

} // namespace

//------------------------------------------------------------------------------
TEST(JetFitConvergence, OnASphere)
{
  const AnalyticSurface surface = MakeSphere(2.0);
  std::vector<Errors> sizes;
  for (const int frequency : { 10, 20, 40 })
  {
    const Mesh mesh = Jittered(EllipsoidMesh(frequency, 2.0, 2.0, 2.0), surface, 0.2);
    sizes.push_back(MeasureErrors(mesh, surface, false));
  }
  ExpectOrders(PrintAndMeasureOrders("sphere", sizes), 3.0, 2.0, 1.0);
}

//------------------------------------------------------------------------------
TEST(JetFitConvergence, OnACylinderAndItsBorder)
{
  const AnalyticSurface surface = MakeCylinder(1.0);
  std::vector<Errors> inside;
  std::vector<Errors> border;
  for (const int n : { 12, 24, 48 })
  {
    const Mesh mesh = Jittered(CylinderPatch(1.0, 2.0, 1.5, n, n), surface, 0.2, true);
    inside.push_back(MeasureErrors(mesh, surface, false));
    border.push_back(MeasureErrors(mesh, surface, true));
    EXPECT_EQ(border.back().points, 4 * n); // All of the border, and nothing else, is flagged.
  }
  ExpectOrders(PrintAndMeasureOrders("cylinder", inside), 3.0, 2.0, 1.0);
  // One-sided stencils reach twice as far, and nothing cancels.
  const Orders orders = PrintAndMeasureOrders("cylinder's border", border);
  EXPECT_GE(orders.mean[0], 2.0);
  EXPECT_GE(orders.max[0], 2.0);
}

//------------------------------------------------------------------------------
TEST(JetFitConvergence, OnATorus)
{
  const AnalyticSurface surface = MakeTorus(2.0, 0.8);
  std::vector<Errors> sizes;
  for (const int n : { 20, 40, 80 })
  {
    const Mesh mesh = Jittered(TorusMesh(2.0, 0.8, 5 * n / 2, n), surface, 0.2);
    sizes.push_back(MeasureErrors(mesh, surface, false));
  }
  ExpectOrders(PrintAndMeasureOrders("torus", sizes), 3.0, 2.0, 1.0);
}

//------------------------------------------------------------------------------
TEST(JetFitConvergence, OnAnEllipsoid)
{
  const AnalyticSurface surface = MakeEllipsoid(1.0, 0.8, 0.6);
  std::vector<Errors> jittered;
  std::vector<Errors> even;
  for (const int frequency : { 14, 28, 56 })
  {
    const Mesh mesh = EllipsoidMesh(frequency, 1.0, 0.8, 0.6);
    even.push_back(MeasureErrors(mesh, surface, false));
    jittered.push_back(MeasureErrors(Jittered(mesh, surface, 0.2), surface, false));
  }
  ExpectOrders(PrintAndMeasureOrders("ellipsoid", even), 3.0, 2.0, 1.0);
  ExpectOrders(PrintAndMeasureOrders("jittered ellipsoid", jittered), 3.0, 2.0, 1.0);
}
