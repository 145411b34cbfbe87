// SPDX-License-Identifier: BSD-3-Clause
// What FitJetBatch... do, for RIDGES_LANES lanes: see JetBatch.h. Every lane does the same
// arithmetic whatever its neighbours hold, and rows past its end add zeros, so that the result of a
// vertex does not depend on the batch it came in.
#ifndef ridges_JetBatchKernel_h
#define ridges_JetBatchKernel_h

#include "JetBatchFrame.h"
#include "JetBatchMoments.h"
#include "JetBatchMonge.h"
#include "JetBatchSolve.h"

namespace
{

template <int Degree>
inline void FitDegree(ridges::JetBatch& batch)
{
  constexpr int size = NumberOfMonomials(Degree);
  constexpr int order = 2 * Degree;

  const Frame frame = PrincipalFrame(batch);
  const Vec perRadius = 1.0 / frame.radius;
  LocalPoints points;
  points.rows = batch.rows;
  points.weights = batch.weights;
  const Vec3 u = perRadius * frame.u;
  const Vec3 v = perRadius * frame.v;
  const Vec3 n = perRadius * frame.n;
  for (int row = 0; row < batch.rows; ++row)
  {
    const Vec3 offset = Load3(batch.offsets + 3 * row * Lanes);
    points.u[row] = Dot(u, offset);
    points.v[row] = Dot(v, offset);
    points.height[row] = Dot(n, offset);
  }

  // In two passes, as the sums of one would not fit in the registers.
  Vec moments[order + 1][order + 1];
  AddMoments<order, 0, 2>(points, moments);
  AddMoments<order, 3, order>(points, moments);
  NormalEquations<Degree> equations;
  equations.Factor(moments);

  Vec coefficients[size];
  Project<Degree>(
    points, [&](int row) { return Load(batch.weights + row * Lanes) * points.height[row]; },
    coefficients);
  equations.Solve(coefficients);

  // Iterative refinement: what the polynomial misses at the points, fitted once more.
  Vec squares{};
  Vec totalWeight{};
  Vec corrections[size];
  Project<Degree>(
    points,
    [&](int row)
    {
      const Vec weight = Load(batch.weights + row * Lanes);
      const Vec missed =
        points.height[row] - Evaluate<Degree>(coefficients, points.u[row], points.v[row]);
      squares += weight * missed * missed;
      totalWeight += weight;
      return weight * missed;
    },
    corrections);
  equations.Solve(corrections);
  for (int k = 0; k < size; ++k)
  {
    coefficients[k] += corrections[k];
  }

  Store(batch.residual, Sqrt(squares / totalWeight));
  Store(batch.conditionNumber, Sqrt(equations.largestPivot / equations.smallestPivot));
  Store(batch.radius, frame.radius);
  Store(batch.pivotRatio, frame.failed ? Vec{} : equations.pivotRatio);
  StoreMongeForm<Degree>(batch, frame, coefficients, perRadius);
}

inline void FitLanes(ridges::JetBatch& batch)
{
  switch (batch.degree)
  {
    case 2:
      return FitDegree<2>(batch);
    case 3:
      return FitDegree<3>(batch);
    default:
      return FitDegree<4>(batch);
  }
}

} // namespace

#endif
