// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RankPipeline.h"

#include "Pipeline.h"
#include "Reading/MeshReader.h"
#include "Reading/PiecesReader.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRidgesArrayNames.h"
#include "vtkStringArray.h"
#include "vtkXMLDataElement.h"

#ifdef RIDGES_HAVE_MPI
#include "vtkPRidgesAndUmbilics.h"
#endif

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace program
{

void SetProperties(Filters& filters, vtkRidgesAndUmbilics* all)
{
  vtkJetFitting* jets = filters.jetFitting;
  all->SetDegree(jets->GetDegree());
  all->SetNeighborhood(jets->GetNeighborhood());
  all->SetMinimumNumberOfPoints(jets->GetMinimumNumberOfPoints());
  all->SetNumberOfRings(jets->GetNumberOfRings());
  all->SetRadius(jets->GetRadius());
  all->SetWeighting(jets->GetWeighting());
  all->SetBlendNoisyFits(jets->GetBlendNoisyFits());
  all->SetStandardErrors(jets->GetStandardErrors());

  vtkUmbilicDetection* umbilics = filters.umbilics;
  all->SetMethod(umbilics->GetMethod());
  all->SetSignificance(umbilics->GetSignificance());
  all->SetPatchSize(umbilics->GetPatchSize());

  vtkRidgeExtraction* ridges = filters.ridges;
  all->SetTypeRule(ridges->GetTypeRule());
  all->SetCrossingRule(ridges->GetCrossingRule());
  all->SetUmbilicJoining(ridges->GetUmbilicJoining());
  all->SetLoopSignificance(ridges->GetLoopSignificance());
  all->SetZoneSignificance(ridges->GetZoneSignificance());
  all->SetTypeSignificance(ridges->GetTypeSignificance());
  all->SetTypeHysteresis(ridges->GetTypeHysteresis());
  all->SetComputeFoldAngle(ridges->GetComputeFoldAngle());
  all->SetModelSize(ridges->GetModelSize());
  all->SetUmbilicCutOff(ridges->GetUmbilicCutOff());

  vtkRidgeSharpnessFilter* selection = filters.sharpness;
  all->SetMinimumSharpness(selection->GetMinimumSharpness());
  all->SetMinimumStrength(selection->GetMinimumStrength());
  all->SetMinimumLength(selection->GetMinimumLength());
  all->SetKeepMaximumElliptic(selection->GetKeepMaximumElliptic());
  all->SetKeepMaximumHyperbolic(selection->GetKeepMaximumHyperbolic());
  all->SetKeepMinimumElliptic(selection->GetKeepMinimumElliptic());
  all->SetKeepMinimumHyperbolic(selection->GetKeepMinimumHyperbolic());
  all->SetKeepUndecided(selection->GetKeepUndecided());
  all->SetCrestOnly(selection->GetCrestOnly());
  all->SetWholeRidges(selection->GetWholeRidges());
  all->SetMaximumNumber(selection->GetMaximumNumber());
  all->SetRankBy(selection->GetRankBy());
}

void TakeResults(vtkRidgesAndUmbilics* all, Results& results)
{
  results.mesh = all->GetOutput(vtkRidgesAndUmbilics::MESH);
  results.umbilics = all->GetOutput(vtkRidgesAndUmbilics::UMBILICS);
  results.ridges = all->GetOutput(vtkRidgesAndUmbilics::RIDGES);
  results.allRidges = results.ridges;
  auto* fit = vtkStringArray::SafeDownCast(
    results.mesh->GetFieldData()->GetAbstractArray(vtkRidgesArrayNames::SelectedFit));
  results.selectedFit = fit ? fit->GetValue(0) : std::string();
}

#ifdef RIDGES_HAVE_MPI
namespace
{

/// This rank's pieces of a .pvtp, joined where they touch; of any other mesh all is on the first
/// rank.
vtkSmartPointer<vtkPolyData> MakePiece(
  const Options& options, Filters& filters, const Ranks& ranks, Stages& stages, Results& results)
{
  if (!IsOfPieces(options.mesh))
  {
    return ranks.IsFirst() ? MakeMesh(options, filters, stages, results)
                           : vtkSmartPointer<vtkPolyData>::New();
  }
  results.name = options.mesh;
  MeshFile file;
  stages.RunStrictly("read", "check " + options.mesh,
    [&file, &options, &ranks]
    {
      file = ReadPiecesOfRank(options.mesh, ranks.Rank(), ranks.Size());
      RepairMesh(file.mesh, options.repair);
    });
  return file.mesh.ToPolyData();
}

void CheckSize(const std::string& name, vtkPolyData* piece, const Ranks& ranks)
{
  const std::vector<long long> counts = ranks.GatherAll({ piece->GetNumberOfPolys() });
  if (*std::max_element(counts.begin(), counts.end()) == 0)
  {
    throw Failure(name + " has no face with three different corners at finite places",
      "give the mesh of a surface");
  }
}

} // namespace

void RunOnRanks(
  const Options& options, Filters& filters, const Ranks& ranks, Stages& stages, Results& results)
{
  vtkSmartPointer<vtkPolyData> piece;
  ranks.Together([&piece, &options, &filters, &ranks, &stages, &results]
    { piece = MakePiece(options, filters, ranks, stages, results); });
  CheckSize(results.name, piece, ranks);
  if (results.isInsideOut)
  {
    stages.Warn("the surface is inside out: maximum and minimum change places", "add --orient");
  }
  filters.onRanks = vtkSmartPointer<vtkPRidgesAndUmbilics>::New();
  vtkRidgesAndUmbilics* all = filters.onRanks;
  SetProperties(filters, all);
  all->SetInputData(piece);
  stages.Run("ridges", "see the options in vtkridges --help-all", all, [all] { all->Update(); });

  TakeResults(all, results);
  results.lineChoice =
    "all ridges, as always on several ranks (" + std::to_string(ranks.Size()) + " here)";
}

#else

void RunOnRanks(const Options&, Filters&, const Ranks&, Stages&, Results&) {}

#endif

std::string NameOfPiece(const std::string& fileName, int rank)
{
  const std::filesystem::path path(fileName);
  return (path.parent_path() / (path.stem().string() + "-" + std::to_string(rank) + ".vtp"))
    .string();
}

namespace
{

/// As VTK's XML files name it.
std::string TypeOf(vtkDataArray* array)
{
  const int type = array->GetDataType();
  const bool isFloat = type == VTK_FLOAT || type == VTK_DOUBLE;
  const bool isUnsigned = array->GetDataTypeMin() >= 0.0;
  return (isFloat ? "Float" : (isUnsigned ? "UInt" : "Int")) +
    std::to_string(8 * array->GetDataTypeSize());
}

void AddArray(vtkXMLDataElement* parent, vtkDataArray* array)
{
  vtkNew<vtkXMLDataElement> element;
  element->SetName("PDataArray");
  element->SetAttribute("type", TypeOf(array).c_str());
  element->SetAttribute("Name", array->GetName());
  element->SetIntAttribute("NumberOfComponents", array->GetNumberOfComponents());
  parent->AddNestedElement(element);
}

void AddArrays(vtkXMLDataElement* parent, const char* name, vtkFieldData* data)
{
  vtkNew<vtkXMLDataElement> element;
  element->SetName(name);
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (array && array->GetName())
    {
      AddArray(element, array);
    }
  }
  parent->AddNestedElement(element);
}

} // namespace

std::string TextOfPieces(vtkPolyData* piece, const std::string& fileName, int ranks)
{
  vtkNew<vtkXMLDataElement> mesh;
  mesh->SetName("PPolyData");
  mesh->SetIntAttribute("GhostLevel", 0);
  AddArrays(mesh, "PPointData", piece->GetPointData());
  AddArrays(mesh, "PCellData", piece->GetCellData());
  vtkNew<vtkXMLDataElement> points;
  points->SetName("PPoints");
  vtkNew<vtkPoints> ofEmpty;
  vtkPoints* positions = piece->GetPoints() ? piece->GetPoints() : ofEmpty.GetPointer();
  AddArray(points, positions->GetData());
  mesh->AddNestedElement(points);
  for (int rank = 0; rank < ranks; ++rank)
  {
    vtkNew<vtkXMLDataElement> element;
    element->SetName("Piece");
    const std::filesystem::path name(NameOfPiece(fileName, rank));
    element->SetAttribute("Source", name.filename().string().c_str());
    mesh->AddNestedElement(element);
  }
  vtkNew<vtkXMLDataElement> root;
  root->SetName("VTKFile");
  root->SetAttribute("type", "PPolyData");
  root->SetAttribute("version", "0.1");
  root->AddNestedElement(mesh);
  std::ostringstream text;
  text << "<?xml version=\"1.0\"?>\n";
  root->PrintXML(text, vtkIndent());
  return text.str();
}

} // namespace program
