// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RIDGES_BENCHMARKS_BENCHMARK_FILTERS_H
#define RIDGES_BENCHMARKS_BENCHMARK_FILTERS_H

namespace benchmarks
{

// "<stage>/<mesh>": the filters with one and two threads, one after the other and the whole
// pipeline; side by side with CGAL on meshes of up to 40k points and with vtkCurvatures.
void RegisterFilters();

// "Degrees/<what>/<mesh>": the fit by the filter on one thread in degrees 4, 6 and 8, without and
// with standard errors, and with weights, side by side with CGAL's of the same degree and points.
void RegisterDegrees();

// "Kernels/<mesh>": gathering, filling and fitting for each instruction set, side by side with
// CGAL.
void RegisterKernels();

} // namespace benchmarks

#endif
