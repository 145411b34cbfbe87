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
 * the same direction is positive. `d1` is a direction of reference.
 */
TriangleCertificate CertifyTriangle(
  const SurfaceBounds& surface, const MappedTriangle& whole, const Eigen::Vector3d& d1);

} // namespace ridges

#endif
