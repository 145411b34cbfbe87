// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Sums of monomials of any degree, in tiles of 3 x 3 elements that stay in registers. Included by
// JetBatchTiledSums.h only.
#ifndef ridges_JetBatchPowerSums_h
#define ridges_JetBatchPowerSums_h

#include "Fit/Batch/JetBatchPowers.h"

namespace
{

/// Sums of values times u^i v^j, by j and i; of i + j <= Order only.
template <int Order>
struct PowerSums
{
  static constexpr int Size = Padded(Order + 1);

  Vec at[Size][Size];

  inline void Clear()
  {
    for (int j = 0; j < Size; ++j)
    {
      for (int i = 0; i < Size; ++i)
      {
        this->at[j][i] = Vec{};
      }
    }
  }

  /// Over the rows, with value(row).
  template <typename Value>
  inline void Sum(const LocalPoints& points, Value value)
  {
    Powers<Order> powers;
    this->Clear();
    ForRows<Order>(points,
      [this, &points, &powers, &value](int first, int count)
      {
        for (int row = 0; row < count; ++row)
        {
          powers.Set(row, points.at[first + row], value(first + row));
        }
        this->Add(powers.ofU, powers.ofV, count);
      });
  }

  template <int SizeOfU, int SizeOfV>
  inline void Add(const Vec (*ofU)[SizeOfU], const Vec (*ofV)[SizeOfV], int count)
  {
    constexpr int last = Rest < 2 ? Last - Tile : Last;
    for (int j = 0; j <= last; j += Tile)
    {
      for (int i = 0; i + j <= last; i += Tile)
      {
        if (i + j < last || Rest < 2)
        {
          this->template AddTile<2 * (Tile - 1)>(ofU, ofV, count, i, j);
        }
        else
        {
          this->template AddTile<Rest>(ofU, ofV, count, i, j);
        }
      }
    }
    if constexpr (Rest < 2)
    {
      constexpr int tiles = Last / Tile + 1;
      constexpr int half = Rest == 0 ? tiles : tiles / 2;
      this->template AddCorners<half>(ofU, ofV, count, 0);
      if constexpr (half < tiles)
      {
        this->template AddCorners<tiles - half>(ofU, ofV, count, half * Tile);
      }
    }
  }

private:
  // The last tiles have i + j = Last at their first element, and only i + j <= Last + Rest counts.
  static constexpr int Rest = Order % Tile;
  static constexpr int Last = Order - Rest;

  /// What counts of some of the last tiles, if that is few elements.
  template <int Tiles, int SizeOfU, int SizeOfV>
  inline void AddCorners(
    const Vec (*ofU)[SizeOfU], const Vec (*ofV)[SizeOfV], int count, int firstI)
  {
    Vec sums[Tiles][Tile];
#pragma GCC unroll 6
    for (int tile = 0; tile < Tiles; ++tile)
    {
      const int i = firstI + tile * Tile;
      const int j = Last - i;
      sums[tile][0] = this->at[j][i];
      if (Rest > 0)
      {
        sums[tile][1] = this->at[j][i + 1];
        sums[tile][2] = this->at[j + 1][i];
      }
    }
    for (int row = 0; row < count; ++row)
    {
#pragma GCC unroll 6
      for (int tile = 0; tile < Tiles; ++tile)
      {
        const Vec* u = ofU[row] + firstI + tile * Tile;
        const Vec* v = ofV[row] + Last - firstI - tile * Tile;
        sums[tile][0] += v[0] * u[0];
        if (Rest > 0)
        {
          sums[tile][1] += v[0] * u[1];
          sums[tile][2] += v[1] * u[0];
        }
      }
    }
#pragma GCC unroll 6
    for (int tile = 0; tile < Tiles; ++tile)
    {
      const int i = firstI + tile * Tile;
      const int j = Last - i;
      this->at[j][i] = sums[tile][0];
      if (Rest > 0)
      {
        this->at[j][i + 1] = sums[tile][1];
        this->at[j + 1][i] = sums[tile][2];
      }
    }
  }

  /// Of the elements of a tile, those with i + j <= Most.
  template <int Most, int SizeOfU, int SizeOfV>
  inline void AddTile(
    const Vec (*ofU)[SizeOfU], const Vec (*ofV)[SizeOfV], int count, int firstI, int firstJ)
  {
    Vec sums[Tile][Tile];
#pragma GCC unroll 3
    for (int j = 0; j < Tile; ++j)
    {
#pragma GCC unroll 3
      for (int i = 0; i < Tile; ++i)
      {
        sums[j][i] = this->at[firstJ + j][firstI + i];
      }
    }
    for (int row = 0; row < count; ++row)
    {
      const Vec* u = ofU[row] + firstI;
      const Vec* v = ofV[row] + firstJ;
#pragma GCC unroll 3
      for (int j = 0; j < Tile; ++j)
      {
#pragma GCC unroll 3
        for (int i = 0; i < Tile; ++i)
        {
          if (i + j <= Most)
          {
            sums[j][i] += v[j] * u[i];
          }
        }
      }
    }
#pragma GCC unroll 3
    for (int j = 0; j < Tile; ++j)
    {
#pragma GCC unroll 3
      for (int i = 0; i < Tile; ++i)
      {
        this->at[firstJ + j][firstI + i] = sums[j][i];
      }
    }
  }
};

} // namespace

#endif
