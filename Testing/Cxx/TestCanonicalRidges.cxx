// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Ridges and umbilics come in an order, and ridges in a sense, that depend on positions alone: the
// same bytes with any number of threads and any numbering, but for the ids themselves.

#include "FilterTestTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

Mesh NoisyBlend()
{
  const Mesh mesh = ToMesh(BlendData(32));
  return AddNormalNoise(mesh, 0.03 * MeanEdgeLength(mesh), 3);
}

/// Equal but for round-off where umbilics are concerned, whose place is found by elimination from
/// the corners of their triangle, one after another.
bool IsNear(double a, double b)
{
  return a == b || std::abs(a - b) <= 1e-9 * (std::abs(a) + std::abs(b));
}

bool HaveSameValues(vtkDataArray* a, vtkDataArray* b)
{
  if (!a || !b || a->GetNumberOfTuples() != b->GetNumberOfTuples() ||
    a->GetNumberOfComponents() != b->GetNumberOfComponents())
  {
    return false;
  }
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    for (int j = 0; j < a->GetNumberOfComponents(); ++j)
    {
      if (!IsNear(a->GetComponent(i, j), b->GetComponent(i, j)))
      {
        return false;
      }
    }
  }
  return true;
}

/// All arrays of the points or cells but those that are left out.
void ExpectSameArrays(
  vtkDataSetAttributes* expected, vtkDataSetAttributes* actual, const std::vector<std::string>& but)
{
  ASSERT_EQ(expected->GetNumberOfArrays(), actual->GetNumberOfArrays());
  for (int i = 0; i < expected->GetNumberOfArrays(); ++i)
  {
    const std::string name = expected->GetArrayName(i);
    if (std::find(but.begin(), but.end(), name) == but.end())
    {
      EXPECT_TRUE(HaveSameValues(expected->GetArray(i), actual->GetArray(name.c_str()))) << name;
    }
  }
}

void ExpectSameEdges(
  vtkPolyData* expected, vtkPolyData* actual, const std::vector<std::int32_t>& newToOld)
{
  for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
  {
    const auto at = [i](vtkPolyData* ridges, const char* name)
    { return Value(ridges->GetPointData(), name, i); };
    const auto v0 = static_cast<vtkIdType>(at(expected, names::EdgePoint0));
    const auto v1 = static_cast<vtkIdType>(at(expected, names::EdgePoint1));
    const auto w0 = static_cast<vtkIdType>(at(actual, names::EdgePoint0));
    const auto w1 = static_cast<vtkIdType>(at(actual, names::EdgePoint1));
    if (v0 < 0 || w0 < 0)
    {
      ASSERT_EQ(v0, w0);
      ASSERT_EQ(v1, w1);
      continue;
    }
    const bool swaps = newToOld[w0] != v0;
    ASSERT_EQ(newToOld[swaps ? w1 : w0], v0);
    ASSERT_EQ(newToOld[swaps ? w0 : w1], v1);
    const double t = at(actual, names::EdgeParameter);
    // Round-off of the difference from 1, once or twice.
    ASSERT_NEAR(swaps ? 1.0 - t : t, at(expected, names::EdgeParameter), 3e-16);
    ASSERT_EQ(PointAt(actual, i), PointAt(expected, i));
  }
}

void ExpectSameAfterRenumbering(const Mesh& mesh)
{
  const Outputs expected = RunFilters(ToPolyData(mesh));
  ASSERT_GT(expected.ridges->GetNumberOfLines(), 10);
  for (const std::uint64_t seed : { 1u, 2u })
  {
    std::vector<std::int32_t> newToOld;
    const Outputs actual = RunFilters(ToPolyData(Permute(mesh, seed, &newToOld)));

    ASSERT_TRUE(HaveSameValues(
      expected.umbilics->GetPoints()->GetData(), actual.umbilics->GetPoints()->GetData()));
    ExpectSameArrays(
      expected.umbilics->GetPointData(), actual.umbilics->GetPointData(), { names::Triangle });

    ASSERT_TRUE(HaveSameValues(
      expected.ridges->GetPoints()->GetData(), actual.ridges->GetPoints()->GetData()));
    EXPECT_TRUE(HaveSameValues(expected.ridges->GetLines()->GetConnectivityArray(),
      actual.ridges->GetLines()->GetConnectivityArray()));
    EXPECT_TRUE(HaveSameValues(expected.ridges->GetLines()->GetOffsetsArray(),
      actual.ridges->GetLines()->GetOffsetsArray()));
    ExpectSameArrays(expected.ridges->GetPointData(), actual.ridges->GetPointData(),
      { names::EdgePoint0, names::EdgePoint1, names::EdgeParameter });
    ExpectSameArrays(
      expected.ridges->GetCellData(), actual.ridges->GetCellData(), { names::Sharpness });
    ExpectSameEdges(expected.ridges, actual.ridges, newToOld);
    for (const char* name : { names::NumberOfCancelledRegions, names::NumberOfUmbilicZones })
    {
      EXPECT_EQ(Value(expected.marked->GetFieldData(), name, 0),
        Value(actual.marked->GetFieldData(), name, 0));
    }
  }
}

} // namespace

TEST(CanonicalRidges, AreTheSameWithAnyNumberOfThreads)
{
  const auto mesh = ToPolyData(NoisyBlend());
  vtkSMPTools::Initialize(1);
  const Outputs one = RunFilters(mesh);
  vtkSMPTools::Initialize(2);
  const Outputs two = RunFilters(mesh);
  vtkSMPTools::Initialize(0);
  EXPECT_EQ(FirstDifference(one.marked, two.marked), "");
  EXPECT_EQ(FirstDifference(one.umbilics, two.umbilics), "");
  EXPECT_EQ(FirstDifference(one.ridges, two.ridges), "");
}

TEST(CanonicalRidges, AreTheSameWithAnyNumberingOfTheBlend)
{
  ExpectSameAfterRenumbering(ToMesh(BlendData(45)));
}

// Inside cancelled regions what is drawn is not.
TEST(CanonicalRidges, AreTheSameWithAnyNumberingOfANoisyMesh)
{
  ExpectSameAfterRenumbering(NoisyBlend());
}
