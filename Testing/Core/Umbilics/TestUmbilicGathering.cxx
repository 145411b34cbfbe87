// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Umbilics with their patches from the indices of triangles: nothing is lost, patches are disjoint
// disks with the index of their umbilic. Counted: no tolerance.

#include "Fixtures/EllipsoidFixture.h"
#include "Fixtures/TriangleSets.h"

#include "Monge/AcuteRule.h"
#include "Umbilics/DirectionIndex.h"
#include "Umbilics/UmbilicGathering.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <set>

namespace
{

using namespace ridges;
using namespace ridges::testing;

std::vector<IndexCharge> ChargesOf(const TriangleMesh& mesh, const DirectionIndex& index)
{
  std::vector<IndexCharge> charges;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const int halfTurns = index.IsUsable(t) ? index.HalfTurns(t) : 0;
    if (halfTurns != 0)
    {
      charges.push_back({ t, halfTurns });
    }
  }
  const std::vector<IndexCharge> more = ChargesOfUnusable(mesh, index);
  charges.insert(charges.end(), more.begin(), more.end());
  SpreadLargeCharges(mesh, charges);
  return charges;
}

int HalfTurnsIn(const std::vector<Id>& triangles, const std::map<Id, int>& chargeOf)
{
  int sum = 0;
  for (const Id t : triangles)
  {
    const auto charge = chargeOf.find(t);
    sum += charge == chargeOf.end() ? 0 : charge->second;
  }
  return sum;
}

std::vector<std::uint8_t> RandomFlags(std::size_t count, std::uint64_t seed, double share)
{
  std::mt19937_64 generator(seed);
  std::vector<std::uint8_t> flags(count);
  for (std::uint8_t& flag : flags)
  {
    flag = Uniform(generator) < share ? 1 : 0;
  }
  return flags;
}

// Returns the number of umbilics.
std::size_t CheckGathering(const TriangleMesh& mesh, const MongeField& field,
  const std::vector<std::uint8_t>& isWeak, const std::uint8_t* usable, double patchSize)
{
  const DirectionIndex index(mesh, field, usable);
  const std::vector<IndexCharge> charges = ChargesOf(mesh, index);
  std::map<Id, int> chargeOf;
  int before = 0;
  for (const IndexCharge& charge : charges)
  {
    chargeOf[charge.triangle] = charge.halfTurns;
    before += charge.halfTurns;
  }
  UmbilicGathering gathering(mesh, field, charges, isWeak, usable);
  const std::vector<Umbilic> umbilics = gathering.Umbilics(patchSize);
  std::map<Id, int> turnsAt;
  for (const Umbilic& umbilic : umbilics)
  {
    turnsAt[umbilic.triangle] += umbilic.index > 0.0 ? 1 : -1;
  }
  std::set<Id> taken;
  int after = 0;
  for (const Umbilic& umbilic : umbilics)
  {
    EXPECT_EQ(std::abs(umbilic.index), 0.5);
    after += umbilic.index > 0.0 ? 1 : -1;
    EXPECT_TRUE(umbilic.ridgeCount == 1 || (umbilic.ridgeCount == 3 && umbilic.index < 0.0));
    EXPECT_EQ(umbilic.pattern == UmbilicPattern::Star, umbilic.index < 0.0);
    EXPECT_EQ(umbilic.touchesBorder, TouchesBorder(mesh, umbilic.patch));
    if (umbilic.patch.empty())
    {
      EXPECT_GT(std::abs(turnsAt[umbilic.triangle]), 1); // The first has the patch.
      continue;
    }
    EXPECT_EQ(umbilic.patch.front(), umbilic.triangle);
    EXPECT_TRUE(IsConnected(mesh, umbilic.patch));
    EXPECT_EQ(EulerCharacteristicOf(mesh, umbilic.patch), 1);
    EXPECT_EQ(HalfTurnsIn(umbilic.patch, chargeOf), turnsAt[umbilic.triangle]);
    for (const Id t : umbilic.patch)
    {
      EXPECT_TRUE(taken.insert(t).second) << "two patches overlap";
    }
  }
  EXPECT_EQ(after, before);
  const TriangleGroups regions = gathering.CancelledRegions();
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    const Span<Id> region = regions[i];
    EXPECT_EQ(HalfTurnsIn({ region.begin(), region.end() }, chargeOf), 0);
    for (const Id t : region)
    {
      EXPECT_TRUE(taken.insert(t).second) << "a cancelled region is not its own";
    }
  }
  return umbilics.size();
}

int Crossings(
  const TriangleMesh& mesh, const MongeField& field, Color color, const std::vector<Id>& triangles)
{
  int count = 0;
  for (const Id e : ContourEdges(mesh, triangles))
  {
    count += IsCrossed(field, color, mesh.EdgeAt(e).v0, mesh.EdgeAt(e).v1) ? 1 : 0;
  }
  return count;
}

void CheckContours(const TriangleMesh& mesh, const MongeField& field, std::size_t expected)
{
  const std::vector<std::uint8_t> weak(mesh.NumberOfTriangles(), 0);
  for (const double patchSize : { 2.0, 3.0 })
  {
    UmbilicGathering gathering(
      mesh, field, ChargesOf(mesh, DirectionIndex(mesh, field, nullptr)), weak);
    const std::vector<Umbilic> umbilics = gathering.Umbilics(patchSize);
    EXPECT_EQ(umbilics.size(), expected);
    for (const Umbilic& umbilic : umbilics)
    {
      EXPECT_EQ(Crossings(mesh, field, Color::Blue, umbilic.patch), umbilic.ridgeCount);
      EXPECT_EQ(Crossings(mesh, field, Color::Red, umbilic.patch), umbilic.ridgeCount);
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
TEST(UmbilicGathering, LosesNothingOnRandomFields)
{
  std::size_t umbilics = 0;
  for (const Mesh& input : { Icosphere(10), TorusMesh(2.0, 0.7, 31, 15),
         AddNormalNoise(Icosphere(10), 0.03, 1), CylinderPatch(1.0, 2.0, 1.0, 25, 19) })
  {
    const MeshedSurface surface(input);
    const TriangleMesh& mesh = surface.Triangles();
    for (const double share : { 0.0, 0.3, 1.0 })
    {
      const FieldArrays field = RandomField(mesh, 1);
      const auto weak = RandomFlags(mesh.NumberOfTriangles(), 2, share);
      for (const double patchSize : { 1.0, 2.0, 6.0 })
      {
        umbilics += CheckGathering(mesh, field.View(), weak, nullptr, patchSize);
        const auto usable = RandomFlags(mesh.NumberOfPoints(), 3, 0.97);
        umbilics += CheckGathering(mesh, field.View(), weak, usable.data(), patchSize);
        ASSERT_FALSE(::testing::Test::HasFailure()) << share << " " << patchSize;
      }
    }
  }
  EXPECT_GT(umbilics, 1000u);
}

//------------------------------------------------------------------------------
TEST(UmbilicGathering, LeavesWhatTheEulerCharacteristicDemandsWhereAllIsWeak)
{
  const std::vector<std::pair<Mesh, std::size_t>> cases = { { Icosphere(8), 4 },
    { TorusMesh(2.0, 0.7, 31, 15), 0 } };
  for (const auto& item : cases)
  {
    const MeshedSurface surface(item.first);
    const TriangleMesh& mesh = surface.Triangles();
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      const FieldArrays field = RandomField(mesh, seed);
      const std::vector<std::uint8_t> weak(mesh.NumberOfTriangles(), 1);
      EXPECT_EQ(CheckGathering(mesh, field.View(), weak, nullptr, 2.0), item.second);
    }
  }
}

//------------------------------------------------------------------------------
TEST(UmbilicGathering, ContoursOfTheEllipsoidAreCrossedByItsRidges)
{
  for (const int frequency : { 32, 63 })
  {
    const FittedEllipsoid& ellipsoid = FittedEllipsoid::OfFrequency(frequency);
    CheckContours(ellipsoid.Triangles(), ellipsoid.field.View(), 4);
  }
}

//------------------------------------------------------------------------------
TEST(UmbilicGathering, ContoursOfTheBlendAreCrossedByItsRidges)
{
  const MeshedSurface surface(MeshSurface(BlendSurface(), 45));
  const FieldArrays field = FitField(surface.Triangles());
  CheckContours(surface.Triangles(), field.View(), 8);
}
