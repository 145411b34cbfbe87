// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/TestFields.h"

#include "Ridges/RidgeZones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Verdict = ExtremalityErrors::Verdict;

RidgeZones ZonesOf(const TriangleMesh& mesh, const std::vector<Verdict>& verdicts)
{
  RidgeZones zones(mesh);
  EXPECT_TRUE(zones.Find(verdicts));
  return zones;
}

class RidgeZonesOnGrid : public ::testing::Test
{
protected:
  // 41 by 41 points.
  RidgeZonesOnGrid()
    : Surface(GraphPatch([](double, double) { return 0.0; }, 1.0, 40))
    , Mesh(Surface.Triangles())
    , Verdicts(Mesh.NumberOfPoints(), Verdict::Insignificant)
  {
  }

  Eigen::Vector3d At(Id p) const { return this->Mesh.Point(p); }

  RidgeZones Zones() const { return ZonesOf(this->Mesh, this->Verdicts); }

  MeshedSurface Surface;
  const TriangleMesh& Mesh;
  std::vector<Verdict> Verdicts;
};

} // namespace

//------------------------------------------------------------------------------
TEST_F(RidgeZonesOnGrid, InsignificantMeshIsOneZone)
{
  const RidgeZones zones = Zones();
  ASSERT_EQ(zones.Regions().size(), 1u);
  EXPECT_EQ(static_cast<Id>(zones.Regions()[0].size()), Mesh.NumberOfPoints());
  EXPECT_FALSE(zones.IsRoundOff(0));
  std::vector<Id> triangles = zones.TrianglesOf(0);
  EXPECT_EQ(static_cast<Id>(triangles.size()), Mesh.NumberOfTriangles());
  std::sort(triangles.begin(), triangles.end());
  EXPECT_EQ(std::unique(triangles.begin(), triangles.end()), triangles.end());
}

//------------------------------------------------------------------------------
TEST_F(RidgeZonesOnGrid, ZonesKeepAwayFromWhatIsSignificantOrUnresolved)
{
  const Id center = 840;
  const double edge = 2.0 / 40;
  for (const Verdict other : { Verdict::Significant, Verdict::Unresolved })
  {
    Verdicts[center] = other;
    if (other == Verdict::Unresolved)
    {
      EXPECT_EQ(static_cast<Id>(Zones().Regions()[0].size()),
        Mesh.NumberOfPoints()); // one is too few
      static_assert(RidgeZones::LeastUnresolved == 4, "three more to the left");
      std::fill_n(Verdicts.begin() + center - 3, 3, other);
    }
    const RidgeZones zones = Zones();
    ASSERT_EQ(zones.Regions().size(), 1u);
    for (Id p = 0; p < Mesh.NumberOfPoints(); ++p)
    {
      const double distance = (At(p) - At(center)).lpNorm<Eigen::Infinity>();
      if (distance > (RidgeZones::Margin + 3.5) * edge)
      {
        EXPECT_EQ(zones.RegionOf(p), 0);
      }
    }
    EXPECT_EQ(zones.RegionOf(center), -1);
    EXPECT_EQ(zones.RegionOf(center + RidgeZones::Margin), -1);
    EXPECT_EQ(zones.RegionOf(center + RidgeZones::Margin + 1), 0);
  }
}

//------------------------------------------------------------------------------
// Faint from x = -0.5 to 0.5: chance, unless one point of it is significant.
TEST_F(RidgeZonesOnGrid, FaintPlacesCountWithSignificantOnesAmongThem)
{
  for (Id p = 0; p < Mesh.NumberOfPoints(); ++p)
  {
    Verdicts[p] = std::abs(At(p).x()) < 0.5 ? Verdict::Faint : Verdict::Insignificant;
  }
  const RidgeZones whole = Zones();
  ASSERT_EQ(whole.Regions().size(), 1u);
  EXPECT_EQ(static_cast<Id>(whole.Regions()[0].size()), Mesh.NumberOfPoints());

  Verdicts[840] = Verdict::Significant;
  const RidgeZones zones = Zones();
  for (Id p = 0; p < Mesh.NumberOfPoints(); ++p)
  {
    if (std::abs(At(p).x()) < 0.5)
    {
      EXPECT_EQ(zones.RegionOf(p), -1);
    }
  }
}

//------------------------------------------------------------------------------
// A strip parts the grid: 30 % at its left, 55 % at its right.
TEST_F(RidgeZonesOnGrid, ZonesNeedPointsAndAShareOfTheMesh)
{
  const auto setStrip = [this](double x)
  {
    for (Id p = 0; p < Mesh.NumberOfPoints(); ++p)
    {
      Verdicts[p] = std::abs(At(p).x() - x) < 0.03 ? Verdict::Significant : Verdict::Insignificant;
    }
  };
  setStrip(-0.15);
  EXPECT_EQ(Zones().Regions().size(), 2u);
  setStrip(-0.5);
  EXPECT_EQ(Zones().Regions().size(), 1u);
  // What is round-off does not need them.
  for (Id p = 0; p < Mesh.NumberOfPoints(); ++p)
  {
    Verdicts[p] = At(p).x() < -0.6 ? Verdict::RoundOff : Verdicts[p];
  }
  const RidgeZones zones = Zones();
  ASSERT_EQ(zones.Regions().size(), 2u);
  EXPECT_NE(zones.IsRoundOff(0), zones.IsRoundOff(1));
}

//------------------------------------------------------------------------------
TEST_F(RidgeZonesOnGrid, UnknownPointsAreNoEvidence)
{
  std::fill(Verdicts.begin(), Verdicts.end(), Verdict::Unknown);
  Verdicts.back() = Verdict::Significant;
  EXPECT_TRUE(Zones().Regions().empty());
  std::fill_n(Verdicts.begin(), RidgeZones::LeastPoints, Verdict::Insignificant);
  EXPECT_EQ(Zones().Regions().size(), 1u);
}

//------------------------------------------------------------------------------
// As where all fits are ill conditioned.
TEST_F(RidgeZonesOnGrid, MeshWithoutAnythingSignificantIsAZone)
{
  std::fill(Verdicts.begin(), Verdicts.end(), Verdict::Unknown);
  EXPECT_EQ(Zones().Regions().size(), 1u);
  std::fill(Verdicts.end() - RidgeZones::LeastUnresolved, Verdicts.end(), Verdict::Unresolved);
  EXPECT_TRUE(Zones().Regions().empty());
}

//------------------------------------------------------------------------------
TEST(RidgeZones, SmallMeshesAreZonesAsAWhole)
{
  const MeshedSurface surface(GraphPatch([](double, double) { return 0.0; }, 1.0, 8));
  const auto count = static_cast<std::size_t>(surface.Triangles().NumberOfPoints());
  ASSERT_LT(count, RidgeZones::LeastPoints);
  std::vector<Verdict> verdicts(count, Verdict::Unknown);
  std::fill_n(verdicts.begin(), RidgeZones::LeastPointsOfWhole - 1, Verdict::Insignificant);
  EXPECT_TRUE(ZonesOf(surface.Triangles(), verdicts).Regions().empty());
  std::fill_n(verdicts.begin(), RidgeZones::LeastPointsOfWhole, Verdict::Insignificant);
  EXPECT_EQ(ZonesOf(surface.Triangles(), verdicts).Regions().size(), 1u);
}

//------------------------------------------------------------------------------
// Three ridges in a row through two umbilics: what is outside keeps all of them.
TEST_F(RidgeZonesOnGrid, UmbilicsKeepAllRidgesOfAColorOrNone)
{
  for (Id p = 0; p < Mesh.NumberOfPoints(); ++p)
  {
    Verdicts[p] = At(p).x() > 0.6 ? Verdict::Significant : Verdict::Insignificant;
  }
  const RidgeZones zones = Zones();
  ASSERT_EQ(zones.Regions().size(), 1u);
  std::vector<Id> inside;
  std::vector<Id> outside;
  for (Id e = 0; e < Mesh.NumberOfEdges(); ++e)
  {
    const double x = At(Mesh.EdgeAt(e).v0).x();
    (x < 0.0 ? inside : outside).push_back(e);
  }
  const Id first = Ridge::AtUmbilic(Mesh.EdgeAt(inside[100]).t0);
  const Id second = Ridge::AtUmbilic(Mesh.EdgeAt(inside[500]).t0);
  const auto ridge = [](std::vector<Id> nodes)
  {
    Ridge made;
    made.nodes = std::move(nodes);
    return made;
  };
  std::vector<Ridge> ridges = { ridge({ inside[0], first }), ridge({ first, inside[1], second }),
    ridge({ inside[2], inside[3] }), ridge({ second, inside[4], inside[5] }) };
  EXPECT_EQ(RidgesInZones(zones, Mesh, ridges, {}, {}), std::vector<std::uint8_t>(4, 1));
  ridges[3].nodes.push_back(outside.back());
  EXPECT_EQ(RidgesInZones(zones, Mesh, ridges, {}, {}), (std::vector<std::uint8_t>{ 0, 0, 1, 0 }));
}

//------------------------------------------------------------------------------
TEST_F(RidgeZonesOnGrid, SampleHasPointsDeepInsideOnly)
{
  const RidgeZones zones = Zones();
  const auto isDeep = [this](Id p) { return At(p).lpNorm<Eigen::Infinity>() < 0.8; };
  const std::vector<Id> sample = SampleOf(Mesh, zones.Regions()[0], isDeep);
  EXPECT_GE(sample.size(), 8u);
  EXPECT_TRUE(std::all_of(sample.begin(), sample.end(), isDeep));
  EXPECT_EQ(std::set<Id>(sample.begin(), sample.end()).size(), sample.size());
}
