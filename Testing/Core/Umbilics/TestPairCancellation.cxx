// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Which umbilics cancel each other, on made-up charges and weak triangles: no tolerance.

#include "Fixtures/TriangleSets.h"

#include "Umbilics/PairCancellation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace
{

using namespace ridges;
using namespace ridges::testing;

std::vector<Id> ToVector(Span<Id> ids)
{
  return { ids.begin(), ids.end() };
}

std::set<Id> ToSet(Span<Id> ids)
{
  return { ids.begin(), ids.end() };
}

std::vector<IndexCharge> RandomCharges(const TriangleMesh& mesh, std::uint64_t seed, double share)
{
  std::mt19937_64 generator(seed);
  std::vector<IndexCharge> charges;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (Uniform(generator) < share)
    {
      charges.push_back({ t, Uniform(generator) < 0.6 ? 1 : -1 });
    }
  }
  return charges;
}

// Blotches that cover about this share.
std::vector<std::uint8_t> RandomWeak(const TriangleMesh& mesh, std::uint64_t seed, double share)
{
  std::mt19937_64 generator(seed);
  std::vector<std::uint8_t> isWeak(mesh.NumberOfTriangles(), 0);
  double covered = 0.0;
  while (covered < share * mesh.NumberOfTriangles())
  {
    for (const Id t : RandomRegion(mesh, generator, 20))
    {
      covered += isWeak[t] ? 0.0 : 1.0;
      isWeak[t] = 1;
    }
  }
  return isWeak;
}

// Opposite ones that are kept are nowhere joined through weak triangles, or side by side.
void CheckNoWayIsLeft(
  const TriangleMesh& mesh, const Cancellation& result, const std::vector<std::uint8_t>& isWeak)
{
  std::map<Id, int> kept;
  std::vector<bool> isOpen(isWeak.begin(), isWeak.end());
  for (const IndexCharge& charge : result.kept)
  {
    kept[charge.triangle] = charge.halfTurns;
    isOpen[charge.triangle] = true;
  }
  for (const IndexCharge& charge : result.kept)
  {
    for (const Id t : ComponentOf(mesh, charge.triangle, isOpen))
    {
      const auto other = kept.find(t);
      ASSERT_FALSE(other != kept.end() && other->second == -charge.halfTurns)
        << "between " << charge.triangle << " and " << t;
    }
  }
}

void CheckRegions(const TriangleMesh& mesh, const Cancellation& result,
  const std::vector<IndexCharge>& charges, const std::vector<std::uint8_t>& isWeak)
{
  std::map<Id, int> before;
  for (const IndexCharge& charge : charges)
  {
    before[charge.triangle] = charge.halfTurns;
  }
  std::set<Id> kept;
  for (const IndexCharge& charge : result.kept)
  {
    EXPECT_EQ(before[charge.triangle], charge.halfTurns);
    EXPECT_TRUE(kept.insert(charge.triangle).second);
  }
  std::set<Id> taken;
  std::size_t cancelled = 0;
  for (std::size_t i = 0; i < result.regions.size(); ++i)
  {
    const std::vector<Id> region = ToVector(result.regions[i]);
    ASSERT_FALSE(region.empty());
    EXPECT_TRUE(IsConnected(mesh, region));
    int sum = 0;
    for (const Id t : region)
    {
      ASSERT_TRUE(taken.insert(t).second) << "triangle " << t << " is in two regions";
      EXPECT_EQ(result.regionOf[t], static_cast<Id>(i));
      EXPECT_EQ(kept.count(t), 0u);
      const auto charge = before.find(t);
      EXPECT_TRUE(charge != before.end() || isWeak[t]);
      sum += charge != before.end() ? charge->second : 0;
      cancelled += charge != before.end() ? 1 : 0;
    }
    EXPECT_EQ(sum, 0);
  }
  EXPECT_EQ(cancelled + result.kept.size(), charges.size());
  for (std::size_t t = 0; t < result.regionOf.size(); ++t)
  {
    EXPECT_EQ(result.regionOf[t] != Cancellation::NoRegion, taken.count(static_cast<Id>(t)) > 0);
  }
}

// Triangles on the path, and its length.
using PathLength = std::pair<int, double>;

// The lengths of the shortest paths from a triangle to all others that can be reached from it.
std::map<Id, PathLength> PathsFrom(
  const TriangleMesh& mesh, Id first, const std::vector<std::uint8_t>& isOpen)
{
  std::map<Id, PathLength> lengths;
  std::set<std::pair<PathLength, Id>> front = { { { 0, 0.0 }, first } };
  while (!front.empty())
  {
    const auto [length, t] = *front.begin();
    front.erase(front.begin());
    if (!lengths.insert({ t, length }).second)
    {
      continue;
    }
    for (int side = 0; side < 3; ++side)
    {
      const Id next = mesh.Neighbor(t, side);
      if (next >= 0 && isOpen[next])
      {
        const double step = (mesh.Centroid(next) - mesh.Centroid(t)).norm();
        front.insert({ { length.first + 1, length.second + step }, next });
      }
    }
  }
  return lengths;
}

// Again and again the pair with the shortest path, among all.
std::set<Id> KeptByDefinition(const TriangleMesh& mesh, const std::vector<IndexCharge>& charges,
  std::vector<std::uint8_t> isOpen)
{
  for (const IndexCharge& charge : charges)
  {
    isOpen[charge.triangle] = 1;
  }
  std::vector<std::tuple<PathLength, Id, Id>> pairs;
  std::set<Id> kept;
  for (const IndexCharge& charge : charges)
  {
    kept.insert(charge.triangle);
    const std::map<Id, PathLength> lengths = PathsFrom(mesh, charge.triangle, isOpen);
    for (const IndexCharge& other : charges)
    {
      const auto found = lengths.find(other.triangle);
      if (charge.halfTurns > 0 && other.halfTurns < 0 && found != lengths.end())
      {
        pairs.emplace_back(found->second, charge.triangle, other.triangle);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [length, positive, negative] : pairs)
  {
    if (kept.count(positive) > 0 && kept.count(negative) > 0)
    {
      kept.erase(positive);
      kept.erase(negative);
    }
  }
  return kept;
}

// The same umbilics and regions whatever the numbering.
void CheckRenumbered(const Mesh& input)
{
  const MeshedSurface surface(input);
  const auto charges = RandomCharges(surface.Triangles(), 4, 0.1);
  const auto isWeak = RandomWeak(surface.Triangles(), 5, 0.5);
  const Cancellation expected = CancelPairs(surface.Triangles(), charges, isWeak);
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    const Renumbered other(input, seed);
    std::vector<IndexCharge> otherCharges;
    otherCharges.reserve(charges.size());
    for (const IndexCharge& charge : charges)
    {
      otherCharges.push_back({ other.newTriangle[charge.triangle], charge.halfTurns });
    }
    std::vector<std::uint8_t> otherWeak(isWeak.size());
    for (std::size_t t = 0; t < isWeak.size(); ++t)
    {
      otherWeak[other.newTriangle[t]] = isWeak[t];
    }
    const Cancellation found = CancelPairs(other.surface.Triangles(), otherCharges, otherWeak);
    ASSERT_EQ(found.kept.size(), expected.kept.size());
    for (std::size_t i = 0; i < found.kept.size(); ++i)
    {
      EXPECT_EQ(found.kept[i].triangle, other.newTriangle[expected.kept[i].triangle]);
    }
    ASSERT_EQ(found.regions.size(), expected.regions.size());
    for (std::size_t i = 0; i < found.regions.size(); ++i)
    {
      std::set<Id> renamed;
      for (const Id t : expected.regions[i])
      {
        renamed.insert(other.newTriangle[t]);
      }
      EXPECT_EQ(ToSet(found.regions[i]), renamed);
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
TEST(PairCancellation, ConservesTheSumAndLeavesNoPath)
{
  std::size_t regions = 0;
  std::size_t kept = 0;
  for (const Mesh& input :
    { Icosphere(12), TorusMesh(2.0, 0.7, 41, 21), CylinderPatch(1.0, 2.0, 1.0, 25, 19) })
  {
    const MeshedSurface surface(input);
    const TriangleMesh& mesh = surface.Triangles();
    for (const double weak : { 0.0, 0.1, 0.4, 0.9 })
    {
      for (const double share : { 0.01, 0.1, 0.5 })
      {
        for (std::uint64_t seed = 1; seed <= 3; ++seed)
        {
          const auto charges = RandomCharges(mesh, seed, share);
          const auto isWeak = RandomWeak(mesh, seed + 10, weak);
          const Cancellation result = CancelPairs(mesh, charges, isWeak);
          EXPECT_EQ(SumOf(result.kept), SumOf(charges));
          CheckRegions(mesh, result, charges, isWeak);
          CheckNoWayIsLeft(mesh, result, isWeak);
          regions += result.regions.size();
          kept += result.kept.size();
        }
      }
    }
  }
  EXPECT_GT(regions, 1000u);
  EXPECT_GT(kept, 1000u);
}

//------------------------------------------------------------------------------
// On irregular meshes: no two paths are of one length.
TEST(PairCancellation, AlwaysTakesTheShortestPathOfAll)
{
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    const MeshedSurface surface(AddNormalNoise(Icosphere(6), 0.01, seed));
    const TriangleMesh& mesh = surface.Triangles();
    for (const double share : { 0.02, 0.1, 0.4 })
    {
      const auto charges = RandomCharges(mesh, seed, share);
      const auto isWeak = RandomWeak(mesh, seed + 10, 0.2 * static_cast<double>(seed));
      std::set<Id> kept;
      for (const IndexCharge& charge : CancelPairs(mesh, charges, isWeak).kept)
      {
        kept.insert(charge.triangle);
      }
      EXPECT_EQ(kept, KeptByDefinition(mesh, charges, isWeak));
    }
  }
}

//------------------------------------------------------------------------------
TEST(PairCancellation, TakesTheNearestFirst)
{
  // A strip of triangles, all weak: one pair at a distance of 3 triangles, another of 8.
  const MeshedSurface surface(GraphPatch([](double, double) { return 0.0; }, 1.0, 20));
  const TriangleMesh& mesh = surface.Triangles();
  const std::vector<std::uint8_t> weak(mesh.NumberOfTriangles(), 1);
  const std::vector<IndexCharge> charges = { { 0, 1 }, { 16, -1 }, { 22, 1 } };
  const Cancellation result = CancelPairs(mesh, charges, weak);
  ASSERT_EQ(result.kept.size(), 1u);
  EXPECT_EQ(result.kept[0].triangle, 0);
  ASSERT_EQ(result.regions.size(), 1u);
}

//------------------------------------------------------------------------------
TEST(PairCancellation, WithoutWeakTrianglesOnlyNeighboursCancel)
{
  const MeshedSurface surface(Icosphere(6));
  const TriangleMesh& mesh = surface.Triangles();
  const std::vector<std::uint8_t> weak(mesh.NumberOfTriangles(), 0);
  const Id beside = mesh.Neighbor(7, 1);
  const Id twoAway = mesh.Neighbor(mesh.Neighbor(300, 0), 1);
  const Cancellation result =
    CancelPairs(mesh, { { 7, 1 }, { beside, -1 }, { 300, 1 }, { twoAway, -1 } }, weak);
  EXPECT_EQ(result.kept.size(), 2u);
  ASSERT_EQ(result.regions.size(), 1u);
  EXPECT_EQ(ToSet(result.regions[0]), (std::set<Id>{ 7, beside }));
}

//------------------------------------------------------------------------------
TEST(PairCancellation, LeavesLargeOnesAlone)
{
  const MeshedSurface surface(Icosphere(6));
  const TriangleMesh& mesh = surface.Triangles();
  const std::vector<std::uint8_t> weak(mesh.NumberOfTriangles(), 1);
  const Cancellation result = CancelPairs(mesh, { { 7, 2 }, { mesh.Neighbor(7, 1), -1 } }, weak);
  EXPECT_EQ(result.kept.size(), 2u);
  EXPECT_TRUE(result.regions.empty());
}

//------------------------------------------------------------------------------
TEST(PairCancellation, DoesNotDependOnTheNumbering)
{
  CheckRenumbered(AddNormalNoise(Icosphere(12), 0.01, 1));
}

//------------------------------------------------------------------------------
TEST(PairCancellation, DoesNotDependOnTheNumberingWhereWaysAreOfOneLength)
{
  CheckRenumbered(TorusMesh(2.0, 0.7, 40, 20));
}
