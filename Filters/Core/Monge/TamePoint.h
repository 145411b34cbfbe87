// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_TamePoint_h
#define ridges_TamePoint_h

#include "Mesh/TriangleMesh.h"
#include "Monge/MongeField.h"

namespace ridges
{

/**
 * Whether the normal at the point agrees with all triangles around it within 60 degrees, so that
 * angles in the tangent plane are about those on the surface.
 */
bool IsTame(const TriangleMesh& mesh, const MongeField& field, Id point);

} // namespace ridges

#endif
