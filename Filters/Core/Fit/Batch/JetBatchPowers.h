// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Powers of the coordinates of some points. Included by JetBatchPowerSums.h only.
#ifndef ridges_JetBatchPowers_h
#define ridges_JetBatchPowers_h

#include "Fit/Batch/JetBatchMoments.h"

namespace
{

constexpr int Tile = 3;

/// Filled up to whole tiles.
constexpr int Padded(int size)
{
  return (size + Tile - 1) / Tile * Tile;
}

/// The powers of u of some rows, and of v times a value.
template <int Order>
struct Powers
{
  static constexpr int Size = Padded(Order + 1);
  static constexpr int RowsAtOnce =
    75 / Size; ///< So few that they stay in the first level of the cache.

  Vec ofU[RowsAtOnce][Size];
  Vec ofV[RowsAtOnce][Size];

  inline void Set(int row, const Vec3& point, const Vec& value)
  {
    Vec powerOfU = Broadcast(1.0);
    Vec powerOfV = value;
    for (int k = 0; k < Size; ++k)
    {
      this->ofU[row][k] = powerOfU;
      this->ofV[row][k] = powerOfV;
      powerOfU *= point.x;
      powerOfV *= point.y;
    }
  }
};

/// Calls visit(first, count) for all rows, as many at once as their powers are kept of.
template <int Order, typename Visit>
inline void ForRows(const LocalPoints& points, Visit visit)
{
  constexpr int rowsAtOnce = Powers<Order>::RowsAtOnce;
  for (int first = 0; first < points.rows; first += rowsAtOnce)
  {
    const int rest = points.rows - first;
    visit(first, rest < rowsAtOnce ? rest : rowsAtOnce);
  }
}

} // namespace

#endif
