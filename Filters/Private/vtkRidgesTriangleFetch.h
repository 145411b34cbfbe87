// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesTriangleFetch_h
#define vtkRidgesTriangleFetch_h

#include "Core/Base/Buffer.h"
#include "Core/Mesh/Triangle.h"
#include "vtkRidgesCompatibility.h"

#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/// All polys, if they are triangles that can be used, and there are no strips; else false. `points`
/// are x, y and z of the points of the data.
bool vtkRidgesFetchAllTriangles(vtkPolyData* data, const double* points,
  const std::vector<std::uint8_t>& usable, ridges::Buffer<ridges::Triangle>& triangles);

#endif
