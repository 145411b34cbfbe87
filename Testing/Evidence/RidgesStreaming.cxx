// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Time and memory of a mesh that is fitted piece by piece, and of the whole: see streaming.sh.
//
//   RidgesStreaming write FREQUENCY DIRECTORY      an ellipsoid: mesh.vtp, mesh-8.pvtp,
//   mesh-64.pvtp RidgesStreaming read|jets|ridges FILE PIECES   a row of the table

#include "ProcessUse.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPJetFitting.h"
#include "vtkPRidgesAndUmbilics.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgeExampleSource.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

void WriteData(vtkPolyData* data, const std::string& name)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(name.c_str());
  writer->SetInputData(data);
  writer->SetCompressorTypeToNone();
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  if (writer->Write() == 0)
  {
    std::exit(EXIT_FAILURE);
  }
}

/// Triangles from `begin` on, and their points.
vtkSmartPointer<vtkPolyData> PieceOf(vtkPolyData* mesh, vtkIdType begin, vtkIdType end)
{
  std::vector<vtkIdType> newId(mesh->GetNumberOfPoints(), -1);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = begin; t < end; ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, corners);
    for (vtkIdType& p : *corners)
    {
      newId[p] = newId[p] < 0 ? points->InsertNextPoint(mesh->GetPoint(p)) : newId[p];
      p = newId[p];
    }
    polys->InsertNextCell(corners);
  }
  auto piece = vtkSmartPointer<vtkPolyData>::New();
  piece->SetPoints(points);
  piece->SetPolys(polys);
  return piece;
}

void Write(int frequency, const std::string& directory)
{
  vtkNew<vtkRidgeExampleSource> source;
  source->SetSurfaceToEllipsoid();
  source->SetFrequency(frequency);
  source->Update();
  vtkPolyData* mesh = source->GetOutput();
  WriteData(mesh, directory + "/mesh.vtp");
  for (const int pieces : { 8, 64 })
  {
    const std::string stem = "mesh-" + std::to_string(pieces);
    std::ofstream index(directory + "/" + stem + ".pvtp");
    index << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PPolyData\" version=\"0.1\">\n"
          << "<PPolyData GhostLevel=\"0\">\n"
          << "<PPoints><PDataArray type=\"Float64\" NumberOfComponents=\"3\"/></PPoints>\n";
    for (int piece = 0; piece < pieces; ++piece)
    {
      const std::string name = stem + "-" + std::to_string(piece) + ".vtp";
      const vtkIdType count = mesh->GetNumberOfPolys();
      WriteData(PieceOf(mesh, count * piece / pieces, count * (piece + 1) / pieces),
        directory + "/" + name);
      index << "<Piece Source=\"" << name << "\"/>\n";
    }
    index << "</PPolyData>\n</VTKFile>\n";
  }
}

/// A sum of numbers that depend on the bytes of what belongs together, in any order.
class Digest
{
public:
  void Begin() { this->One = 14695981039346656037U; }
  void Add(const void* bytes, std::size_t size)
  {
    const auto* first = static_cast<const unsigned char*>(bytes);
    for (std::size_t i = 0; i < size; ++i)
    {
      this->One = (this->One ^ first[i]) * 1099511628211U;
    }
  }
  void AddPoint(vtkPolyData* data, vtkIdType p, const std::vector<vtkDataArray*>& arrays)
  {
    this->Add(data->GetPoint(p), 3 * sizeof(double));
    for (vtkDataArray* array : arrays)
    {
      this->Add(array->GetTuple(p), sizeof(double) * array->GetNumberOfComponents());
    }
  }
  void End() { this->Sum += this->One; }

  std::uint64_t Sum = 0;

private:
  std::uint64_t One = 0;
};

/// By the corners of triangles, or the points of lines: each is in one piece.
void AddCells(Digest& digest, vtkPolyData* data, vtkCellArray* cells)
{
  std::vector<vtkDataArray*> arrays;
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetPointData()->GetArray(i);
    const std::string name = array->GetName();
    // Which depend on numbers of points.
    if (name != names::EdgePoint0 && name != names::EdgePoint1 && name != names::EdgeParameter)
    {
      arrays.push_back(array);
    }
  }
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    digest.Begin();
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      digest.AddPoint(data, ids[i], arrays);
    }
    digest.End();
  }
}

/// The pieces of a .pvtp as Write makes it. vtkXMLPPolyDataReader keeps all that it has read.
class PieceFiles : public vtkPolyDataAlgorithm
{
public:
  static PieceFiles* New() { VTK_STANDARD_NEW_BODY(PieceFiles); }

  std::string stem;

protected:
  PieceFiles() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    outputVector->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
    return 1;
  }

  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    const int piece = outputVector->GetInformationObject(0)->Get(
      vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName((this->stem + "-" + std::to_string(piece) + ".vtp").c_str());
    reader->Update();
    vtkPolyData::GetData(outputVector)->ShallowCopy(reader->GetOutput());
    return 1;
  }
};

void Measure(const std::string& stage, const std::string& file, int pieces)
{
  vtkSmartPointer<vtkAlgorithm> reader;
  if (pieces == 1)
  {
    vtkNew<vtkXMLPolyDataReader> whole;
    whole->SetFileName(file.c_str());
    whole->Update();
    reader = whole;
  }
  else
  {
    vtkNew<PieceFiles> files;
    files->stem = file.substr(0, file.rfind('.'));
    reader = files;
  }
  const double before = ResidentBytes() / BytesPerMiB;
  const double secondsBefore = ProcessorSeconds();
  Digest digest;
  if (stage == "read")
  {
    for (int piece = 0; piece < pieces; ++piece)
    {
      reader->UpdatePiece(piece, pieces, 0);
    }
  }
  else if (stage == "jets")
  {
    vtkNew<vtkPJetFitting> jets;
    jets->SetInputConnection(reader->GetOutputPort());
    for (int piece = 0; piece < pieces; ++piece)
    {
      jets->UpdatePiece(piece, pieces, 0);
      AddCells(digest, jets->GetOutput(), jets->GetOutput()->GetPolys());
    }
  }
  else
  {
    vtkNew<vtkPRidgesAndUmbilics> ridges;
    ridges->SetNumberOfPieces(pieces);
    ridges->SetInputConnection(reader->GetOutputPort());
    ridges->Update();
    AddCells(digest, ridges->GetOutput(), ridges->GetOutput()->GetLines());
  }
  std::printf("| %s | %d | %.1f | %.0f | %.0f | %016llx |\n", stage.c_str(), pieces,
    ProcessorSeconds() - secondsBefore, before, PeakBytes() / BytesPerMiB - before,
    static_cast<unsigned long long>(digest.Sum));
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 4)
  {
    std::fputs("see the source for the arguments\n", stderr);
    return EXIT_FAILURE;
  }
  if (std::string(argv[1]) == "write")
  {
    Write(std::atoi(argv[2]), argv[3]);
  }
  else
  {
    Measure(argv[1], argv[2], std::atoi(argv[3]));
  }
  return EXIT_SUCCESS;
}
