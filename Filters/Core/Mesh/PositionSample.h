// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PositionSample_h
#define ridges_PositionSample_h

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace ridges
{

/// About as many points as wanted, or all of a smaller mesh, in an order: both depend on
/// coordinates only. Points that coincide are left out, as nothing distinguishes them.
std::vector<Id> PositionSample(const TriangleMesh& mesh, double wanted);

} // namespace ridges

#endif
