// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/TestFields.h"

#include "Ridges/ExtremalityErrors.h"
#include "Ridges/ExtremalityProbe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{

using namespace ridges;
using namespace ridges::testing;
using Verdict = ExtremalityErrors::Verdict;

/// A flat grid of which all is set by hand, with fits of two rings.
struct SetByHand
{
  SetByHand()
    : surface(GraphPatch([](double, double) { return 0.0; }, 1.0, 20))
    , field(surface.Triangles().NumberOfPoints())
    , residual(field.k1.size(), 1e-4)
    , scale(field.k1.size(), 0.3)
    , gain(field.k1.size(), 50.0)
    , isFlagged(field.k1.size(), 0)
  {
    for (std::size_t p = 0; p < this->field.k1.size(); ++p)
    {
      MongeForm form;
      form.d1 = Eigen::Vector3d::UnitX();
      form.d2 = Eigen::Vector3d::UnitY();
      form.n = Eigen::Vector3d::UnitZ();
      this->field.Set(static_cast<Id>(p), form);
    }
  }

  ExtremalityErrors Errors(Color color = Color::Blue)
  {
    this->source.fitResidual = this->residual.data();
    this->source.fitScale = this->scale.data();
    this->source.noiseGain = this->gain.data();
    this->view = this->field.View();
    return ExtremalityErrors(
      { this->surface.Triangles(), this->view, this->source, this->isFlagged }, color, 3.0);
  }

  std::vector<Verdict> Verdicts(Color color = Color::Blue)
  {
    ExtremalityErrors errors = this->Errors(color);
    const Id count = this->surface.Triangles().NumberOfPoints();
    errors.Begin();
    errors.Measure(0, count);
    errors.Sum(0, count);
    errors.Judge(0, count);
    return errors.Verdicts();
  }

  /// k1 rises along x, and b0 is what it rises by.
  void SetSlope(double slope)
  {
    for (std::size_t p = 0; p < this->field.k1.size(); ++p)
    {
      this->field.k1[p] = 0.1 + slope * this->surface.Triangles().Point(static_cast<Id>(p)).x();
      this->field.b[4 * p] = slope;
    }
  }

  MeshedSurface surface;
  FieldArrays field;
  std::vector<double> residual;
  std::vector<double> scale;
  std::vector<double> gain;
  std::vector<std::uint8_t> isFlagged;
  FitErrorSource source;
  MongeField view;
};

constexpr Id Center = 220; // of 21 by 21 points

} // namespace

//------------------------------------------------------------------------------
TEST(ExtremalityErrors, ZeroIsRoundOff)
{
  SetByHand mesh;
  const std::vector<Verdict> verdicts = mesh.Verdicts();
  EXPECT_TRUE(std::all_of(verdicts.begin(), verdicts.end(),
    [](Verdict verdict) { return verdict == Verdict::RoundOff; }));
}

//------------------------------------------------------------------------------
TEST(ExtremalityErrors, NoiseDecidesByFitResiduals)
{
  // Noise makes an error of 50 * 1e-4 / 0.3^2 = 0.056.
  SetByHand mesh;
  mesh.SetSlope(0.5);
  EXPECT_EQ(mesh.Verdicts()[Center], Verdict::Significant);
  EXPECT_EQ(mesh.Errors().VerdictAt(Center), Verdict::Significant);
  mesh.SetSlope(0.1);
  EXPECT_EQ(mesh.Verdicts()[Center], Verdict::Insignificant);
  EXPECT_NE(mesh.Errors().VerdictAt(Center), Verdict::Significant);
  // 3.6 and 6.3 standard errors.
  mesh.SetSlope(0.2);
  EXPECT_EQ(mesh.Verdicts()[Center], Verdict::Faint);
  EXPECT_EQ(mesh.Errors().VerdictAt(Center), Verdict::Faint);
  mesh.SetSlope(0.35);
  EXPECT_EQ(mesh.Verdicts()[Center], Verdict::Significant);
  // The other colour has nothing.
  EXPECT_EQ(mesh.Verdicts(Color::Red)[Center], Verdict::RoundOff);
}

//------------------------------------------------------------------------------
TEST(ExtremalityErrors, WhatCurvaturesDoNotConfirmIsInsignificant)
{
  SetByHand mesh;
  mesh.SetSlope(0.5);
  std::fill(mesh.field.k1.begin(), mesh.field.k1.end(), 0.1);
  EXPECT_EQ(mesh.Verdicts()[Center], Verdict::Insignificant);
}

//------------------------------------------------------------------------------
TEST(ExtremalityErrors, FlaggedFitsAndTheirNeighborsAreUnknown)
{
  SetByHand mesh;
  mesh.SetSlope(0.5);
  mesh.isFlagged[Center] = ExtremalityErrors::FlaggedAsInexact;
  const std::vector<Verdict> verdicts = mesh.Verdicts();
  EXPECT_EQ(verdicts[Center], Verdict::Unknown);
  EXPECT_EQ(verdicts[Center + 1], Verdict::Unknown);
  EXPECT_EQ(verdicts[Center + 4], Verdict::Significant);
  mesh.isFlagged[Center] = ExtremalityErrors::FlaggedAsWrong;
  EXPECT_EQ(mesh.Verdicts()[Center], Verdict::Unresolved);
  EXPECT_EQ(mesh.Verdicts()[Center + 1], Verdict::Unknown);
}

//------------------------------------------------------------------------------
TEST(ExtremalityErrors, RoughPointsThatTurnAreUnresolved)
{
  SetByHand mesh;
  mesh.SetSlope(0.1);
  mesh.field.k2[Center] = -5.0; // 1.5 within the radius
  EXPECT_EQ(mesh.Verdicts()[Center], Verdict::Insignificant);
  mesh.residual[Center] = 0.02;
  EXPECT_EQ(mesh.Verdicts()[Center], Verdict::Unresolved);
}

//------------------------------------------------------------------------------
TEST(ExtremalityErrors, WithoutFitsOnlyRoundingCounts)
{
  SetByHand mesh;
  mesh.SetSlope(1e-6);
  std::fill(mesh.field.k1.begin(), mesh.field.k1.end(), 0.1);
  const MongeField view = mesh.field.View();
  const FitErrorSource none;
  ExtremalityErrors errors(
    { mesh.surface.Triangles(), view, none, mesh.isFlagged }, Color::Blue, 3.0);
  EXPECT_EQ(errors.VerdictAt(Center), Verdict::Significant);
}

//------------------------------------------------------------------------------
// At 1 % of an edge noise hides b on two rings, but not on seven, where an ellipsoid has it and a
// sphere has not.
TEST(ExtremalityProbe, FindsRidgesThatNoiseHidesOnTheSmallScale)
{
  const auto countSignificant = [](const Mesh& mesh)
  {
    const MeshedSurface surface(AddNormalNoise(mesh, 0.01 * MeanEdgeLength(mesh), 5));
    const OrderedRings rings = RingsOf(surface.Triangles());
    ExtremalityProbe probe(surface.Triangles(), rings);
    int count = 0;
    for (Id p = 0; p < surface.Triangles().NumberOfPoints(); p += 30)
    {
      const ExtremalityProbe::Trial blue = probe.Try(p, 7, Color::Blue, 3.0);
      const ExtremalityProbe::Trial red = probe.Try(p, 7, Color::Red, 3.0);
      EXPECT_TRUE(blue.isUsable && red.isUsable);
      count += blue.isSignificant || red.isSignificant ? 1 : 0;
    }
    return count;
  };
  EXPECT_GT(countSignificant(EllipsoidMesh(20, 1.2, 1.0, 0.8)), 20); // of 134
  EXPECT_LE(countSignificant(Icosphere(20)), 2);
}
