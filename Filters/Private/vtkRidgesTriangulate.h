// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesTriangulate_h
#define vtkRidgesTriangulate_h

#include "vtkRidgesCompatibility.h"

#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * The data set with all polygons and strips cut into triangles, and their cell data; points, verts
 * and lines are passed over as they are. Private to the module.
 *
 * vtkTriangleFilter cuts polylines as well, and drops some polygons that are far from planar, which
 * opens a hole: here those are cut into a fan from their first point.
 */
vtkSmartPointer<vtkPolyData> vtkRidgesTriangulate(vtkPolyData* input);

#endif
