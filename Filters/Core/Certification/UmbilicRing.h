// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_UmbilicRing_h
#define ridges_UmbilicRing_h

#include "Certification/UmbilicCertificate.h"

namespace ridges
{

/// Whether ridges cross all circles around an umbilic with radii between two transversally, and
/// there is no umbilic. Circles are those of the plane of the umbilic's frame.
bool IsCrossedTransversally(
  const SurfaceBounds& surface, const UmbilicCertificate& umbilic, double inner, double outer);

} // namespace ridges

#endif
