// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentGrid.h"

#include <algorithm>

namespace ridges
{
namespace testing
{

using Eigen::Vector3d;

SegmentGrid::Index SegmentGrid::CellOf(const Vector3d& point) const
{
  return (point / this->Reach).array().floor().cast<std::int64_t>();
}

std::int64_t SegmentGrid::KeyOf(const Index& cell)
{
  const std::int64_t size = 1 << 20;
  return ((cell[2] + size / 2) * size + cell[1] + size / 2) * size + cell[0] + size / 2;
}

void SegmentGrid::Add(const Vector3d& a, const Vector3d& b, int line, int segment)
{
  const Index low = this->CellOf(a.cwiseMin(b));
  const Index high = this->CellOf(a.cwiseMax(b));
  Index cell;
  for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
  {
    for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
    {
      for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
      {
        this->Cells[KeyOf(cell)].push_back(static_cast<int>(this->Entries.size()));
      }
    }
  }
  this->Entries.push_back({ a, b, line, segment });
}

SegmentGrid::Hit SegmentGrid::Nearest(const Vector3d& point) const
{
  Hit hit;
  const Index center = this->CellOf(point);
  for (int i = 0; i < 27; ++i)
  {
    const auto found = this->Cells.find(KeyOf(center + Index(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
    if (found == this->Cells.end())
    {
      continue;
    }
    for (const int e : found->second)
    {
      const Entry& entry = this->Entries[e];
      const Vector3d along = entry.b - entry.a;
      const double square = along.squaredNorm();
      const double t =
        square > 0.0 ? std::clamp((point - entry.a).dot(along) / square, 0.0, 1.0) : 0.0;
      const double distance = (entry.a + t * along - point).norm();
      if (distance < hit.distance && distance <= this->Reach)
      {
        hit = { distance, t, entry.line, entry.segment };
      }
    }
  }
  return hit;
}

} // namespace testing
} // namespace ridges
