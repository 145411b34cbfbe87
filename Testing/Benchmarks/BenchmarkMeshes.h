// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What is measured on. Random numbers have fixed seeds.

#ifndef RIDGES_BENCHMARKS_BENCHMARK_MESHES_H
#define RIDGES_BENCHMARKS_BENCHMARK_MESHES_H

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace benchmarks
{

// The ellipsoid of vtkRidgeExampleSource: 10 frequency^2 + 2 points.
vtkSmartPointer<vtkPolyData> EllipsoidMesh(int frequency);

// The same with its points moved along the normals of the mesh: normally distributed, with a
// standard deviation of `noise` mean edges. The seed is fixed.
vtkSmartPointer<vtkPolyData> NoisyEllipsoidMesh(int frequency, double noise);

// A triangle mesh in the OFF format; null if the file cannot be read.
vtkSmartPointer<vtkPolyData> ReadOff(const std::string& path);

} // namespace benchmarks

#endif
