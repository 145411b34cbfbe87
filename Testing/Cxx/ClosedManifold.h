// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ClosedManifold_h
#define ClosedManifold_h

#include "vtkPolyData.h"

namespace ridges
{
namespace testing
{

/// Whether each edge is in two polygons, in opposite senses, and the polygons around each point
/// are one fan.
bool IsClosedManifold(vtkPolyData* mesh);

} // namespace testing
} // namespace ridges

#endif
