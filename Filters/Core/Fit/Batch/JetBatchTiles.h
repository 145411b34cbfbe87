// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Sums of monomials and normal equations of any degree, in tiles of 3 x 3 elements that stay in
// registers. Included by JetBatchTiledKernel.h only.
#ifndef ridges_JetBatchTiles_h
#define ridges_JetBatchTiles_h

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
        this->AddTile(ofU, ofV, count, i, j);
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

  template <int SizeOfU, int SizeOfV>
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
          sums[j][i] += v[j] * u[i];
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

/// The moments of the weights, and those of the heights times the weights.
template <int Degree>
inline void SumMoments(
  const LocalPoints& points, PowerSums<2 * Degree>& moments, PowerSums<Degree>& heights)
{
  constexpr int order = 2 * Degree;
  constexpr int size = PowerSums<Degree>::Size;
  Powers<order> powers;
  Vec timesHeight[Powers<order>::RowsAtOnce][size];
  moments.Clear();
  heights.Clear();
  ForRows<order>(points,
    [&points, &moments, &heights, &powers, &timesHeight](int first, int count)
    {
      for (int row = 0; row < count; ++row)
      {
        const Vec3& p = points.at[first + row];
        powers.Set(row, p, points.Weight(first + row));
        for (int k = 0; k < size; ++k)
        {
          timesHeight[row][k] = p.z * powers.ofV[row][k];
        }
      }
      moments.Add(powers.ofU, powers.ofV, count);
      heights.Add(powers.ofU, timesHeight, count);
    });
}

/// The polynomial with these coefficients at a point, by Horner's rule in v.
template <int Degree>
inline Vec EvaluateTable(const PowerSums<Degree>& coefficients, const Vec& u, const Vec& v)
{
  Vec value{};
#pragma GCC unroll 9
  for (int j = Degree; j >= 0; --j)
  {
    Vec inner = coefficients.at[j][Degree - j];
#pragma GCC unroll 9
    for (int i = Degree - j - 1; i >= 0; --i)
    {
      inner = inner * u + coefficients.at[j][i];
    }
    value = value * v + inner;
  }
  return value;
}

/**
 * LDL^T of the matrix of moments. The monomials come in falling order, so that the rows of those up
 * to order 4 are the last: the factors of the last rows alone give the covariance of their
 * coefficients. Rows that fill up the last tile are those of the identity.
 */
template <int Degree>
struct TiledEquations
{
  static constexpr int Size = NumberOfMonomials(Degree);
  static constexpr int Rows = Padded(Size);
  using Moments = PowerSums<2 * Degree>;

  Vec L[Rows / Tile][Rows][Tile]; ///< Row Tile * b + t, column k at [b][k][t].
  Vec inverseD[Rows];
  Vec excess; ///< Least of what pivots have above SmallestPivotRatio.

  /// The row of a monomial, by its place in rising order.
  static constexpr int RowOf(int index) { return Size - 1 - index; }

  inline const Vec& Element(int row, int column) const
  {
    return this->L[row / Tile][column][row % Tile];
  }

  inline void Factor(const Moments& moments)
  {
    this->excess = moments.at[0][0];
    for (int first = 0; first < Rows; first += Tile)
    {
      this->FactorRows(moments, first);
    }
  }

  /// L x = b.
  inline void SolveForward(Vec* x) const
  {
    for (int first = 0; first < Rows; first += Tile)
    {
      this->SolveForward(first, x);
    }
  }

  /// The same for some right-hand sides at once.
  template <int Sides>
  inline void SolveForward(Vec (&x)[Rows][Sides]) const
  {
    for (int first = 0; first < Rows; first += Tile)
    {
      const Vec(*factors)[Tile] = this->L[first / Tile];
      Vec rest[Tile][Sides];
#pragma GCC unroll 3
      for (int t = 0; t < Tile; ++t)
      {
#pragma GCC unroll 4
        for (int i = 0; i < Sides; ++i)
        {
          rest[t][i] = x[first + t][i];
        }
      }
      for (int k = 0; k < first; ++k)
      {
#pragma GCC unroll 3
        for (int t = 0; t < Tile; ++t)
        {
#pragma GCC unroll 4
          for (int i = 0; i < Sides; ++i)
          {
            rest[t][i] -= factors[k][t] * x[k][i];
          }
        }
      }
#pragma GCC unroll 4
      for (int i = 0; i < Sides; ++i)
      {
        rest[1][i] -= factors[first][1] * rest[0][i];
        rest[2][i] -= factors[first][2] * rest[0][i] + factors[first + 1][2] * rest[1][i];
        x[first][i] = rest[0][i];
        x[first + 1][i] = rest[1][i];
        x[first + 2][i] = rest[2][i];
      }
    }
  }

  inline void Solve(Vec* x) const
  {
    this->SolveForward(x);
    for (int row = 0; row < Rows; ++row)
    {
      x[row] *= this->inverseD[row];
    }
    for (int first = Rows - Tile; first >= 0; first -= Tile)
    {
      this->SolveInTile(first, x);
      this->Subtract(first, x, x);
    }
  }

  /// A y with L^T y = D^(-1/2) s, to within 4 %: see NormalEquations::Probe.
  inline void Probe(Vec* y) const
  {
    for (int row = 0; row < Rows; ++row)
    {
      y[row] = Vec{};
    }
    for (int first = Rows - Tile; first >= 0; first -= Tile)
    {
      const Vec(*factors)[Tile] = this->L[first / Tile];
#pragma GCC unroll 3
      for (int t = Tile - 1; t >= 0; --t)
      {
        Vec sum = y[first + t];
#pragma GCC unroll 3
        for (int below = Tile - 1; below > t; --below)
        {
          sum -= factors[first + t][below] * y[first + below];
        }
        y[first + t] = sum + CopySign(RoughRoot(this->inverseD[first + t]), sum);
      }
      this->Subtract(first, y, y);
    }
  }

private:
  /// Of L x = b, the rows of a tile.
  inline void SolveForward(int first, Vec* x) const
  {
    const Vec(*factors)[Tile] = this->L[first / Tile];
    Vec rest[Tile] = { x[first], x[first + 1], x[first + 2] };
    for (int k = 0; k < first; ++k)
    {
#pragma GCC unroll 3
      for (int t = 0; t < Tile; ++t)
      {
        rest[t] -= factors[k][t] * x[k];
      }
    }
    x[first] = rest[0];
    x[first + 1] = rest[1] - factors[first][1] * x[first];
    x[first + 2] = rest[2] - factors[first][2] * x[first] - factors[first + 1][2] * x[first + 1];
  }

  /// Of L^T x = b, the rows of a tile.
  inline void SolveInTile(int first, Vec* x) const
  {
    const Vec(*factors)[Tile] = this->L[first / Tile];
    x[first + 1] -= factors[first + 1][2] * x[first + 2];
    x[first] -= factors[first][2] * x[first + 2] + factors[first][1] * x[first + 1];
  }

  /// What the solution x in the rows of a tile takes from all rows above it.
  inline void Subtract(int first, const Vec* x, Vec* from) const
  {
    const Vec(*factors)[Tile] = this->L[first / Tile];
    const Vec x0 = x[first];
    const Vec x1 = x[first + 1];
    const Vec x2 = x[first + 2];
    for (int k = 0; k < first; ++k)
    {
      from[k] -= factors[k][0] * x0 + factors[k][1] * x1 + factors[k][2] * x2;
    }
  }

  /// Where the products of monomials are in the table of moments: the sum of two of these.
  struct Places
  {
    int of[Rows];
  };

  static constexpr Places MakePlaces()
  {
    Places places{};
    for (int d = 0; d <= Degree; ++d)
    {
      for (int j = 0; j <= d; ++j)
      {
        places.of[RowOf(MonomialIndex(d - j, j))] = j * Moments::Size + d - j;
      }
    }
    return places;
  }

  // Static, as tables of functions are copied in each call.
  static constexpr Places PlaceOf = MakePlaces();

  static inline Vec MatrixElement(const Moments& moments, int row, int column)
  {
    if (Rows > Size && row >= Size)
    {
      return Broadcast(row == column ? 1.0 : 0.0);
    }
    return (&moments.at[0][0])[PlaceOf.of[row] + PlaceOf.of[column]];
  }

  /// A tile of the matrix, less the products of `scaled` and the factors left of it.
  inline void Eliminate(const Moments& moments, const Vec (*scaled)[Tile], int firstRow,
    int firstColumn, Vec (&rest)[Tile][Tile]) const
  {
#pragma GCC unroll 3
    for (int t = 0; t < Tile; ++t)
    {
#pragma GCC unroll 3
      for (int s = 0; s < Tile; ++s)
      {
        rest[t][s] = MatrixElement(moments, firstRow + t, firstColumn + s);
      }
    }
    const Vec(*factors)[Tile] = this->L[firstColumn / Tile];
    for (int k = 0; k < firstColumn; ++k)
    {
#pragma GCC unroll 3
      for (int t = 0; t < Tile; ++t)
      {
#pragma GCC unroll 3
        for (int s = 0; s < Tile; ++s)
        {
          rest[t][s] -= scaled[k][t] * factors[k][s];
        }
      }
    }
  }

  inline void FactorRows(const Moments& moments, int first)
  {
    Vec(*factors)[Tile] = this->L[first / Tile];
    Vec scaled[Rows][Tile]; // L times D
    Vec rest[Tile][Tile];
    for (int column = 0; column < first; column += Tile)
    {
      this->Eliminate(moments, scaled, first, column, rest);
      const Vec(*above)[Tile] = this->L[column / Tile];
#pragma GCC unroll 3
      for (int t = 0; t < Tile; ++t)
      {
        const Vec s0 = rest[t][0];
        const Vec s1 = rest[t][1] - s0 * above[column][1];
        const Vec s2 = rest[t][2] - s0 * above[column][2] - s1 * above[column + 1][2];
        scaled[column][t] = s0;
        scaled[column + 1][t] = s1;
        scaled[column + 2][t] = s2;
        factors[column][t] = s0 * this->inverseD[column];
        factors[column + 1][t] = s1 * this->inverseD[column + 1];
        factors[column + 2][t] = s2 * this->inverseD[column + 2];
      }
    }
    this->Eliminate(moments, scaled, first, first, rest);
    this->FactorTile(moments, first, rest);
  }

  inline void FactorTile(const Moments& moments, int first, const Vec (&rest)[Tile][Tile])
  {
    Vec(*factors)[Tile] = this->L[first / Tile];
    this->Accept(moments, first, rest[0][0]);
    const Vec l10 = rest[1][0] * this->inverseD[first];
    const Vec l20 = rest[2][0] * this->inverseD[first];
    this->Accept(moments, first + 1, rest[1][1] - rest[1][0] * l10);
    const Vec s21 = rest[2][1] - rest[2][0] * l10;
    const Vec l21 = s21 * this->inverseD[first + 1];
    this->Accept(moments, first + 2, rest[2][2] - rest[2][0] * l20 - s21 * l21);
    factors[first][1] = l10;
    factors[first][2] = l20;
    factors[first + 1][2] = l21;
  }

  inline void Accept(const Moments& moments, int row, const Vec& pivot)
  {
    const Vec diagonal = MatrixElement(moments, row, row);
    // Not finite once means not finite in the last row.
    this->excess = Min(this->excess, pivot - ridges::JetBatchKernel::SmallestPivotRatio * diagonal);
    this->inverseD[row] = 1.0 / pivot;
  }
};

} // namespace

#endif
