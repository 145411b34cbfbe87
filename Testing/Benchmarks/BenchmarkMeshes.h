// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What is measured on. Nothing is random.

#ifndef RIDGES_BENCHMARKS_BENCHMARK_MESHES_H
#define RIDGES_BENCHMARKS_BENCHMARK_MESHES_H

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace benchmarks
{

// The ellipsoid of vtkRidgeExampleSource: 10 frequency^2 + 2 points.
vtkSmartPointer<vtkPolyData> EllipsoidMesh(int frequency);

// A triangle mesh in the OFF format; null if the file cannot be read.
vtkSmartPointer<vtkPolyData> ReadOff(const std::string& path);

} // namespace benchmarks

#endif
