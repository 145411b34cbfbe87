// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_EnclosedVolume_h
#define ridges_EnclosedVolume_h

#include "Mesh/TriangleMesh.h"

namespace ridges
{

/**
 * Whether a closed surface, whose neighbouring triangles are oriented alike, encloses a negative
 * volume: its normals point inwards. False for any other mesh.
 */
bool IsInsideOut(const TriangleMesh& mesh);

} // namespace ridges

#endif
