// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkFilters.h"

#include "BenchmarkMeshes.h"
#include "CGALPipeline.h"
#include "Minimum.h"
#include "Tables.h"

#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <benchmark/benchmark.h>

#include <functional>
#include <string>

namespace benchmarks
{

namespace
{

// On three rings of a regular mesh in degree 6, on four in degree 8.
struct Kind
{
  int degree;
  int numberOfPoints;
  int everyBlock; // of CGAL's, which takes milliseconds a point
};

constexpr Kind Kinds[] = { { 4, 18, 1 }, { 6, 34, 4 }, { 8, 56, 16 } };

Times TimesOfFit(vtkPolyData* input, int degree, bool weighted, bool errors)
{
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(input);
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(copy);
  jets->SetNeighborhoodToPointCount();
  jets->SetDegree(degree);
  jets->SetWeighting(weighted ? vtkJetFitting::GAUSSIAN : vtkJetFitting::UNIFORM);
  jets->SetStandardErrors(errors);
  return TimesOf([&] { jets->Update(); });
}

void Measure(benchmark::State& state, const std::string& name, vtkPolyData* input, const Kind& kind)
{
  vtkSMPTools::Initialize(1);
  const auto points = static_cast<double>(input->GetNumberOfPoints());
  CGALPipeline cgal(input, kind.degree, kind.numberOfPoints);
  Minimum plain;
  Minimum errors;
  Minimum weighted;
  Minimum weightedErrors;
  Minimum theirs;
  TimesOfFit(input, kind.degree, false, false); // warms up
  const auto timeOurs = [&]
  {
    plain.Take(TimesOfFit(input, kind.degree, false, false));
    errors.Take(TimesOfFit(input, kind.degree, false, true));
    weighted.Take(TimesOfFit(input, kind.degree, true, false));
    weightedErrors.Take(TimesOfFit(input, kind.degree, true, true));
  };
  for (auto iteration : state)
  {
    theirs.Take(cgal.FitSome(kind.everyBlock, timeOurs));
    state.SetIterationTime(plain.Get().wall);
  }
  const auto microseconds = [points](const Minimum& minimum)
  { return 1e6 * minimum.Get().thread / points; };
  DegreeRow row;
  row.mesh = name;
  row.degree = kind.degree;
  row.numberOfPoints = kind.numberOfPoints;
  row.plain = microseconds(plain);
  row.errors = microseconds(errors);
  row.weighted = microseconds(weighted);
  row.weightedErrors = microseconds(weightedErrors);
  row.cgal = microseconds(theirs);
  DegreeTable().push_back(row);
  state.counters["us/point"] = row.plain;
  state.counters["errors"] = row.errors / row.plain;
  state.counters["CGAL/ours"] = row.cgal / row.plain;
}

} // namespace

void RegisterDegrees()
{
  for (const Kind& kind : Kinds)
  {
    const std::string mesh = "ellipsoid 40k";
    benchmark::RegisterBenchmark(("Degrees/" + std::to_string(kind.degree) + "/" + mesh).c_str(),
      [=](benchmark::State& state) { Measure(state, mesh, EllipsoidMesh(63), kind); })
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(3);
  }
}

} // namespace benchmarks
