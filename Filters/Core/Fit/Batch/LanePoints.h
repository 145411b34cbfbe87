// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Points of a mesh, one per lane: see LaneVector.h. Where it is known how, they are loaded whole
// and transposed in registers, rather than coordinate by coordinate. The fourth coordinate is
// masked out: there may be none.
#ifndef ridges_LanePoints_h
#define ridges_LanePoints_h

#include "Fit/Batch/LaneVector.h"

#include <cstdint>

#if defined(__AVX512F__) && defined(__AVX512VL__) && RIDGES_LANES == 8
#define RIDGES_LANE_POINTS_AVX512
#include <immintrin.h>
#elif defined(__AVX__) && RIDGES_LANES == 4
#define RIDGES_LANE_POINTS_AVX
#include <immintrin.h>
#endif

namespace
{

/// Point number `row` of each lane's list.
inline Vec3 LoadPoints(const double* points, const std::int32_t* const* lists, int row)
{
  const auto point = [points, lists, row](int lane)
  { return points + 3 * static_cast<std::int64_t>(lists[lane][row]); };
#if defined(RIDGES_LANE_POINTS_AVX512)
  const auto load = [&point](int low, int high)
  {
    const __m512d first = _mm512_castpd256_pd512(_mm256_maskz_loadu_pd(7, point(low)));
    return _mm512_maskz_insertf64x4(0xff, first, _mm256_maskz_loadu_pd(7, point(high)), 1);
  };
  const __m512d p02 = load(0, 2);
  const __m512d p13 = load(1, 3);
  const __m512d p46 = load(4, 6);
  const __m512d p57 = load(5, 7);
  // With masks of all ones: without, GCC 12 warns of its own headers.
  const __m512d xz0 = _mm512_maskz_unpacklo_pd(0xff, p02, p13); // x0 x1 z0 z1 x2 x3 z2 z3
  const __m512d xz4 = _mm512_maskz_unpacklo_pd(0xff, p46, p57);
  const __m512d y0 = _mm512_maskz_unpackhi_pd(0xff, p02, p13); // y0 y1 . . y2 y3 . .
  const __m512d y4 = _mm512_maskz_unpackhi_pd(0xff, p46, p57);
  return { _mm512_maskz_shuffle_f64x2(0xff, xz0, xz4, 0x88),
    _mm512_maskz_shuffle_f64x2(0xff, y0, y4, 0x88),
    _mm512_maskz_shuffle_f64x2(0xff, xz0, xz4, 0xdd) };
#elif defined(RIDGES_LANE_POINTS_AVX)
  const __m256i xyz = _mm256_setr_epi64x(-1, -1, -1, 0);
  const __m256d p0 = _mm256_maskload_pd(point(0), xyz);
  const __m256d p1 = _mm256_maskload_pd(point(1), xyz);
  const __m256d p2 = _mm256_maskload_pd(point(2), xyz);
  const __m256d p3 = _mm256_maskload_pd(point(3), xyz);
  const __m256d xz0 = _mm256_unpacklo_pd(p0, p1); // x0 x1 z0 z1
  const __m256d xz2 = _mm256_unpacklo_pd(p2, p3);
  const __m256d y0 = _mm256_unpackhi_pd(p0, p1);
  const __m256d y2 = _mm256_unpackhi_pd(p2, p3);
  return { _mm256_permute2f128_pd(xz0, xz2, 0x20), _mm256_permute2f128_pd(y0, y2, 0x20),
    _mm256_permute2f128_pd(xz0, xz2, 0x31) };
#else
  Vec3 result{};
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const double* p = point(lane);
    result.x[lane] = p[0];
    result.y[lane] = p[1];
    result.z[lane] = p[2];
  }
  return result;
#endif
}

} // namespace

#endif
