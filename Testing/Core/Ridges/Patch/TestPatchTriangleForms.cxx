// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/Patch/PatchTriangleForms.h"

#include "Fixtures/TestFields.h"

#include "Monge/AcuteRule.h"
#include "Umbilics/UmbilicForm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using namespace ridges;
using namespace ridges::testing;

double ValueAt(const SymmetricTensor<3>& form, double angle)
{
  return ContractAll(form, Eigen::Vector2d(std::cos(angle), std::sin(angle)));
}

} // namespace

//------------------------------------------------------------------------------
// The form changes its sign at each root, and at no other of 3600 angles.
TEST(PatchTriangleForms, RootsAreWhereACubicFormChangesItsSign)
{
  constexpr double pi = 3.14159265358979323846;
  std::mt19937_64 generator(5);
  for (int trial = 0; trial < 200; ++trial)
  {
    SymmetricTensor<3> form{};
    for (double& value : form)
    {
      value = Symmetric(generator);
    }
    if (trial % 10 == 0)
    {
      form[3] = 0.0; // a root at a right angle, where the tangent is not finite
    }
    const std::vector<double> roots = RootAngles(form);
    ASSERT_EQ(static_cast<int>(roots.size()), RidgeCountOf(form));
    for (const double root : roots)
    {
      EXPECT_NEAR(ValueAt(form, root), 0.0, 1e-12); // of coefficients of 1: round-off
    }
    constexpr int count = 3600;
    int changes = 0;
    for (int i = 0; i < count; ++i)
    {
      // Off all round angles.
      const double from = pi * (i + 0.123) / count;
      const double to = pi * (i + 1.123) / count;
      changes += (ValueAt(form, from) < 0.0) != (ValueAt(form, to) < 0.0) ? 1 : 0;
    }
    // Two may be between two neighbouring angles.
    EXPECT_EQ(changes % 2, static_cast<int>(roots.size()) % 2);
    EXPECT_LE(changes, static_cast<int>(roots.size()));
  }
}

//------------------------------------------------------------------------------
// On an ellipsoid of 9,002 points: where both orders are exact they differ by a term that falls
// with the edge. The way from the umbilic leads to where d1 has the angle that was asked for.
TEST(PatchTriangleForms, OrdersAgreeAndWaysLeadToDirections)
{
  const MeshedSurface surface(EllipsoidMesh(30, 1.4, 1.0, 0.6));
  const TriangleMesh& mesh = surface.Triangles();
  const FieldArrays field = ExactField(mesh, MakeEllipsoid(1.4, 1.0, 0.6));
  int umbilics = 0;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (IsRegular(mesh, field.View(), t))
    {
      continue;
    }
    ++umbilics;
    const PatchTriangleForms forms(mesh, field.View(), t);
    const Eigen::Vector3d umbilic = UmbilicWeights(mesh, field.View(), t);
    const SymmetricTensor<3> third = forms.ThirdOrderAt(umbilic);
    EXPECT_LT(forms.DifferenceOfOrders(mesh, third), 0.1);
    EXPECT_LT(forms.SpreadAround(third), 0.2);
    for (const double angle : { 0.1, 0.9, 1.7, 2.5 })
    {
      const Eigen::Vector3d way = forms.WayTo(angle);
      const double found = forms.AngleAt(umbilic + 1e-3 * way / way.norm());
      EXPECT_NEAR(std::abs(std::cos(found - angle)), 1.0, 1e-6);
    }
  }
  EXPECT_EQ(umbilics, 4);
}
