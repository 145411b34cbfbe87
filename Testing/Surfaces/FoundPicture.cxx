// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FoundPicture.h"

#include <algorithm>

namespace ridges
{
namespace testing
{

//------------------------------------------------------------------------------
bool FoundRidge::IsMaximum() const
{
  return std::any_of(this->lines.begin(), this->lines.end(),
    [](const FoundLine& line) { return line.type == 1 || line.type == 2; });
}

//------------------------------------------------------------------------------
double LengthOf(const std::vector<Eigen::Vector3d>& points)
{
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += (points[i] - points[i - 1]).norm();
  }
  return length;
}

//------------------------------------------------------------------------------
double LengthOf(const FoundRidge& ridge)
{
  double length = 0.0;
  for (const FoundLine& line : ridge.lines)
  {
    length += LengthOf(line.points);
  }
  return length;
}

} // namespace testing
} // namespace ridges
