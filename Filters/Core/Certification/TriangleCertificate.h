// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_TriangleCertificate_h
#define ridges_TriangleCertificate_h

#include "Certification/Hypothesis.h"
#include "Certification/SurfacePiece.h"

#include <cstdint>

namespace ridges
{

/// Whether the image of a triangle contains no umbilic and no ridge that does not cross its edges.
struct TriangleCertificate
{
  std::uint16_t failed = 0; ///< Bits of Hypothesis: MeshFollowsSurface, OneUmbilic,
                            ///< NoRidgeInTriangle.
  Eigen::Vector3d place =
    Eigen::Vector3d::Zero(); ///< On the surface, where the first of them fails.
};

/**
 * By subdivision. k1 - k2 is bounded away from 0. A closed ridge inside would have tangents of all
 * directions: there is none if, wherever the extremality can vanish, its derivative along one and
 * the same direction is positive.
 *
 * Of a degenerate triangle it is known that ridges are everywhere; only umbilics are looked for.
 */
TriangleCertificate CertifyTriangle(
  const SurfaceBounds& surface, const MappedTriangle& whole, bool isDegenerate = false);

/// Whether the projection of a triangle to the surface is one-to-one.
bool IsMapped(const SurfaceBounds& surface, const MappedTriangle& whole);

} // namespace ridges

#endif
