// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_JetBatch_h
#define ridges_JetBatch_h

#include <cstdint>
#include <vector>

namespace ridges
{

/**
 * The neighbourhoods of several vertices side by side, a vertex per lane of a SIMD register, and
 * the Monge forms fitted to them: plain memory, shared by kernels for different instruction sets.
 *
 * With L lanes, component c of lane l is side[c * L + l], and the weight of its row i is
 * weights[i * L + l]; likewise for the other arrays.
 */
struct JetBatch
{
  static constexpr int MaximumLanes = 8;
  static constexpr int MaximumRows = 3072; ///< Of 28 rings, and some more.
  static constexpr int NumberOfErrors = 8;
  static constexpr double UnknownError = -1.0;

  /// @name Input
  ///@{
  int degree;           ///< 2 to 8
  int rows;             ///< Most points that a lane has.
  int triangles;        ///< Most triangles that the fan of a lane has.
  bool weighted;        ///< Whether there are weights; else all points count the same.
  bool standardErrors;  ///< Whether they are wanted.
  bool exactGain;       ///< Whether the noise gain is to be exact: see JetBatchKernel.
  const double* points; ///< x, y, z of each point of the mesh.

  /// The points of each lane, the vertex first. Of all lanes `rows` are read; those past the end
  /// of a lane count nothing, but have to be points.
  const std::int32_t* neighbors[MaximumLanes];

  alignas(64) double counts[MaximumLanes]; ///< Points of each lane.

  /// Triangles of each lane's fan, whose points come next after the vertex, in order. In a closed
  /// fan the last triangle ends at the first of them.
  alignas(64) double fans[MaximumLanes];
  alignas(64) double closedFans[MaximumLanes]; ///< The same number, or 0 where it is open.
  alignas(64) double side[3 * MaximumLanes];   ///< Where the normal is to point if not to
                                               ///< that of the fan.
  alignas(64) double weights[MaximumRows * MaximumLanes]; ///< Of the points, 0 past the end.
  ///@}

  /// @name Output
  ///@{
  alignas(64) double d1[3 * MaximumLanes];
  alignas(64) double d2[3 * MaximumLanes];
  alignas(64) double n[3 * MaximumLanes];
  alignas(64) double k1[MaximumLanes];
  alignas(64) double k2[MaximumLanes];
  alignas(64) double b[4 * MaximumLanes];
  alignas(64) double c[5 * MaximumLanes];
  alignas(64) double P1[MaximumLanes];
  alignas(64) double P2[MaximumLanes];
  alignas(64) double residual[MaximumLanes];        ///< As in JetFit.
  alignas(64) double conditionNumber[MaximumLanes]; ///< See JetBatchKernel.
  alignas(64) double noiseGain[MaximumLanes];       ///< As in JetFit, see JetBatchKernel.
  alignas(64) double radius[MaximumLanes];          ///< As in JetFit.
  alignas(64) double good[MaximumLanes];            ///< Whether the lane has a result: 1 or 0.
  alignas(64) double doubtful[MaximumLanes];        ///< Whether the surface may fold over: 1 or 0.

  /// Standard errors of k1, k2, b0 to b3, P1 and P2, if they are wanted: see StandardErrors in
  /// JetErrors.h.
  alignas(64) double errors[NumberOfErrors * MaximumLanes];
  ///@}
};

/**
 * Fits all lanes of a batch at once: the principal frame of each neighbourhood, the moments of its
 * points, the normal equations by an unpivoted LDL^T factorisation, one step of iterative
 * refinement with residuals taken at the points, and the Monge form.
 *
 * The normal equations square the condition number; the refinement makes up for that as long as
 * they are not singular to working precision. The ratio of a pivot to the diagonal element it
 * started from tells: it is the squared sine of the angle between a column of the least squares
 * and those before it, whatever the scaling of the columns. A lane with a ratio that is not above
 * `SmallestPivotRatio`, whose frame failed, or with a value that is not finite has no result and
 * is to be fitted by JetFitter.
 *
 * The condition number is 0 if the frame failed, and `Singular` if a pivot did. Else it is that of
 * the least squares, estimated from the factors: the longest column of its matrix over a bound on
 * the least singular value that is at most five times too large (by experience, as the pivots in
 * JetFit; in theory there is no such limit). Its points are in units of the radius up to degree 4,
 * and above in those of JetFitter, in whose orthonormal polynomials the condition number is then
 * meant. The noise gain is estimated too, up to degree 4, if no exact one is wanted, which takes a
 * twentieth of the time: by experience within a factor of 0.6 to 1.8.
 */
struct JetBatchKernel
{
  static constexpr double SmallestPivotRatio = 1e-9;
  static constexpr double Singular = 1e300;

  /// A lane is doubtful if its heights are off the polynomial by more than this, as noise in units
  /// of the radius, and spread more than this along the normal, in units of the lesser spread
  /// across it; if they spread more than that; or if a triangle of the fan has a cosine to the
  /// normal below this. Where the surface folds over at least one is so.
  static constexpr double MostNoise = 0.01;
  static constexpr double MostSpreadOfNoise = 0.02;
  static constexpr double MostSpread = 0.1;
  static constexpr double UprightBelow = 0.1;

  const char* name;
  int lanes;
  void (*fit)(JetBatch& batch);
};

/// The kernels that this processor can run, the fastest first. None without compiler vectors.
const std::vector<JetBatchKernel>& JetBatchKernels();

} // namespace ridges

#endif
