// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkFilters.h"

#include "BenchmarkMeshes.h"
#include "CGALPipeline.h"
#include "Minimum.h"
#include "Tables.h"

#include "Fit/Batch/JetBatch.h"
#include "Fit/Batch/JetBatchFiller.h"
#include "Mesh/OrderedRings.h"
#include "Mesh/RingNeighborhood.h"

#include "vtkCellArray.h"

#include <benchmark/benchmark.h>

#include <functional>

namespace benchmarks
{

namespace
{

using namespace ridges;

struct CoreMesh
{
  explicit CoreMesh(vtkPolyData* polyData)
    : points(3 * polyData->GetNumberOfPoints())
    , mesh(MakeTriangles(polyData))
    , rings(mesh)
  {
    this->rings.Build(0, this->mesh.NumberOfPoints());
  }

  std::vector<double> points;
  TriangleMesh mesh;
  OrderedRings rings;

private:
  TriangleMesh MakeTriangles(vtkPolyData* polyData)
  {
    for (vtkIdType p = 0; p < polyData->GetNumberOfPoints(); ++p)
    {
      polyData->GetPoint(p, this->points.data() + 3 * p);
    }
    std::vector<Triangle> triangles;
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    vtkCellArray* polys = polyData->GetPolys();
    for (polys->InitTraversal(); polys->GetNextCell(size, corners);)
    {
      triangles.push_back(
        { static_cast<Id>(corners[0]), static_cast<Id>(corners[1]), static_cast<Id>(corners[2]) });
    }
    return TriangleMesh(this->points.data(), static_cast<Id>(polyData->GetNumberOfPoints()),
      triangles, TriangleMesh::Edges::NotBuilt);
  }
};

enum class UpTo
{
  Gather,
  Fill,
  Fit
};

// What vtkJetFitting does with the points, one thread; `forms` takes what comes out.
template <UpTo Last>
void Run(const CoreMesh& core, const JetBatchKernel& kernel, std::vector<MongeForm>& forms)
{
  RingNeighborhood neighborhood(core.mesh, core.rings);
  JetBatchFiller batches(core.mesh, core.rings, 4);
  // A kernel that leaves the batch as it is.
  const JetBatchKernel none{ "", kernel.lanes,
    [](JetBatch& batch) { benchmark::DoNotOptimize(batch.rows); } };
  const Id count = core.mesh.NumberOfPoints();
  for (Id p = 0; p < count; ++p)
  {
    const Span<Id> points = neighborhood.Gather(p, {});
    if (Last == UpTo::Gather)
    {
      benchmark::DoNotOptimize(points.size());
      continue;
    }
    batches.Add(p, points);
    if (batches.IsFull() || p + 1 == count)
    {
      batches.Fit(Last == UpTo::Fit ? kernel : none,
        [&](const JetBatch& batch, Span<Id> vertices)
        {
          for (int lane = 0; Last == UpTo::Fit && lane < vertices.size(); ++lane)
          {
            TakeResult(batch, kernel.lanes, lane, forms[vertices[lane]]);
          }
        });
    }
  }
}

void Measure(benchmark::State& state, const std::string& name, vtkPolyData* input)
{
  if (!input)
  {
    state.SkipWithError("The mesh cannot be read.");
    return;
  }
  const CoreMesh core(input);
  CGALPipeline cgal(input);
  const auto points = static_cast<double>(core.mesh.NumberOfPoints());
  std::vector<MongeForm> forms(core.mesh.NumberOfPoints());
  struct Phases
  {
    Minimum gather, fill, fit;
  };
  const std::vector<JetBatchKernel>& kernels = JetBatchKernels();
  std::vector<Phases> ours(kernels.size());
  Minimum theirs;
  const auto timeOurs = [&]
  {
    for (std::size_t k = 0; k < kernels.size(); ++k)
    {
      ours[k].gather.Time([&] { Run<UpTo::Gather>(core, kernels[k], forms); });
      ours[k].fill.Time([&] { Run<UpTo::Fill>(core, kernels[k], forms); });
      ours[k].fit.Time([&] { Run<UpTo::Fit>(core, kernels[k], forms); });
    }
  };
  for (auto iteration : state)
  {
    theirs.Take(cgal.Fit(timeOurs));
    state.SetIterationTime(ours.empty() ? theirs.Get().wall : ours.front().fit.Get().wall);
  }
  const auto microseconds = [points](const Minimum& minimum)
  { return 1e6 * minimum.Get().thread / points; };
  for (std::size_t k = 0; k < kernels.size(); ++k)
  {
    KernelRow row;
    row.kernel = kernels[k].name;
    row.mesh = name;
    row.gather = microseconds(ours[k].gather);
    row.fill = microseconds(ours[k].fill) - row.gather;
    row.fit = microseconds(ours[k].fit) - row.gather - row.fill;
    row.cgal = microseconds(theirs);
    KernelTable().push_back(row);
    state.counters[row.kernel] = microseconds(ours[k].fit);
    state.counters["CGAL/" + row.kernel] = row.cgal / microseconds(ours[k].fit);
  }
  state.counters["CGAL"] = microseconds(theirs);
}

} // namespace

void RegisterKernels()
{
  const auto add =
    [](const std::string& name, const std::function<vtkSmartPointer<vtkPolyData>()>& make)
  {
    benchmark::RegisterBenchmark(
      ("Kernels/" + name).c_str(), [=](benchmark::State& state) { Measure(state, name, make()); })
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(5);
  };
  add("ellipsoid 40k", [] { return EllipsoidMesh(63); });
  add("bunny 38k", [] { return ReadOff(RIDGES_SCAN); });
}

} // namespace benchmarks
