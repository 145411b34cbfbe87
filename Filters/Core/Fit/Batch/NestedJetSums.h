// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The points of nested neighbourhoods in a common frame, and sums over them. Included by
// NestedJetKernel.h only.
#ifndef ridges_NestedJetSums_h
#define ridges_NestedJetSums_h

#include "Fit/Batch/NestedJetBatch.h"

#include "Fit/Batch/JetBatchKernel.h"
#include "Fit/Batch/JetBatchTiledKernel.h"

namespace
{

constexpr int NestedFits = ridges::NestedJetBatch::Fits;
constexpr int NestedDegree = ridges::NestedJetBatch::Degrees[NestedFits - 1];

/// The points of the largest neighbourhoods in a common frame, in units of length; the units of the
/// sums, as lengths; and the radii.
struct NestedPoints
{
  LocalPoints local;
  Frame frame;
  Vec unitOfU;
  Vec unitOfV;
  Vec radius[NestedFits];
};

/// Turns u and v as in JetFitter, by the result; the units are about the extents.
inline Axis ChooseUnits(const Vec& count, const Vec& u, const Vec& v, const Vec& uu, const Vec& uv,
  const Vec& vv, NestedPoints& points)
{
  const Vec perCount = 1.0 / count;
  const Vec ofU = uu - u * u * perCount;
  const Vec ofV = vv - v * v * perCount;
  const Vec mixed = uv - u * v * perCount;
  const Vec difference = ofU - ofV;
  const Vec root = Sqrt(difference * difference + 4.0 * mixed * mixed);
  const Axis turn = HalfAngle(difference, 2.0 * mixed, root);
  Frame& frame = points.frame;
  const Vec3 before = frame.u;
  frame.u = turn.u * before + turn.v * frame.v;
  frame.v = turn.u * frame.v - turn.v * before;
  // The points of a disk have a variance of a quarter of the square of its radius.
  points.unitOfU = Sqrt(2.0 * perCount * (ofU + ofV + root));
  points.unitOfV = Sqrt(2.0 * perCount * (ofU + ofV - root));
  return turn;
}

inline void SetNestedPoints(ridges::NestedJetBatch& nested, NestedPoints& points)
{
  points.frame = PrincipalFrame(nested.fits[1], points.local.at);
  const ridges::JetBatch& largest = nested.fits[NestedFits - 1];
  points.local.rows = largest.rows;
  const Frame& frame = points.frame;
  const Vec3 vertex = LoadPoints(largest.points, largest.neighbors, 0);
  Vec counts[NestedFits];
  Vec squaredRadius[NestedFits]{};
  for (int i = 0; i < NestedFits; ++i)
  {
    counts[i] = Load(nested.fits[i].counts);
  }
  Vec u{};
  Vec v{};
  Vec uu{};
  Vec uv{};
  Vec vv{};
  for (int row = 1; row < largest.rows; ++row)
  {
    const Vec number = Broadcast(row);
    const Vec3 offset = Select(number < counts[NestedFits - 1],
      LoadPoints(largest.points, largest.neighbors, row) - vertex, Vec3{});
    const Vec square = Dot(offset, offset);
    for (int i = 0; i < NestedFits; ++i)
    {
      squaredRadius[i] = Max(squaredRadius[i], number < counts[i] ? square : Vec{});
    }
    const Vec3 p{ Dot(frame.u, offset), Dot(frame.v, offset), Dot(frame.n, offset) };
    points.local.at[row] = p;
    u += p.x;
    v += p.y;
    uu += p.x * p.x;
    uv += p.x * p.y;
    vv += p.y * p.y;
  }
  for (int i = 0; i < NestedFits; ++i)
  {
    points.radius[i] = Sqrt(squaredRadius[i]);
  }
  const Axis turn = ChooseUnits(counts[NestedFits - 1], u, v, uu, uv, vv, points);
  const Vec perU = 1.0 / points.unitOfU;
  const Vec perV = 1.0 / points.unitOfV;
  const Vec perHeight = 1.0 / points.radius[NestedFits - 1];
  for (int row = 1; row < largest.rows; ++row)
  {
    Vec3& p = points.local.at[row];
    p = { perU * (turn.u * p.x + turn.v * p.y), perV * (turn.u * p.y - turn.v * p.x),
      perHeight * p.z };
  }
}

/// Sums over the points so far; heights are in units of the largest radius.
struct NestedSums
{
  PowerSums<2 * NestedDegree> moments;
  PowerSums<NestedDegree> heights;
  Vec squares{}; ///< Of the heights.

  /// Adds the points of the neighbourhoods with these counts that are not in those before.
  inline void Add(
    const LocalPoints& points, int first, int last, const Vec& before, const Vec& counts)
  {
    constexpr int order = 2 * NestedDegree;
    constexpr int size = PowerSums<NestedDegree>::Size;
    constexpr int rowsAtOnce = Powers<order>::RowsAtOnce;
    Powers<order> powers;
    Vec timesHeight[rowsAtOnce][size];
    for (; first < last; first += rowsAtOnce)
    {
      const int count = last - first < rowsAtOnce ? last - first : rowsAtOnce;
      for (int row = 0; row < count; ++row)
      {
        const Vec number = Broadcast(first + row);
        const Vec weight = number >= before ? (number < counts ? Broadcast(1.0) : Vec{}) : Vec{};
        const Vec3& p = points.at[first + row];
        powers.Set(row, p, weight);
        this->squares += weight * p.z * p.z;
        for (int k = 0; k < size; ++k)
        {
          timesHeight[row][k] = p.z * powers.ofV[row][k];
        }
      }
      this->moments.Add(powers.ofU, powers.ofV, count);
      this->heights.Add(powers.ofU, timesHeight, count);
    }
  }
};

/// Marks a frame by how the points of a neighbourhood spread in it.
inline void JudgeSpread(const NestedPoints& points, const NestedSums& sums, Frame& frame)
{
  const auto& m = sums.moments.at;
  const Vec perCount = 1.0 / m[0][0];
  const Vec perHeight = 1.0 / points.radius[NestedFits - 1];
  const Vec u = points.unitOfU * perHeight;
  const Vec v = points.unitOfV * perHeight;
  const Vec ofU = u * u * (m[0][2] - m[0][1] * m[0][1] * perCount);
  const Vec ofV = v * v * (m[2][0] - m[1][0] * m[1][0] * perCount);
  const Vec mixed = u * v * (m[1][1] - m[0][1] * m[1][0] * perCount);
  const Vec height = sums.heights.at[0][0];
  const Vec along = sums.squares - height * height * perCount;
  const Vec difference = ofU - ofV;
  const Vec least = 0.5 * (ofU + ofV - Sqrt(difference * difference + 4.0 * mixed * mixed));
  frame.bends = along > ridges::JetBatchKernel::MostSpreadOfNoise * least;
  frame.mayFold |= along > ridges::JetBatchKernel::MostSpread * least;
}

} // namespace

#endif
