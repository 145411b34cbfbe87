// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RidgePaths.h"

#include "FilterTestTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace testing
{
namespace
{

EdgePath CanonicalPath(EdgePath path, bool loop)
{
  if (loop)
  {
    path.pop_back();
    std::rotate(path.begin(), std::min_element(path.begin(), path.end()), path.end());
  }
  EdgePath reversed(path.rbegin(), path.rend());
  if (loop)
  {
    std::rotate(reversed.begin(), reversed.end() - 1, reversed.end());
  }
  return std::min(path, reversed);
}

} // namespace

RidgeMap RidgesByPath(vtkPolyData* ridges, const std::function<vtkIdType(vtkIdType)>& pointName)
{
  RidgeMap map;
  vtkCellData* data = ridges->GetCellData();
  for (vtkIdType line = 0; line < ridges->GetNumberOfLines(); ++line)
  {
    vtkNew<vtkIdList> ids;
    ridges->GetLines()->GetCellAtId(line, ids);
    EdgePath path;
    for (const vtkIdType id : *ids)
    {
      auto p = static_cast<vtkIdType>(Value(ridges->GetPointData(), "EdgePoint0", id));
      auto q = static_cast<vtkIdType>(Value(ridges->GetPointData(), "EdgePoint1", id));
      if (pointName && p >= 0)
      {
        p = pointName(p);
        q = pointName(q);
      }
      path.emplace_back(std::min(p, q), std::max(p, q));
    }
    PolylineValues values;
    values.type = static_cast<int>(Value(data, "RidgeType", line));
    values.crest = static_cast<int>(Value(data, "Crest", line));
    values.closed = static_cast<int>(Value(data, "Closed", line));
    values.length = Value(data, "Length", line);
    values.strength = Value(data, "Strength", line);
    values.sharpness = Value(data, "Sharpness", line);
    const bool loop = *ids->begin() == *(ids->end() - 1) && path.front().first >= 0;
    EXPECT_TRUE(map.emplace(CanonicalPath(path, loop), values).second) << "the same path twice";
  }
  return map;
}

void ExpectSameRidges(
  const RidgeMap& expected, const RidgeMap& actual, double tolerance, double scale)
{
  ASSERT_EQ(expected.size(), actual.size());
  const auto near = [tolerance](double a, double b)
  { return std::abs(a - b) <= tolerance * (std::abs(a) + std::abs(b)); };
  for (const auto& [path, values] : expected)
  {
    const auto found = actual.find(path);
    ASSERT_NE(found, actual.end()) << "a polyline of " << path.size() << " points is missing";
    EXPECT_EQ(values.type, found->second.type);
    EXPECT_EQ(values.crest, found->second.crest);
    EXPECT_EQ(values.closed, found->second.closed);
    EXPECT_PRED2(near, values.length, found->second.length / scale);
    EXPECT_PRED2(near, values.strength, found->second.strength);
    EXPECT_PRED2(near, values.sharpness, found->second.sharpness);
  }
}

} // namespace testing
} // namespace ridges
