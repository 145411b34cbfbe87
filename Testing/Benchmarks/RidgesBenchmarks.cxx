// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Takes the options of Google Benchmark, and prints tables after its report.

#include "BenchmarkFilters.h"
#include "MachineFacts.h"
#include "Tables.h"

#include "vtkObject.h"

#include <benchmark/benchmark.h>

#include <iostream>

int main(int argc, char* argv[])
{
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    return 2;
  }
  // vtkCurvatures warns of points one by one.
  vtkObject::GlobalWarningDisplayOff();
  const auto facts = benchmarks::MachineFacts();
  for (const auto& fact : facts)
  {
    benchmark::AddCustomContext(fact.first, fact.second);
  }
  benchmarks::RegisterKernels();
  benchmarks::RegisterDegrees();
  benchmarks::RegisterFilters();
  benchmark::RunSpecifiedBenchmarks();
  std::cout << "\n| machine | |\n|---|---|\n";
  for (const auto& fact : facts)
  {
    std::cout << "| " << fact.first << " | " << fact.second << " |\n";
  }
  benchmarks::PrintTables(std::cout);
  return 0;
}
