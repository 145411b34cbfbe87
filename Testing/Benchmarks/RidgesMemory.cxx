// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// RidgesMemory [FREQUENCY [NOISE]]
//
// The memory that the pipeline needs at its peak, beyond its input and what it leaves in the
// outputs of its three filters, on an ellipsoid of 10 FREQUENCY^2 + 2 points (default 510, which
// gives 2.6 million), moved along its normals by noise of a standard deviation of NOISE edges
// (default 0).

#include "BenchmarkMeshes.h"
#include "ProcessUse.h"

#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkRidgeExtraction.h"
#include "vtkUmbilicDetection.h"

#include <malloc.h>

#include <cstdio>
#include <cstdlib>

using namespace ridges::testing;

namespace
{

double Bytes(vtkPolyData* data)
{
  return 1024.0 * static_cast<double>(data->GetActualMemorySize());
}

// Resident bytes added at the peak, less those that stay in the filter's own output.
template <typename Filter>
double Run(const char* name, Filter* filter, double points)
{
  malloc_trim(0);
  ForgetPeak();
  const double before = ResidentBytes();
  filter->Update();
  const double peak = PeakBytes() - before;
  malloc_trim(0);
  const double kept = ResidentBytes() - before;
  std::printf("| %s | %.0f | %.0f |\n", name, peak / points, kept / points);
  return peak;
}

} // namespace

int main(int argc, char* argv[])
{
  const int frequency = argc > 1 ? std::atoi(argv[1]) : 510;
  const double noise = argc > 2 ? std::strtod(argv[2], nullptr) : 0.0;
  if (frequency < 1 || frequency > 2000 || !(noise >= 0.0))
  {
    std::fprintf(stderr, "%s: FREQUENCY is 1 to 2000, NOISE not negative\n", argv[0]);
    return 2;
  }
  const vtkSmartPointer<vtkPolyData> mesh = noise > 0.0
    ? benchmarks::NoisyEllipsoidMesh(frequency, noise)
    : benchmarks::EllipsoidMesh(frequency);
  const auto points = static_cast<double>(mesh->GetNumberOfPoints());
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(mesh);
  vtkNew<vtkUmbilicDetection> umbilics;
  umbilics->SetInputConnection(jets->GetOutputPort());
  vtkNew<vtkRidgeExtraction> ridges;
  ridges->SetInputConnection(umbilics->GetOutputPort());

  malloc_trim(0);
  const double start = ResidentBytes();
  std::printf("\n| stage, ellipsoid of %.0f points | peak growth, bytes/point | kept |\n"
              "|---|---:|---:|\n",
    points);
  double highest = 0.0;
  const auto run = [&](const char* name, auto* filter)
  {
    const double before = ResidentBytes() - start;
    highest = std::max(highest, before + Run(name, filter, points));
  };
  run("vtkJetFitting", jets.Get());
  run("vtkUmbilicDetection", umbilics.Get());
  run("vtkRidgeExtraction", ridges.Get());

  // Stages pass the mesh and its arrays on by reference, so each counts what it adds.
  const double output = Bytes(umbilics->GetOutput(0)) - Bytes(mesh) +
    Bytes(umbilics->GetOutput(1)) + Bytes(ridges->GetOutput());
  std::printf("\n| input, bytes/point | output | peak of the process beyond both |\n"
              "|---:|---:|---:|\n| %.0f | %.0f | %.0f |\n",
    Bytes(mesh) / points, output / points, (highest - output) / points);
  return 0;
}
