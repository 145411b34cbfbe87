// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/TestFields.h"

#include "Ridges/TypeErrors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using namespace ridges;
using namespace ridges::testing;

/// A flat fan around the first point, at which b0 rises by `Rise` along d1 and b3 by as much along
/// d2, in frames turned at random.
struct Fan
{
  static constexpr double Rise = 3.0;
  static constexpr double Gap = 0.5;

  explicit Fan(int numberOfTriangles)
    : surface(MeshOf(numberOfTriangles))
    , field(surface.Triangles().NumberOfPoints())
    , residual(field.k1.size(), 1e-3)
    , scale(field.k1.size(), 2.0)
    , gain(field.k1.size(), 50.0)
  {
    const TriangleMesh& mesh = this->surface.Triangles();
    for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
    {
      MongeForm form;
      form.d1 = Eigen::Vector3d::UnitX();
      form.d2 = Eigen::Vector3d::UnitY();
      form.n = Eigen::Vector3d::UnitZ();
      form.k1 = 0.75;
      form.k2 = form.k1 - Gap;
      form.b = { 0.1 + Rise * mesh.Point(p).x(), 0.2, 0.4, Rise * mesh.Point(p).y() - 0.1 };
      this->field.Set(p, form);
      if (p % 3 == 1)
      {
        this->field.Turn(p);
      }
    }
    this->view = this->field.View();
    this->source.fitResidual = this->residual.data();
    this->source.fitScale = this->scale.data();
    this->source.noiseGain = this->gain.data();
  }

  static Mesh MeshOf(int numberOfTriangles)
  {
    Mesh mesh;
    mesh.AddPoint(Eigen::Vector3d::Zero());
    for (int i = 0; i < numberOfTriangles; ++i)
    {
      const double angle = 2.0 * 3.14159265358979323846 * i / numberOfTriangles;
      mesh.AddPoint({ std::cos(angle), std::sin(angle), 0.0 });
      const int next = (i + 1) % numberOfTriangles;
      mesh.triangles.insert(mesh.triangles.end(), { 0, 1 + i, 1 + next });
    }
    return mesh;
  }

  MeshedSurface surface;
  FieldArrays field;
  std::vector<double> residual;
  std::vector<double> scale;
  std::vector<double> gain;
  MongeField view;
  FitErrorSource source;
};

/// At the point of a fan that has all triangles.
TypeErrors ErrorsInTheMiddle(const Fan& fan, const FitErrorSource& source)
{
  TypeErrors errors(fan.surface.Triangles(), fan.view, source);
  errors.Require(Color::Blue, 0);
  errors.Require(Color::Red, 0);
  errors.Find(0, fan.surface.Triangles().NumberOfPoints());
  return errors;
}

// The extremality is linear, so that its slope has errors of rounding only.
TEST(TypeErrors, SlopeOfALinearExtremalityIsExactForAnyValence)
{
  for (const int numberOfTriangles : { 6, 1000 })
  {
    const Fan fan(numberOfTriangles);
    const TypeErrors errors = ErrorsInTheMiddle(fan, fan.source);
    EXPECT_NEAR(errors.SlopeAt(Color::Blue, 0), Fan::Gap * Fan::Rise, 1e-12) << numberOfTriangles;
    EXPECT_NEAR(errors.SlopeAt(Color::Red, 0), -Fan::Gap * Fan::Rise, 1e-12) << numberOfTriangles;
  }
}

// With the same residual everywhere the mean is that residual: noise of the third order is
// 50 * (1e-3 * 2) / 2^3 = 0.0125; P has 6 b1 of it times 0.3 (6 b2 for P2), and the gap times 6
// over the radius.
TEST(TypeErrors, ErrorOfPFollowsFromTheResidualForAnyValence)
{
  for (const int numberOfTriangles : { 6, 1000 })
  {
    const Fan fan(numberOfTriangles);
    const TypeErrors errors = ErrorsInTheMiddle(fan, fan.source);
    EXPECT_NEAR(
      errors.ErrorAt(Color::Blue, 0), 0.0125 * std::hypot(6.0 * 0.2 * 0.3, Fan::Gap * 3.0), 1e-8)
      << numberOfTriangles;
    EXPECT_NEAR(
      errors.ErrorAt(Color::Red, 0), 0.0125 * std::hypot(6.0 * 0.4 * 0.3, Fan::Gap * 3.0), 1e-8)
      << numberOfTriangles;
  }
}

TEST(TypeErrors, NothingIsKnownWithoutFits)
{
  const Fan fan(1000);
  const FitErrorSource nothing;
  const TypeErrors errors = ErrorsInTheMiddle(fan, nothing);
  EXPECT_EQ(errors.ErrorAt(Color::Blue, 0), 0.0);
  EXPECT_NEAR(errors.SlopeAt(Color::Blue, 0), Fan::Gap * Fan::Rise, 1e-12);
}

} // namespace
