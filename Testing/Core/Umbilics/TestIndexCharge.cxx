// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Where indices are put differently their sum stays. Integers, no tolerance.

#include "Fixtures/TriangleSets.h"

#include "Umbilics/IndexCharge.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <set>

namespace
{

using namespace ridges;
using namespace ridges::testing;

// On different triangles, of -3 to 3 half turns.
std::vector<IndexCharge> RandomCharges(const TriangleMesh& mesh, std::uint64_t seed, double share)
{
  std::mt19937_64 generator(seed);
  std::vector<IndexCharge> charges;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const int halfTurns = static_cast<int>(7.0 * Uniform(generator)) - 3;
    if (halfTurns != 0 && Uniform(generator) < share)
    {
      charges.push_back({ t, halfTurns });
    }
  }
  return charges;
}

} // namespace

//------------------------------------------------------------------------------
TEST(IndexCharge, SpreadingConservesTheSum)
{
  const MeshedSurface surface(Icosphere(10));
  const TriangleMesh& mesh = surface.Triangles();
  for (const double share : { 0.01, 0.1, 0.9 })
  {
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
      const std::vector<IndexCharge> before = RandomCharges(mesh, seed, share);
      std::vector<IndexCharge> after = before;
      SpreadLargeCharges(mesh, after);
      EXPECT_EQ(SumOf(after), SumOf(before));
      std::map<Id, int> old;
      for (const IndexCharge& charge : before)
      {
        old[charge.triangle] = charge.halfTurns;
      }
      std::set<Id> triangles;
      for (const IndexCharge& charge : after)
      {
        EXPECT_NE(charge.halfTurns, 0);
        EXPECT_TRUE(triangles.insert(charge.triangle).second);
        // No new places, none with more than before, and the same parity.
        ASSERT_EQ(old.count(charge.triangle), 1u);
        EXPECT_LE(std::abs(charge.halfTurns), std::abs(old[charge.triangle]));
        EXPECT_EQ((charge.halfTurns - old[charge.triangle]) % 2, 0);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(IndexCharge, SpreadingLeavesNoLargeOneBesideItsOpposite)
{
  const MeshedSurface surface(Icosphere(6));
  const TriangleMesh& mesh = surface.Triangles();
  const Id next = mesh.Neighbor(mesh.Neighbor(50, 0), 1);
  for (const int sign : { 1, -1 })
  {
    std::vector<IndexCharge> charges = { { 50, 3 * sign }, { next, -sign }, { 400, sign } };
    SpreadLargeCharges(mesh, charges);
    EXPECT_EQ(SumOf(charges), 3 * sign);
    for (const IndexCharge& charge : charges)
    {
      EXPECT_EQ(charge.halfTurns, sign);
    }
    EXPECT_EQ(charges.size(), 3u);
  }
}

//------------------------------------------------------------------------------
TEST(IndexCharge, SpreadingDoesNotDependOnTheNumbering)
{
  const Mesh input = AddNormalNoise(Icosphere(10), 0.01, 1);
  const MeshedSurface surface(input);
  const std::vector<IndexCharge> before = RandomCharges(surface.Triangles(), 3, 0.2);
  std::vector<IndexCharge> expected = before;
  SpreadLargeCharges(surface.Triangles(), expected);
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    const Renumbered other(input, seed);
    std::vector<IndexCharge> charges;
    charges.reserve(before.size());
    for (const IndexCharge& charge : before)
    {
      charges.push_back({ other.newTriangle[charge.triangle], charge.halfTurns });
    }
    SpreadLargeCharges(other.surface.Triangles(), charges);
    ASSERT_EQ(charges.size(), expected.size());
    for (std::size_t i = 0; i < charges.size(); ++i)
    {
      EXPECT_EQ(charges[i].triangle, other.newTriangle[expected[i].triangle]);
      EXPECT_EQ(charges[i].halfTurns, expected[i].halfTurns);
    }
  }
}

//------------------------------------------------------------------------------
TEST(IndexCharge, OfUnusableRegionsFollowsFromTheirSurroundings)
{
  const MeshedSurface surface(TorusMesh(2.0, 0.7, 41, 21));
  const TriangleMesh& mesh = surface.Triangles();
  const FieldArrays field = RandomField(mesh, 2);
  std::vector<std::uint8_t> usable(mesh.NumberOfPoints(), 1);
  for (const Id p : { 10, 200, 201, 202, 203, 500, 700 })
  {
    usable[p] = 0;
  }
  const DirectionIndex index(mesh, field.View(), usable.data());
  std::map<Id, int> chargeOf;
  for (const IndexCharge& charge : ChargesOfUnusable(mesh, index))
  {
    chargeOf[charge.triangle] = charge.halfTurns;
  }
  std::vector<bool> isUnusable(mesh.NumberOfTriangles());
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    isUnusable[t] = !index.IsUsable(t);
  }
  std::set<Id> seen;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (isUnusable[t] && !seen.count(t))
    {
      const std::vector<Id> region = ComponentOf(mesh, t, isUnusable);
      int sum = 0;
      for (const Id s : region)
      {
        sum += chargeOf[s];
        seen.insert(s);
      }
      EXPECT_EQ(sum, index.HalfTurns(region));
    }
  }
}
