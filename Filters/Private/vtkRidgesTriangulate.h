// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesTriangulate_h
#define vtkRidgesTriangulate_h

#include "vtkSmartPointer.h"

class vtkPolyData;

/**
 * The data set with all polygons and strips as triangles, private to the module: the output of
 * vtkTriangleFilter. Should that have dropped a polygon, as it does with some that are far from
 * planar, which opens a hole, polygons that it cannot do are cut into a fan from their first point.
 */
vtkSmartPointer<vtkPolyData> vtkRidgesTriangulate(vtkPolyData* input);

#endif
