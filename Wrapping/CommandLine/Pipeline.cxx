// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline.h"

#include "Reading/ImageReader.h"
#include "Reading/MeshReader.h"
#include "Repair/CoordinateGrain.h"
#include "Repair/RepairMesh.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <iomanip>
#include <sstream>

namespace program
{
namespace
{

std::string Count(std::size_t number, const char* one, const char* more)
{
  return std::to_string(number) + " " + (number == 1 ? one : more);
}

void WarnOfRepair(const MeshFile& file, const RepairReport& report, Stages& stages)
{
  const InvalidFaces& removed = report.removed;
  if (removed.collapsed > 0)
  {
    stages.Warn(Count(removed.collapsed, "face has", "faces have") +
        " fewer than three different corners and are left out",
      "check the mesh");
  }
  if (removed.notFinite > 0)
  {
    stages.Warn(Count(removed.notFinite, "face has a corner", "faces have corners") +
        " whose coordinates are not finite, and are left out",
      "check the mesh");
  }
  const GrainWarning grain = WarnOfGrain(file.mesh);
  if (!grain.text.empty())
  {
    stages.Warn(grain.text, grain.advice);
  }
}

/// The mesh of the file as the filters get it.
vtkSmartPointer<vtkPolyData> ReadAndRepair(const Options& options, Stages& stages, Results& results)
{
  MeshFile file;
  RepairReport report;
  stages.RunStrictly("read", "check " + options.mesh,
    [&file, &report, &options]
    {
      file = ReadMesh(options.mesh);
      RepairOptions repair = options.repair;
      const bool isSoup = !file.hasNeighbours && repair.joining == Joining::Borders;
      repair.joining = isSoup ? Joining::All : repair.joining;
      report = RepairMesh(file.mesh, repair);
      if (file.mesh.NumberOfFaces() == 0)
      {
        throw Failure(options.mesh + " has no face with three different corners at finite places",
          "give the mesh of a surface");
      }
    });
  WarnOfRepair(file, report, stages);
  // With salient lines their filter looks for itself.
  results.isInsideOut = options.lines != Lines::Salient && IsInsideOut(file.mesh);
  stages.SetHint("vtkPolyDataNormals",
    report.orientation.oddEdges > 0
      ? "the surface is one-sided, as a Moebius strip is: no orientation suits all of it"
      : "add --orient");
  stages.SetHint("vtkStaticCleanPolyData",
    options.repair.joining == Joining::None ? "leave out --no-merge" : "--merge joins them");
  // In STL all points are joined: that says nothing.
  results.joinedPoints = file.hasNeighbours ? report.joinedPoints : 0;
  return file.data && !report.HasChanged() ? file.data : file.mesh.ToPolyData();
}

vtkIdType CountPoints(vtkPolyData* fitted, int status)
{
  vtkDataArray* array = fitted->GetPointData()->GetArray(vtkRidgesArrayNames::FitStatus);
  vtkIdType count = 0;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    count += (static_cast<int>(array->GetTuple1(i)) & status) != 0 ? 1 : 0;
  }
  return count;
}

void RunStage(Stages& stages, const char* name, vtkAlgorithm* filter)
{
  stages.Run(name, "see the options of this stage in vtkridges --help-all", filter,
    [filter] { filter->Update(); });
}

/// Fails if no point has a fit: then there is nothing to find.
void CheckFits(vtkPolyData* fitted)
{
  const vtkIdType points = fitted->GetNumberOfPoints();
  if (points > 0 && CountPoints(fitted, vtkJetFitting::FIT_INVALID) == points)
  {
    throw Failure("no polynomial can be fitted at any of the " + std::to_string(points) +
        " points: they have too few neighbours in " + std::to_string(fitted->GetNumberOfPolys()) +
        " triangles",
      "give a finer mesh, whose triangles share their points");
  }
}

/// What to do about warnings of the fit.
std::string FitAdvice(vtkPolyData* fitted)
{
  const vtkIdType few =
    CountPoints(fitted, vtkJetFitting::FIT_INVALID | vtkJetFitting::FIT_TOO_FEW_POINTS);
  return 2 * few > fitted->GetNumberOfPoints()
    ? "give a finer mesh: " + std::to_string(fitted->GetNumberOfPolys()) + " triangles are too few"
    : "see Jet fitting in vtkridges --help-all";
}

/// The image, for the filters that need it.
void RunImage(const Options& options, Filters& filters, Stages& stages)
{
  vtkSmartPointer<vtkImageData> image;
  stages.RunStrictly("read image", "check " + options.image,
    [&image, &options] { image = ReadImage(options.image); });
  filters.imageMesh->SetInputData(image);
  filters.imageForms->SetInputData(1, image);
}

} // namespace

vtkSmartPointer<vtkPolyData> MakeMesh(
  const Options& options, Filters& filters, Stages& stages, Results& results)
{
  if (!options.mesh.empty())
  {
    results.name = options.mesh;
    return ReadAndRepair(options, stages, results);
  }
  if (!options.image.empty())
  {
    results.name = options.image;
    stages.Run("mesh of the isosurface", "see --isovalue, --sigma and --edge-length",
      filters.imageMesh, [&filters] { filters.imageMesh->Update(); });
    return filters.imageMesh->GetOutput();
  }
  if (options.formula.empty())
  {
    results.name = "example";
    RunStage(stages, "read", filters.example);
    return filters.example->GetOutput();
  }
  results.name = "formula";
  vtkImplicitSurfaceMesh* source = filters.surfaceMesh;
  source->SetFormula(options.formula.c_str());
  stages.Run("mesh of the surface", "see --formula, --bounds and --edge-length", source,
    [source] { source->Update(); });
  return source->GetOutput();
}

namespace
{

/// Forms at the points of the mesh, which move to the surface.
void RunForms(vtkPolyData* mesh, const Options& options, Filters& filters, Stages& stages)
{
  if (!options.image.empty())
  {
    vtkImageMongeForm* forms = filters.imageForms;
    forms->SetInputData(0, mesh);
    stages.Run(
      "forms of the image", "see --isovalue and --sigma", forms, [forms] { forms->Update(); });
    return;
  }
  vtkImplicitMongeForm* forms = filters.exactForms;
  forms->SetInputData(mesh);
  forms->SetFormula(options.formula.c_str());
  stages.Run("exact forms", "see --formula", forms, [forms] { forms->Update(); });
}

/// What the fit or the smoothing of the image chose; empty without either.
std::string FitOf(vtkFieldData* data)
{
  auto* fit =
    vtkStringArray::SafeDownCast(data->GetAbstractArray(vtkRidgesArrayNames::SelectedFit));
  if (fit)
  {
    return fit->GetValue(0);
  }
  vtkDataArray* sigma = data->GetArray(vtkRidgesArrayNames::ImageSigma);
  vtkDataArray* noise = data->GetArray(vtkRidgesArrayNames::ImageNoise);
  if (!sigma || !noise)
  {
    return {};
  }
  std::ostringstream text;
  text << std::setprecision(3) << "the image smoothed by " << sigma->GetComponent(0, 0)
       << ", for noise of " << noise->GetComponent(0, 0) << " in its values";
  return text.str();
}

/// Fits at the points of the mesh.
void RunJetFitting(vtkPolyData* mesh, vtkJetFitting* jetFitting, Stages& stages)
{
  jetFitting->SetInputData(mesh);
  stages.Run(
    "jet fitting", [jetFitting] { return FitAdvice(jetFitting->GetOutput()); }, jetFitting,
    [jetFitting]
    {
      jetFitting->Update();
      CheckFits(jetFitting->GetOutput());
    });
}

/// From the mesh to ridges with a certificate.
void RunCertified(
  vtkPolyData* mesh, const Options& options, Filters& filters, Stages& stages, Results& results)
{
  vtkCertifiedRidges* certified = filters.certified;
  certified->SetInputData(mesh);
  certified->SetFormula(options.formula.c_str());
  stages.Run("certificate", "see the table", certified, [certified] { certified->Update(); });
  filters.sharpness->SetInputConnection(certified->GetOutputPort());
  RunStage(stages, "filter", filters.sharpness);
  results.mesh = certified->GetOutput(vtkCertifiedRidges::MESH);
  results.umbilics = certified->GetOutput(vtkCertifiedRidges::UMBILICS);
  results.allRidges = certified->GetOutput();
  results.ridges = filters.sharpness->GetOutput();
  results.certificate =
    vtkTable::SafeDownCast(certified->GetOutputDataObject(vtkCertifiedRidges::TABLE));
}

/// What gives the mesh its forms.
vtkAlgorithm* FormsOf(const Options& options, Filters& filters)
{
  if (!options.image.empty())
  {
    return filters.imageForms;
  }
  if (!options.formula.empty())
  {
    return filters.exactForms;
  }
  return filters.jetFitting;
}

/// The ridges of all points of the mesh, from its forms on.
void RunComplete(const Options& options, Filters& filters, Stages& stages, Results& results)
{
  filters.umbilics->SetInputConnection(FormsOf(options, filters)->GetOutputPort());
  filters.ridges->SetInputConnection(filters.umbilics->GetOutputPort());
  filters.sharpness->SetInputConnection(filters.ridges->GetOutputPort());
  RunStage(stages, "umbilics", filters.umbilics);
  RunStage(stages, "ridges", filters.ridges);
  RunStage(stages, "filter", filters.sharpness);
  if (options.check)
  {
    filters.coherence->SetInputConnection(0, filters.ridges->GetOutputPort(2));
    filters.coherence->SetInputConnection(1, filters.ridges->GetOutputPort());
    filters.coherence->SetInputConnection(2, filters.umbilics->GetOutputPort(1));
    RunStage(stages, "checks", filters.coherence);
    results.checks = filters.coherence->GetOutput();
  }
  results.mesh = vtkPolyData::SafeDownCast(filters.ridges->GetOutput(2));
  results.selectedFit = FitOf(results.mesh->GetFieldData());
  results.umbilics = vtkPolyData::SafeDownCast(filters.umbilics->GetOutput(1));
  results.allRidges = filters.ridges->GetOutput();
  results.ridges = filters.sharpness->GetOutput();
}

void RunSalient(vtkPolyData* mesh, vtkSalientRidges* salient, Stages& stages, Results& results)
{
  salient->SetInputData(mesh);
  RunStage(stages, "salient lines", salient);
  results.mesh = vtkPolyData::SafeDownCast(salient->GetOutput(vtkSalientRidges::MESH));
  CheckFits(results.mesh);
  results.umbilics = vtkPolyData::SafeDownCast(salient->GetOutput(vtkSalientRidges::UMBILICS));
  results.ridges = salient->GetOutput();
  results.areSalient = true;
  results.allRidges = results.ridges;
}

} // namespace

void RunFilters(const Options& options, Filters& filters, Stages& stages, Results& results)
{
  if (!options.image.empty())
  {
    RunImage(options, filters, stages);
  }
  const vtkSmartPointer<vtkPolyData> mesh = MakeMesh(options, filters, stages, results);
  if (options.certify)
  {
    RunCertified(mesh, options, filters, stages, results);
    return;
  }
  Lines lines = options.lines;
  if (options.HasForms() && lines != Lines::Salient)
  {
    RunForms(mesh, options, filters, stages);
  }
  else if (lines != Lines::Salient)
  {
    if (lines == Lines::ByData)
    {
      stages.HoldWarnings(); // The filter for salient lines fits for itself, and warns itself.
    }
    RunJetFitting(mesh, filters.jetFitting, stages);
  }
  if (lines == Lines::ByData)
  {
    const LineChoice choice = ChooseLines(filters.jetFitting->GetOutput());
    lines = choice.lines;
    results.lineChoice = choice.reason;
    stages.ReleaseWarnings(lines != Lines::Salient);
  }
  if (lines == Lines::Salient)
  {
    RunSalient(mesh, filters.salient, stages, results);
  }
  else
  {
    if (results.isInsideOut) // as vtkSalientRidges warns itself
    {
      stages.Warn("the surface is inside out: maximum and minimum change places", "add --orient");
    }
    RunComplete(options, filters, stages, results);
  }
}

} // namespace program
