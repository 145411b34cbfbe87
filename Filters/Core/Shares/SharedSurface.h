// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SharedSurface_h
#define ridges_SharedSurface_h

#include "Shares/SharedPoints.h"

#include <cstdint>
#include <vector>

namespace ridges
{

/// What ranks that have looked around all their points know of the whole surface.
struct SharedSurface
{
  SharedPoints points;
  std::int64_t eulerCharacteristic = 0;
  bool isClosed = true;
  bool hasCoincident = false;         ///< Points at the places of others.
  std::vector<std::uint8_t> onBorder; ///< Of owned points: see TriangleMesh::OnBorder.
};

} // namespace ridges

#endif
