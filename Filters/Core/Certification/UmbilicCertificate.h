// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_UmbilicCertificate_h
#define ridges_UmbilicCertificate_h

#include "Certification/SurfacePiece.h"

#include <array>

namespace ridges
{

/// An umbilic and the disk around it in which it is the only one.
struct UmbilicCertificate
{
  Eigen::Vector3d position;
  Eigen::Matrix3d frame;   ///< u, v and the normal.
  bool isIsolated = false; ///< There is exactly one umbilic within `error` of the position.
  double error = 0.0;
  /// All ridges in this disk, by its projection along the normal, run from the umbilic to the
  /// border, across every circle once; 0 if that could not be shown of any disk.
  double radius = 0.0;
  double height = 0.0;             ///< The surface over the disk is closer to the plane than this.
  double index = 0.0;              ///< +1/2 or -1/2
  std::array<int, 2> ridgeCount{}; ///< Of blue and red ridges that end there: 1 or 3.
};

/// Newton's method for an umbilic near a point; false if it finds none within `reach`.
bool FindUmbilic(const SurfaceBounds& surface, double reach, Eigen::Vector3d& position);

/**
 * Certifies an umbilic. Krawczyk's test shows that there is one. In polar coordinates around it the
 * anisotropy, divided by the radius, has a limit, and so has the extremality as a function of the
 * angle: where that is shown to have only simple zeros, ridges cross all circles transversally. The
 * disk is sought from `largest` downward, halved every time.
 */
UmbilicCertificate CertifyUmbilic(
  const SurfaceBounds& surface, const Eigen::Vector3d& position, double largest);

} // namespace ridges

#endif
