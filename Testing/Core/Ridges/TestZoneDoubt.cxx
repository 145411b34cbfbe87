// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What is certain of zones from a part of the mesh, against the zones of the whole.

#include "Fixtures/TestFields.h"

#include "Ridges/RidgeZones.h"
#include "Ridges/ZoneDoubt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Verdict = ExtremalityErrors::Verdict;

class ZoneDoubtOnGrid : public ::testing::Test
{
protected:
  // 41 by 41 points, from -1 to 1.
  ZoneDoubtOnGrid()
    : Surface(GraphPatch([](double, double) { return 0.0; }, 1.0, 40))
    , Mesh(Surface.Triangles())
    , Verdicts(Mesh.NumberOfPoints(), Verdict::Unknown)
  {
  }

  void Set(Verdict verdict, double x, double y, double halfWidth)
  {
    for (Id p = 0; p < this->Mesh.NumberOfPoints(); ++p)
    {
      const double distance =
        std::max(std::abs(this->Mesh.Point(p).x() - x), std::abs(this->Mesh.Point(p).y() - y));
      this->Verdicts[p] = distance < halfWidth ? verdict : this->Verdicts[p];
    }
  }

  /// One that crosses an edge at the point of the grid next to a place.
  Ridge RidgeAt(double x, double y) const
  {
    const auto distance = [this, x, y](Id e)
    {
      const auto p = this->Mesh.Point(this->Mesh.EdgeAt(e).v0);
      return std::hypot(p.x() - x, p.y() - y);
    };
    Id nearest = 0;
    for (Id e = 0; e < this->Mesh.NumberOfEdges(); ++e)
    {
      nearest = distance(e) < distance(nearest) ? e : nearest;
    }
    Ridge ridge;
    ridge.nodes = { nearest };
    return ridge;
  }

  bool IsOutside(const Ridge& ridge) const
  {
    return ZoneDoubt(this->Mesh, [this](Id p) { return this->Verdicts[p]; }).IsOutside(ridge);
  }

  MeshedSurface Surface;
  const TriangleMesh& Mesh;
  std::vector<Verdict> Verdicts;
};

} // namespace

//------------------------------------------------------------------------------
TEST_F(ZoneDoubtOnGrid, IsOutsideNextToWhatIsSignificant)
{
  const double edge = 2.0 / 40;
  this->Set(Verdict::Insignificant, 0.0, 0.0, 2.0);
  this->Set(Verdict::Significant, 0.0, 0.0, 0.5 * edge);
  EXPECT_TRUE(this->IsOutside(this->RidgeAt(RidgeZones::Margin * edge, 0.0)));
  EXPECT_FALSE(this->IsOutside(this->RidgeAt((RidgeZones::Margin + 1) * edge, 0.0)));
}

//------------------------------------------------------------------------------
// These count by what they are connected to.
TEST_F(ZoneDoubtOnGrid, IsInDoubtNextToWhatIsFaintOrUnresolved)
{
  const double edge = 2.0 / 40;
  for (const Verdict other : { Verdict::Faint, Verdict::Unresolved })
  {
    this->Set(Verdict::Insignificant, 0.0, 0.0, 2.0);
    this->Set(other, 0.0, 0.0, 0.5 * edge);
    EXPECT_FALSE(this->IsOutside(this->RidgeAt(edge, 0.0)));
  }
}

//------------------------------------------------------------------------------
// A region that ends somewhere and has too few points is none; of a larger one, its share of the
// mesh decides.
TEST_F(ZoneDoubtOnGrid, IsOutsideInRegionsThatAreTooSmall)
{
  this->Set(Verdict::Significant, 0.0, 0.0, 2.0);
  this->Set(Verdict::Insignificant, 0.0, 0.0, 0.42); // 9 by 9 points beyond the margin
  EXPECT_TRUE(this->IsOutside(this->RidgeAt(0.0, 0.0)));
  this->Set(Verdict::Insignificant, 0.0, 0.0, 0.77); // 23 by 23
  EXPECT_FALSE(this->IsOutside(this->RidgeAt(0.0, 0.0)));
}

//------------------------------------------------------------------------------
TEST_F(ZoneDoubtOnGrid, IsInDoubtWhereAFewPointsAreRoundOff)
{
  this->Set(Verdict::Significant, 0.0, 0.0, 2.0);
  this->Set(Verdict::RoundOff, 0.0, 0.0, 0.42);
  EXPECT_FALSE(this->IsOutside(this->RidgeAt(0.0, 0.0)));
}

//------------------------------------------------------------------------------
// All of a connected part needs only a few points, or many of which nothing is known.
TEST_F(ZoneDoubtOnGrid, IsInDoubtOnAWholePart)
{
  EXPECT_FALSE(this->IsOutside(this->RidgeAt(0.0, 0.0)));
  this->Set(Verdict::Insignificant, 0.0, 0.0, 0.13); // 25 points
  EXPECT_FALSE(this->IsOutside(this->RidgeAt(0.0, 0.0)));
}

//------------------------------------------------------------------------------
TEST_F(ZoneDoubtOnGrid, IsInDoubtOfARidgeThatCrossesNothing)
{
  this->Set(Verdict::Significant, 0.0, 0.0, 2.0);
  Ridge ridge;
  ridge.nodes = { Ridge::AtUmbilic(3), Ridge::AtUmbilic(4) };
  EXPECT_FALSE(this->IsOutside(ridge));
}

//------------------------------------------------------------------------------
// Whatever the verdicts are, no ridge that is certainly outside is in a zone of the whole mesh.
TEST_F(ZoneDoubtOnGrid, IsNeverWrong)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  std::uniform_real_distribution<double> width(0.03, 0.5);
  int outside = 0;
  int inZones = 0;
  for (int i = 0; i < 90; ++i)
  {
    this->Set(i % 2 == 0 ? Verdict::Insignificant : Verdict::Unknown, 0.0, 0.0, 2.0);
    for (const Verdict verdict : { Verdict::Insignificant, Verdict::Unknown, Verdict::RoundOff,
           Verdict::Significant, Verdict::Unresolved, Verdict::Faint })
    {
      const double x = place(random);
      const double y = place(random);
      this->Set(verdict, x, y, width(random));
    }
    RidgeZones zones(this->Mesh);
    ASSERT_TRUE(zones.Find(this->Verdicts));
    for (int k = 0; k < 10; ++k)
    {
      const double x = place(random);
      const Ridge ridge = this->RidgeAt(x, place(random));
      const bool isIn = RidgesInZones(zones, this->Mesh, { ridge }, {}, {}).front() != 0;
      const bool isOutside = this->IsOutside(ridge);
      EXPECT_FALSE(isIn && isOutside) << i << ", " << k;
      outside += isOutside ? 1 : 0;
      inZones += isIn ? 1 : 0;
    }
  }
  EXPECT_GT(outside, 100);
  EXPECT_GT(inZones, 100);
}
