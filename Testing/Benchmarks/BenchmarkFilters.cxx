// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkFilters.h"

#include "BenchmarkMeshes.h"
#include "CGALPipeline.h"
#include "Minimum.h"
#include "Tables.h"

#include "vtkCurvatures.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkRidgeExtraction.h"
#include "vtkSMPTools.h"
#include "vtkUmbilicDetection.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace benchmarks
{

namespace
{

// The input of each stage, made when first asked for; CGAL's only for meshes it can do in seconds.
class StageInputs
{
public:
  explicit StageInputs(std::function<vtkSmartPointer<vtkPolyData>()> make, bool withCGAL)
    : Make(std::move(make))
    , WithCGAL(withCGAL)
  {
  }

  vtkPolyData* Mesh()
  {
    if (!this->MeshData)
    {
      this->MeshData = this->Make();
    }
    return this->MeshData;
  }
  vtkPolyData* Fitted()
  {
    if (!this->FittedData)
    {
      vtkNew<vtkJetFitting> jets;
      jets->SetNeighborhoodToPointCount();
      jets->SetInputData(this->Mesh());
      jets->Update();
      this->FittedData = jets->GetOutput();
    }
    return this->FittedData;
  }
  vtkPolyData* Marked()
  {
    if (!this->MarkedData)
    {
      vtkNew<vtkUmbilicDetection> umbilics;
      umbilics->SetInputData(this->Fitted());
      umbilics->Update();
      this->MarkedData = umbilics->GetOutput();
    }
    return this->MarkedData;
  }
  // With a fit already done, or null.
  CGALPipeline* CGAL()
  {
    if (this->WithCGAL && !this->CGALData)
    {
      this->CGALData = std::make_unique<CGALPipeline>(this->Mesh());
      this->CGALData->Fit();
    }
    return this->CGALData.get();
  }
  void Release()
  {
    this->MeshData = this->FittedData = this->MarkedData = nullptr;
    this->CGALData.reset();
  }

private:
  std::function<vtkSmartPointer<vtkPolyData>()> Make;
  bool WithCGAL;
  vtkSmartPointer<vtkPolyData> MeshData, FittedData, MarkedData;
  std::unique_ptr<CGALPipeline> CGALData;
};

// Each with a new filter, so that output memory is new, too; freeing it is not timed. And with a
// copy of the input: what the filter before hands on with its output stays behind.
template <typename Filter>
Times TimesOfFilter(vtkPolyData* input)
{
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(input);
  vtkNew<Filter> filter;
  filter->SetInputData(copy);
  return TimesOf([&] { filter->Update(); });
}

// On the points that CGAL gets.
Times TimesOfFit(vtkPolyData* input)
{
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(input);
  vtkNew<vtkJetFitting> jets;
  jets->SetNeighborhoodToPointCount();
  jets->SetInputData(copy);
  return TimesOf([&] { jets->Update(); });
}

Times TimesOfPipeline(vtkPolyData* input)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetNeighborhoodToPointCount();
  jets->SetInputData(input);
  vtkNew<vtkUmbilicDetection> umbilics;
  umbilics->SetInputConnection(jets->GetOutputPort());
  vtkNew<vtkRidgeExtraction> ridges;
  ridges->SetInputConnection(umbilics->GetOutputPort());
  return TimesOf([&] { ridges->Update(); });
}

// The maximum and the minimum curvature: a filter each.
Times TimesOfCurvatures(vtkPolyData* input)
{
  Times times;
  for (const int type : { VTK_CURVATURE_MAXIMUM, VTK_CURVATURE_MINIMUM })
  {
    vtkNew<vtkCurvatures> curvatures;
    curvatures->SetCurvatureType(type);
    curvatures->SetInputData(input);
    times = times + TimesOf([&] { curvatures->Update(); });
  }
  return times;
}

// Sines without memory: what the machine itself gains from another thread, which is nothing if
// something else keeps its cores busy. For large meshes not as many as points: a host may take
// memory back in so long a pause, and the next filter would wait for it.
Times TimesOfArithmetic(vtkPolyData* input)
{
  const vtkIdType count = std::min<vtkIdType>(input->GetNumberOfPoints(), 200000);
  const auto work = [](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      auto x = static_cast<double>(i);
      for (int repetition = 0; repetition < 20; ++repetition)
      {
        x = 1.0 + std::sin(x);
      }
      benchmark::DoNotOptimize(x);
    }
  };
  return TimesOf([&] { vtkSMPTools::For(0, count, work); });
}

struct Stage
{
  const char* name;
  std::function<Times(StageInputs&)> ours;
  // The second argument is run now and then in between.
  std::function<Times(CGALPipeline&, const std::function<void()>&)> cgal;
  std::function<Times(StageInputs&)> vtk;
};

std::vector<Stage> Stages()
{
  vtkNew<vtkUmbilicDetection> defaults;
  const double patchSize = defaults->GetPatchSize();
  using Between = const std::function<void()>&;
  const auto cgalFit = [](CGALPipeline& cgal, Between between) { return cgal.Fit(between); };
  const auto cgalUmbilics = [patchSize](CGALPipeline& cgal, Between between)
  {
    between();
    return TimesOf([&] { cgal.DetectUmbilics(patchSize); });
  };
  const auto cgalRidges = [](CGALPipeline& cgal, Between between)
  {
    between();
    return TimesOf([&] { cgal.ExtractRidges(); });
  };
  const auto cgalPipeline = [=](CGALPipeline& cgal, Between between)
  { return cgalFit(cgal, between) + cgalUmbilics(cgal, between) + cgalRidges(cgal, between); };
  return {
    { "Fit", [](StageInputs& in) { return TimesOfFit(in.Mesh()); }, cgalFit,
      [](StageInputs& in) { return TimesOfCurvatures(in.Mesh()); } },
    { "Umbilics", [](StageInputs& in) { return TimesOfFilter<vtkUmbilicDetection>(in.Fitted()); },
      cgalUmbilics, nullptr },
    { "Ridges", [](StageInputs& in) { return TimesOfFilter<vtkRidgeExtraction>(in.Marked()); },
      cgalRidges, nullptr },
    { "Pipeline", [](StageInputs& in) { return TimesOfPipeline(in.Mesh()); }, cgalPipeline,
      nullptr },
  };
}

// One iteration times all peers in turn; counters are the minima over the iterations.
void Measure(
  benchmark::State& state, const std::string& mesh, const Stage& stage, StageInputs& inputs)
{
  if (!inputs.Mesh())
  {
    state.SkipWithError("The mesh cannot be read.");
    return;
  }
  const auto points = static_cast<double>(inputs.Mesh()->GetNumberOfPoints());
  CGALPipeline* cgal = inputs.CGAL();
  stage.ours(inputs); // makes inputs, warms up
  const int repetitions = std::clamp(static_cast<int>(2e5 / points), 1, 20);
  Minimum one;
  Minimum two;
  Minimum theirs;
  Minimum vtk;
  Minimum oneOfArithmetic;
  Minimum twoOfArithmetic;
  // Twice in a row: the first finds memory and caches as another number of threads left them.
  const auto timeWith = [&](int threads, Minimum& ours, Minimum& arithmetic)
  {
    vtkSMPTools::Initialize(threads);
    ours.Take(stage.ours(inputs));
    ours.Take(stage.ours(inputs));
    arithmetic.Take(TimesOfArithmetic(inputs.Mesh()));
  };
  const auto timeOurs = [&]
  {
    timeWith(1, one, oneOfArithmetic);
    timeWith(2, two, twoOfArithmetic);
  };
  for (auto iteration : state)
  {
    for (int i = 0; i < repetitions; ++i)
    {
      timeOurs();
    }
    if (cgal)
    {
      theirs.Take(stage.cgal(*cgal, timeOurs));
    }
    if (stage.vtk)
    {
      vtk.Take(stage.vtk(inputs));
    }
    state.SetIterationTime(one.Get().wall);
  }
  const auto microseconds = [points](double seconds) { return 1e6 * seconds / points; };
  StageRow row;
  row.stage = stage.name;
  row.mesh = mesh;
  row.points = points;
  row.oneThread = microseconds(one.Get().thread);
  row.speedUp = one.Get().wall / two.Get().wall;
  row.twoThreads = microseconds(two.Get().wall);
  row.arithmeticSpeedUp = oneOfArithmetic.Get().wall / twoOfArithmetic.Get().wall;
  state.counters["points/s"] = 1e6 / row.oneThread;
  state.counters["us/point"] = row.oneThread;
  state.counters["us/point,2thr"] = row.twoThreads;
  state.counters["speedup"] = row.speedUp;
  if (cgal)
  {
    row.cgal = microseconds(theirs.Get().thread);
    state.counters["CGAL"] = row.cgal;
    state.counters["CGAL/ours"] = row.cgal / row.oneThread;
  }
  if (stage.vtk)
  {
    row.vtk = microseconds(vtk.Get().thread);
    state.counters["vtkCurvatures"] = row.vtk;
  }
  StageTable().push_back(row);
}

} // namespace

void RegisterFilters()
{
  const auto add =
    [](const std::string& mesh, std::function<vtkSmartPointer<vtkPolyData>()> make, bool withCGAL)
  {
    // The last stage of a mesh frees it: the large ones need not all be there at once.
    const auto inputs = std::make_shared<StageInputs>(std::move(make), withCGAL);
    const std::vector<Stage> stages = Stages();
    for (std::size_t i = 0; i < stages.size(); ++i)
    {
      const Stage& stage = stages[i];
      const bool last = i + 1 == stages.size();
      benchmark::RegisterBenchmark((std::string(stage.name) + "/" + mesh).c_str(),
        [=](benchmark::State& state)
        {
          Measure(state, mesh, stage, *inputs);
          if (last)
          {
            inputs->Release();
          }
        })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond)
        ->Iterations(withCGAL ? 5 : 3);
    }
  };
  const std::pair<const char*, int> ellipsoids[] = { { "ellipsoid 10k", 32 },
    { "ellipsoid 40k", 63 }, { "ellipsoid 160k", 126 }, { "ellipsoid 640k", 253 },
    { "ellipsoid 2.6M", 510 } };
  for (const auto& ellipsoid : ellipsoids)
  {
    const int frequency = ellipsoid.second;
    add(
      ellipsoid.first, [=] { return EllipsoidMesh(frequency); }, frequency <= 63);
  }
  // Noise, as scans have it: thousands of umbilics, and ridges everywhere.
  for (const auto& ellipsoid : ellipsoids)
  {
    const std::string size = std::string(ellipsoid.first).substr(10);
    const int frequency = ellipsoid.second;
    for (const auto& [name, noise] : { std::pair<const char*, double>{ "noise0.1%", 0.001 },
           { "noise1%", 0.01 }, { "noise5%", 0.05 } })
    {
      add(
        name + (" " + size),
        [frequency, noise = noise] { return NoisyEllipsoidMesh(frequency, noise); }, false);
    }
  }
  add(
    "bunny 38k", [] { return ReadOff(RIDGES_SCAN); }, true);
}

} // namespace benchmarks
