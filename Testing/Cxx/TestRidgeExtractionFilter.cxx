// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays, properties and measures of vtkRidgeExtraction.

#include "AnalyticSurface.h"
#include "EllipsoidRidges.h"
#include "FilterTestTools.h"
#include "MessageRecorder.h"
#include "RidgePaths.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

bool IsElliptic(double type)
{
  return type == vtkRidgeExtraction::MAXIMUM_ELLIPTIC ||
    type == vtkRidgeExtraction::MINIMUM_ELLIPTIC;
}

/// The output of an extraction from `marked` with properties set, with all ridges, and types as P
/// says.
template <typename SetUp>
vtkSmartPointer<vtkPolyData> Extract(vtkPolyData* marked, SetUp setUp)
{
  vtkNew<vtkRidgeExtraction> extraction;
  extraction->SetInputData(marked);
  extraction->SetTypeSignificance(0.0);
  extraction->SetLoopSignificance(0.0);
  extraction->SetZoneSignificance(0.0);
  setUp(extraction.GetPointer());
  extraction->Update();
  return extraction->GetOutput();
}

} // namespace

TEST(RidgeExtractionFilter, OutputsTheDocumentedArrays)
{
  const Outputs outputs = RunFilters(BlendData(32));
  vtkPolyData* ridges = outputs.ridges;
  const vtkIdType lines = ridges->GetNumberOfLines();
  const vtkIdType points = ridges->GetNumberOfPoints();
  ASSERT_GT(lines, 0);
  EXPECT_EQ(ridges->GetNumberOfCells(), lines);
  EXPECT_EQ(ridges->GetPoints()->GetDataType(), VTK_DOUBLE);
  vtkCellData* cells = ridges->GetCellData();
  EXPECT_EQ(cells->GetNumberOfArrays(), 9);
  ExpectArray(cells, names::RidgeType, VTK_INT, 1, lines);
  ExpectArray(cells, names::Crest, VTK_INT, 1, lines);
  ExpectArray(cells, names::Sharpness, VTK_DOUBLE, 1, lines);
  ExpectArray(cells, names::NearBorder, VTK_INT, 1, lines);
  ExpectArray(cells, names::Confidence, VTK_DOUBLE, 1, lines);
  ExpectArray(cells, names::Strength, VTK_DOUBLE, 1, lines);
  ExpectArray(cells, names::Length, VTK_DOUBLE, 1, lines);
  ExpectArray(cells, names::RidgeId, VTK_ID_TYPE, 1, lines);
  ExpectArray(cells, names::Closed, VTK_INT, 1, lines);
  vtkPointData* data = ridges->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), 7);
  ExpectArray(data, names::Curvature, VTK_DOUBLE, 1, points);
  ExpectArray(data, names::SecondDerivative, VTK_DOUBLE, 1, points);
  ExpectArray(data, names::Umbilic, VTK_ID_TYPE, 1, points);
  ExpectArray(data, names::TurningPoint, VTK_INT, 1, points);
  ExpectArray(data, names::EdgePoint0, VTK_ID_TYPE, 1, points);
  ExpectArray(data, names::EdgePoint1, VTK_ID_TYPE, 1, points);
  ExpectArray(data, names::EdgeParameter, VTK_DOUBLE, 1, points);
  ExpectAllFinite(ridges);

  const double umbilics = static_cast<double>(outputs.umbilics->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points; ++i)
  {
    EXPECT_LT(Value(data, names::Umbilic, i), umbilics);
    EXPECT_GE(Value(data, names::Umbilic, i), -1.0);
    if (Value(data, names::EdgePoint0, i) >= 0.0)
    {
      EXPECT_EQ(Value(data, names::Umbilic, i), -1.0) << "only an end in a triangle is an umbilic";
    }
  }
  for (vtkIdType i = 0; i < lines; ++i)
  {
    const double type = Value(cells, names::RidgeType, i);
    EXPECT_TRUE(type >= 1.0 && type <= 4.0);
    EXPECT_TRUE(Value(cells, names::Crest, i) == 0.0 || IsElliptic(type));
    EXPECT_GE(Value(cells, names::Sharpness, i), 0.0);
    EXPECT_GT(Value(cells, names::Strength, i), 0.0);
    EXPECT_GT(Value(cells, names::Length, i), 0.0);
  }
}

// A ridge point lies on a straight edge of length h = 0.02: in the surface's curvature that is an
// error of h^2 times second derivatives of some tens, and k'' is a second derivative of the fit,
// which is right to a few per cent.
TEST(RidgeExtractionFilter, PointsCarryTheCurvatureOfTheirColorAndItsSecondDerivative)
{
  const AnalyticSurface surface = MakeEllipsoid(1.4, 1.0, 0.6);
  const Outputs outputs = RunFilters(EllipsoidData(63));
  vtkPointData* data = outputs.ridges->GetPointData();
  vtkNew<vtkIdList> ids;
  int compared = 0;
  for (vtkIdType line = 0; line < outputs.ridges->GetNumberOfLines(); ++line)
  {
    const bool blue = Value(outputs.ridges->GetCellData(), names::RidgeType, line) <= 2.0;
    outputs.ridges->GetLines()->GetCellAtId(line, ids);
    for (const vtkIdType id : *ids)
    {
      const ExactMonge exact = surface.Monge(surface.Project(PointAt(outputs.ridges, id)));
      if (Value(data, names::EdgePoint0, id) < 0.0)
      {
        EXPECT_EQ(Value(data, names::SecondDerivative, id), 0.0);
      }
      else if (exact.k1 - exact.k2 > 0.2)
      {
        const double derivative =
          blue ? exact.P1 / (exact.k1 - exact.k2) : exact.P2 / (exact.k2 - exact.k1);
        const double curvature = blue ? exact.k1 : exact.k2;
        EXPECT_NEAR(Value(data, names::Curvature, id), curvature, 0.005 * std::abs(curvature));
        EXPECT_NEAR(Value(data, names::SecondDerivative, id), derivative,
          0.05 * (1.0 + std::abs(derivative)));
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

// The polylines of each type on each plane of symmetry; 2% as the mesh of 40,000 points has edges
// of 0.018, over which the integrands, smooth outside the cut-off, change by a few per cent.
TEST(RidgeExtractionFilter, MeasuresOfTheEllipsoidAreRight)
{
  const Outputs outputs = RunFilters(EllipsoidData(63));
  vtkCellData* cells = outputs.ridges->GetCellData();
  struct Found
  {
    double length, strength, sharpness;
  };
  std::map<std::pair<int, int>, std::vector<Found>> found;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < outputs.ridges->GetNumberOfLines(); ++line)
  {
    outputs.ridges->GetLines()->GetCellAtId(line, ids);
    Eigen::Vector3d extent = Eigen::Vector3d::Zero();
    for (const vtkIdType id : *ids)
    {
      extent = extent.cwiseMax(PointAt(outputs.ridges, id).cwiseAbs());
    }
    int plane = 0;
    EXPECT_LT(extent.minCoeff(&plane), 0.01);
    found[{ static_cast<int>(Value(cells, names::RidgeType, line)), plane }].push_back(
      { Value(cells, names::Length, line), Value(cells, names::Strength, line),
        Value(cells, names::Sharpness, line) });
  }
  const auto pieces = EllipsoidRidgeIntegrals(1.4, 1.0, 0.6, 0.01);
  EXPECT_EQ(outputs.ridges->GetNumberOfLines(), static_cast<vtkIdType>(pieces.size()));
  EXPECT_EQ(pieces.size(), 6u);
  for (const EllipsoidRidgePiece& piece : pieces)
  {
    auto& candidates = found[{ piece.type, piece.plane }];
    const auto nearest = std::min_element(candidates.begin(), candidates.end(),
      [&](const Found& p, const Found& q)
      { return std::abs(p.length - piece.length) < std::abs(q.length - piece.length); });
    ASSERT_NE(nearest, candidates.end()) << "type " << piece.type << " plane " << piece.plane;
    EXPECT_NEAR(nearest->length, piece.length, 0.02 * piece.length);
    EXPECT_NEAR(nearest->strength, piece.strength, 0.02 * piece.strength);
    EXPECT_NEAR(nearest->sharpness, piece.sharpness, 0.02 * piece.sharpness) << piece.type;
    candidates.erase(nearest);
  }
}

TEST(RidgeExtractionFilter, ColorsAreExtractedApart)
{
  const Outputs outputs = RunFilters(BlendData(16));
  const RidgeMap all = RidgesByPath(outputs.ridges);
  const auto blue =
    Extract(outputs.marked, [](vtkRidgeExtraction* filter) { filter->ExtractMinimumOff(); });
  const auto red =
    Extract(outputs.marked, [](vtkRidgeExtraction* filter) { filter->ExtractMaximumOff(); });
  const auto none = Extract(outputs.marked,
    [](vtkRidgeExtraction* filter)
    {
      filter->ExtractMaximumOff();
      filter->ExtractMinimumOff();
    });
  RidgeMap expectedBlue;
  RidgeMap expectedRed;
  for (const auto& entry : all)
  {
    (entry.second.type <= 2 ? expectedBlue : expectedRed).insert(entry);
  }
  EXPECT_FALSE(expectedBlue.empty());
  EXPECT_FALSE(expectedRed.empty());
  ExpectSameRidges(expectedBlue, RidgesByPath(blue), 0.0);
  ExpectSameRidges(expectedRed, RidgesByPath(red), 0.0);
  EXPECT_TRUE(IsEmpty(none));
}

TEST(RidgeExtractionFilter, CrestOnlyKeepsExactlyTheCrestLines)
{
  const Outputs outputs = RunFilters(BlendData(32));
  RidgeMap expected = RidgesByPath(outputs.ridges);
  const std::size_t all = expected.size();
  for (auto entry = expected.begin(); entry != expected.end();)
  {
    entry = entry->second.crest ? std::next(entry) : expected.erase(entry);
  }
  ASSERT_GT(expected.size(), 0u);
  ASSERT_LT(expected.size(), all);
  const auto crests =
    Extract(outputs.marked, [](vtkRidgeExtraction* filter) { filter->CrestOnlyOn(); });
  ExpectSameRidges(expected, RidgesByPath(crests), 0.0);
  std::set<vtkIdType> used;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < crests->GetNumberOfLines(); ++line)
  {
    crests->GetLines()->GetCellAtId(line, ids);
    used.insert(ids->begin(), ids->end());
  }
  EXPECT_EQ(static_cast<vtkIdType>(used.size()), crests->GetNumberOfPoints());
}

TEST(RidgeExtractionFilter, TurningPointsAreWhereTheTypeChanges)
{
  const Outputs outputs = RunFilters(BlendData(32));
  vtkCellData* cells = outputs.ridges->GetCellData();
  std::map<vtkIdType, std::vector<std::pair<double, double>>> ends; // ridge and type, by point
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < outputs.ridges->GetNumberOfLines(); ++line)
  {
    outputs.ridges->GetLines()->GetCellAtId(line, ids);
    for (const vtkIdType end : { *ids->begin(), *(ids->end() - 1) })
    {
      ends[end].emplace_back(
        Value(cells, names::RidgeId, line), Value(cells, names::RidgeType, line));
    }
  }
  int turning = 0;
  for (vtkIdType i = 0; i < outputs.ridges->GetNumberOfPoints(); ++i)
  {
    const auto at = ends.find(i);
    const bool isUmbilic = Value(outputs.ridges->GetPointData(), names::Umbilic, i) >= 0.0;
    const bool turns = !isUmbilic && at != ends.end() && at->second.size() == 2 &&
      at->second[0].second != at->second[1].second;
    EXPECT_EQ(Value(outputs.ridges->GetPointData(), names::TurningPoint, i), turns ? 1.0 : 0.0);
    turning += turns ? 1 : 0;
  }
  EXPECT_GT(turning, 0);
}
