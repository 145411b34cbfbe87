// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Time and memory of each rank on an ellipsoid in pieces of one size: see rank_cost.sh.
//
//   mpirun -np RANKS RidgesRankCost jets|ridges FREQUENCY NOISE
//
// Noise is in edges. A row of the table: what all ranks together take, outside of MPI and in it,
// where they mostly wait for each other, and the peak memory of the first rank, and of the others,
// beyond what they have at first.

#include "ProcessUse.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkMPIController.h"
#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPJetFitting.h"
#include "vtkPRidgesAndUmbilics.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRidgeExampleSource.h"
#include "vtkSmartPointer.h"

#include <mpi.h>

#include <malloc.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace ridges::testing;

namespace
{

double SecondsInMpi = 0.0;

/// Adds what a call of MPI takes.
template <typename Call>
int Timed(const Call& call)
{
  const double before = ProcessorSeconds();
  const int result = call();
  SecondsInMpi += ProcessorSeconds() - before;
  return result;
}

} // namespace

// What VTK calls, in place of MPI's own, which have a second name for that.
extern "C"
{
  int MPI_Send(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm)
  {
    return Timed([&] { return PMPI_Send(data, count, type, to, tag, comm); });
  }

  int MPI_Recv(
    void* data, int count, MPI_Datatype type, int from, int tag, MPI_Comm comm, MPI_Status* status)
  {
    return Timed([&] { return PMPI_Recv(data, count, type, from, tag, comm, status); });
  }

  int MPI_Allgather(const void* data, int count, MPI_Datatype type, void* all, int countOfEach,
    MPI_Datatype typeOfAll, MPI_Comm comm)
  {
    return Timed(
      [&] { return PMPI_Allgather(data, count, type, all, countOfEach, typeOfAll, comm); });
  }

  int MPI_Allgatherv(const void* data, int count, MPI_Datatype type, void* all, const int counts[],
    const int offsets[], MPI_Datatype typeOfAll, MPI_Comm comm)
  {
    return Timed(
      [&] { return PMPI_Allgatherv(data, count, type, all, counts, offsets, typeOfAll, comm); });
  }

  int MPI_Allreduce(
    const void* data, void* result, int count, MPI_Datatype type, MPI_Op operation, MPI_Comm comm)
  {
    return Timed([&] { return PMPI_Allreduce(data, result, count, type, operation, comm); });
  }
}

namespace
{

/// Points moved along x, y and z by noise of this standard deviation, each by itself.
void AddNoise(vtkPoints* points, double deviation)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(1);
  const auto uniform = [&random]
  {
    random->Next();
    return random->GetValue();
  };
  for (vtkIdType p = 0; p < points->GetNumberOfPoints(); ++p)
  {
    std::array<double, 3> x;
    points->GetPoint(p, x.data());
    for (double& coordinate : x)
    {
      const double length = std::sqrt(-2.0 * std::log(uniform()));
      coordinate += deviation * length * std::cos(2.0 * vtkMath::Pi() * uniform());
    }
    points->SetPoint(p, x.data());
  }
}

/// The triangles of a rank: as they are numbered.
vtkSmartPointer<vtkPolyData> PieceOf(int frequency, double noise, int rank, int ranks)
{
  vtkNew<vtkRidgeExampleSource> source;
  source->SetSurfaceToEllipsoid();
  source->SetFrequency(frequency);
  source->Update();
  vtkPolyData* mesh = source->GetOutput();
  vtkNew<vtkIdList> corners;
  mesh->GetPolys()->GetCellAtId(0, corners);
  std::array<double, 3> x;
  std::array<double, 3> y;
  mesh->GetPoint(corners->GetId(0), x.data());
  mesh->GetPoint(corners->GetId(1), y.data());
  if (noise > 0.0)
  {
    AddNoise(
      mesh->GetPoints(), noise * std::sqrt(vtkMath::Distance2BetweenPoints(x.data(), y.data())));
  }
  const vtkIdType count = mesh->GetNumberOfPolys();
  std::vector<vtkIdType> newId(mesh->GetNumberOfPoints(), -1);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  for (vtkIdType t = count * rank / ranks; t < count * (rank + 1) / ranks; ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, corners);
    for (vtkIdType& p : *corners)
    {
      newId[p] = newId[p] < 0 ? points->InsertNextPoint(mesh->GetPoint(p)) : newId[p];
      p = newId[p];
    }
    polys->InsertNextCell(corners);
  }
  points->Squeeze();
  polys->Squeeze();
  auto piece = vtkSmartPointer<vtkPolyData>::New();
  piece->SetPoints(points);
  piece->SetPolys(polys);
  return piece;
}

void Measure(vtkMPIController* controller, const std::string& stage, int frequency, double noise)
{
  const int ranks = controller->GetNumberOfProcesses();
  const auto piece = PieceOf(frequency, noise, controller->GetLocalProcessId(), ranks);
  vtkSmartPointer<vtkPolyDataAlgorithm> filter;
  if (stage == "jets")
  {
    filter = vtkSmartPointer<vtkPJetFitting>::New();
  }
  else
  {
    filter = vtkSmartPointer<vtkPRidgesAndUmbilics>::New();
  }
  filter->SetInputData(piece);
  malloc_trim(0);
  ForgetPeak();
  controller->Barrier();
  const double memoryBefore = ResidentBytes();
  const double before = ProcessorSeconds();
  SecondsInMpi = 0.0;
  filter->Update();
  const std::array<double, 3> own = { ProcessorSeconds() - before - SecondsInMpi, SecondsInMpi,
    (PeakBytes() - memoryBefore) / BytesPerMiB };
  std::vector<double> all(own.size() * ranks);
  controller->AllGather(own.data(), all.data(), static_cast<vtkIdType>(own.size()));
  if (controller->GetLocalProcessId() > 0)
  {
    return;
  }
  double work = 0.0;
  double inMpi = 0.0;
  double least = 1e30;
  double most = 0.0;
  for (int rank = 0; rank < ranks; ++rank)
  {
    work += all[own.size() * rank];
    inMpi += all[own.size() * rank + 1];
    if (rank > 0)
    {
      least = std::min(least, all[own.size() * rank + 2]);
      most = std::max(most, all[own.size() * rank + 2]);
    }
  }
  std::printf("| %s | %d | %g | %d | %.2f | %.2f | %.0f | ", stage.c_str(),
    10 * frequency * frequency + 2, noise, ranks, work, inMpi, own[2]);
  if (ranks > 1)
  {
    std::printf("%.0f-%.0f", least, most);
  }
  std::printf(" |\n");
}

} // namespace

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  if (argc == 4)
  {
    Measure(controller, argv[1], std::atoi(argv[2]), std::atof(argv[3]));
  }
  else
  {
    std::fputs("see the source for the arguments\n", stderr);
  }
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return argc == 4 ? EXIT_SUCCESS : EXIT_FAILURE;
}
