// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PiecePipeline.h"

#ifdef RIDGES_HAVE_MPI

#include "RankPipeline.h"
#include "Reading/MeshReader.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPRidgesAndUmbilics.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <exception>
#include <string>

namespace program
{
namespace
{

/// Reads any part of a .pvtp that it is asked for, and keeps none.
class PieceSource : public vtkPolyDataAlgorithm
{
public:
  static PieceSource* New() { VTK_STANDARD_NEW_BODY(PieceSource); }

  std::string name;
  RepairOptions repair;
  PieceCounts counts;
  std::exception_ptr failure;

protected:
  PieceSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    outputVector->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
    return 1;
  }

  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkInformation* info = outputVector->GetInformationObject(0);
    try
    {
      MeshFile file = ReadPiecesOfRank(this->name, info->Get(Pipeline::UPDATE_PIECE_NUMBER()),
        info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
      RepairMesh(file.mesh, this->repair);
      const auto piece = file.mesh.ToPolyData();
      this->counts.Add(piece);
      vtkPolyData::GetData(outputVector)->ShallowCopy(piece);
    }
    catch (const Failure&)
    {
      // VTK's pipeline is not made for exceptions.
      this->failure = std::current_exception();
      return 0;
    }
    return 1;
  }
};

} // namespace

void RunInPieces(const Options& options, Filters& filters, Stages& stages, Results& results)
{
  vtkNew<PieceSource> source;
  source->name = options.mesh;
  source->repair = options.repair;
  const auto all = vtkSmartPointer<vtkPRidgesAndUmbilics>::New();
  filters.onRanks = all;
  SetProperties(filters, all);
  all->SetNumberOfPieces(options.pieces);
  all->SetInputConnection(source->GetOutputPort());
  const auto update = [&all, &source]
  {
    all->Update();
    if (source->failure)
    {
      std::rethrow_exception(source->failure);
    }
  };
  stages.Run("ridges", "see the options in vtkridges --help-all", all, update);

  results.name = options.mesh;
  results.counts = source->counts.Counts();
  if (results.counts->triangles == 0)
  {
    throw Failure(results.name + " has no face with three different corners at finite places",
      "give the mesh of a surface");
  }
  TakeResults(all, results);
  results.lineChoice =
    "all ridges, as always in pieces (" + std::to_string(options.pieces) + " here)";
}

} // namespace program

#else

namespace program
{

void RunInPieces(const Options&, Filters&, Stages&, Results&)
{
  throw Failure("--pieces does not work: this program was built without MPI", "leave it out");
}

} // namespace program

#endif
