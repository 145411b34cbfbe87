// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The principal frames of a batch of neighbourhoods. Included by JetBatchKernel.h only.
#ifndef ridges_JetBatchFrame_h
#define ridges_JetBatchFrame_h

#include "Fit/Batch/JetBatch.h"
#include "Fit/Batch/LanePoints.h"

namespace
{

/// Direct orthonormal axes; n is the direction of least spread. u and v are any: the space of
/// polynomials of a degree is the same for all of them.
struct Frame
{
  Vec3 u, v, n;
  Vec radius;
  decltype(Vec{} < Vec{}) failed;
  decltype(Vec{} < Vec{}) bends;   ///< The points spread along n more than noise alone does.
  decltype(Vec{} < Vec{}) mayFold; ///< The points spread much along n, or the fan is sharp.
};

/// The continuous choice of Duff and others (Building an orthonormal basis, revisited, 2017).
inline void CompleteFrame(Frame& frame)
{
  const Vec3& n = frame.n;
  const Vec sign = WithSign(Broadcast(1.0), n.z);
  const Vec a = -1.0 / (sign + n.z);
  const Vec b = n.x * n.y * a;
  frame.u = { 1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x };
  frame.v = { b, sign + n.y * n.y * a, -n.y };
}

struct SymmetricMatrix
{
  Vec xx, xy, xz, yy, yz, zz;
};

/// Takes the points, as offsets from the vertices, zero past the end of a lane. The result is
/// their covariance about their mean, with trace 1; and their largest squared distance from the
/// vertex.
inline SymmetricMatrix Covariance(const ridges::JetBatch& batch, Vec3* offsets, Vec& squaredRadius)
{
  const Vec counts = Load(batch.counts);
  const Vec3 vertex = LoadPoints(batch.points, batch.neighbors, 0);
  offsets[0] = Vec3{};
  Vec3 sum{};
  SymmetricMatrix c{};
  squaredRadius = Vec{};
  for (int row = 1; row < batch.rows; ++row)
  {
    const Vec3 offset = LoadPoints(batch.points, batch.neighbors, row) - vertex;
    const Vec3 d = Select(Broadcast(row) < counts, offset, Vec3{});
    offsets[row] = d;
    const Vec xx = d.x * d.x;
    const Vec yy = d.y * d.y;
    const Vec zz = d.z * d.z;
    sum = sum + d;
    c.xx += xx;
    c.yy += yy;
    c.zz += zz;
    c.xy += d.x * d.y;
    c.xz += d.x * d.z;
    c.yz += d.y * d.z;
    squaredRadius = Max(squaredRadius, xx + yy + zz);
  }
  const Vec3 mean = 1.0 / Load(batch.counts) * sum;
  c.xx -= sum.x * mean.x;
  c.yy -= sum.y * mean.y;
  c.zz -= sum.z * mean.z;
  c.xy -= sum.x * mean.y;
  c.xz -= sum.x * mean.z;
  c.yz -= sum.y * mean.z;
  const Vec scale = 1.0 / (c.xx + c.yy + c.zz);
  return { scale * c.xx, scale * c.xy, scale * c.xz, scale * c.yy, scale * c.yz, scale * c.zz };
}

constexpr double SmallestSlope = 1e-7;
constexpr double LargestStep = 1e-6;
constexpr double SmallestCosine = 0.5; // As in PointFitter.

/// Gives n the sign of the sum of the area normals of the fan, or of what was given; marks fans of
/// which a triangle is nearly upright or opposite.
inline void ChooseSide(const ridges::JetBatch& batch, const Vec3* offsets, Frame& frame)
{
  const Vec fans = Load(batch.fans);
  const Vec closed = Load(batch.closedFans);
  Vec3 side = Load3(batch.side);
  Vec least{};
  Vec most{};
  Vec excess{};
  for (int i = 1; i <= batch.triangles; ++i)
  {
    const Vec number = Broadcast(i);
    const Vec3 to = Select(number == closed, offsets[1], offsets[i + 1]);
    const Vec3 normal = Select(number <= fans, Cross(offsets[i], to), Vec3{});
    const Vec along = Dot(frame.n, normal);
    constexpr double square =
      ridges::JetBatchKernel::UprightBelow * ridges::JetBatchKernel::UprightBelow;
    excess = Max(excess, square * Dot(normal, normal) - along * along);
    least = Min(least, along);
    most = Max(most, along);
    side = side + normal;
  }
  const Vec along = Dot(frame.n, side);
  frame.n = WithSign(Broadcast(1.0), along) * frame.n;
  frame.mayFold |= excess > 0.0 || least * most < 0.0;
  // Least spread is not always across the surface: see PointFitter.
  frame.failed |= !(along * along > SmallestCosine * SmallestCosine * Dot(side, side));
}

/// The offsets, and the frame that they spread in.
inline Frame PrincipalFrame(const ridges::JetBatch& batch, Vec3* offsets)
{
  Frame frame;
  Vec squaredRadius;
  const SymmetricMatrix c = Covariance(batch, offsets, squaredRadius);
  frame.radius = Sqrt(squaredRadius);

  // The least root of f = t^3 - t^2 + m t - d by Newton's method, from the first terms of its
  // series in d. Left of the root f is concave and rises, and the start is left of it where the
  // root is small against the next: there each step squares the error.
  const Vec m = c.xx * c.yy - c.xy * c.xy + c.xx * c.zz - c.xz * c.xz + c.yy * c.zz - c.yz * c.yz;
  const Vec d = c.xx * (c.yy * c.zz - c.yz * c.yz) - c.xy * (c.xy * c.zz - c.yz * c.xz) +
    c.xz * (c.xy * c.yz - c.yy * c.xz);
  const Vec perM = 1.0 / m;
  Vec t = d * perM + (d * perM) * (d * perM) * perM;
  Vec f{};
  Vec slope{};
  for (int step = 0; step < 3; ++step)
  {
    f = ((t - 1.0) * t + m) * t - d;
    slope = (3.0 * t - 2.0) * t + m;
    t -= f / slope;
  }
  // The slope is the product of the distances to the other eigenvalues: where it is small, the two
  // least are hardly apart, or the points lie on a line. The last step squares what was wrong
  // before, so that what is left is of the order of rounding.
  frame.failed = !(slope > SmallestSlope && Abs(f) < LargestStep * slope * slope);

  // The two others, of a given sum and product, are at both sides of x where this is negative.
  const Vec sum = 1.0 - t;
  const Vec product = m - t * sum;
  const auto isSpread = [&t, &sum, &product](double part)
  {
    const Vec x = (1.0 / part) * t;
    return (x - sum) * x + product < 0.0 || x > 0.5 * sum;
  };
  frame.mayFold = isSpread(ridges::JetBatchKernel::MostSpread);
  frame.bends = isSpread(ridges::JetBatchKernel::MostSpreadOfNoise);

  // Its eigenvector is orthogonal to the rows of C - t I: the longest of their cross products.
  const Vec3 row0{ c.xx - t, c.xy, c.xz };
  const Vec3 row1{ c.xy, c.yy - t, c.yz };
  const Vec3 row2{ c.xz, c.yz, c.zz - t };
  const Vec3 candidate1 = Cross(row0, row2);
  const Vec3 candidate2 = Cross(row1, row2);
  Vec3 longest = Cross(row0, row1);
  Vec length = Dot(longest, longest);
  const Vec length1 = Dot(candidate1, candidate1);
  const Vec length2 = Dot(candidate2, candidate2);
  longest = Select(length1 > length, candidate1, longest);
  length = Max(length, length1);
  longest = Select(length2 > length, candidate2, longest);
  length = Max(length, length2);
  frame.n = 1.0 / Sqrt(length) * longest;
  ChooseSide(batch, offsets, frame);
  CompleteFrame(frame);
  return frame;
}

} // namespace

#endif
