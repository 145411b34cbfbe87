// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RIDGES_BENCHMARKS_BENCHMARK_FILTERS_H
#define RIDGES_BENCHMARKS_BENCHMARK_FILTERS_H

namespace benchmarks
{

// "<stage>/<mesh>": the filters with one and two threads, one after the other and the whole
// pipeline; side by side with CGAL on meshes of up to 40k points and with vtkCurvatures.
void RegisterFilters();

// "Kernels/<mesh>": gathering, filling and fitting for each instruction set, side by side with
// CGAL.
void RegisterKernels();

} // namespace benchmarks

#endif
