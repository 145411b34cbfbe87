// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_UmbilicSectors_h
#define ridges_UmbilicSectors_h

#include "Certification/RidgeSeries.h"
#include "Certification/SurfaceBounds.h"

#include <array>
#include <optional>

namespace ridges
{

/**
 * The numbers of blue and red ridges in a disk around an umbilic, by sectors: with the anisotropy
 * divided by the radius, the extremality at an angle has a limit at the umbilic. Where it is shown
 * to have only simple zeros as a function of the angle, ridges cross all circles transversally, and
 * all of them run from the umbilic to the border. Nothing if that could not be shown.
 *
 * `height` is the Taylor polynomial of the surface in the tangent plane, at all points of the disk.
 */
std::optional<std::array<int, 2>> RidgesAroundUmbilic(
  double radius, const Series2<4, Interval>& height);

} // namespace ridges

#endif
