// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include "CheckTable.h"
#include "Console.h"
#include "Options.h"
#include "OutputFiles.h"
#include "Picture.h"
#include "Reading/MeshReader.h"
#include "Repair/CoordinateGrain.h"
#include "Repair/RepairMesh.h"
#include "Report.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <new>

namespace program
{
namespace
{

namespace fs = std::filesystem;

struct FileNames
{
  explicit FileNames(const std::string& prefix)
    : ridges(prefix + "-ridges.vtp")
    , umbilics(prefix + "-umbilics.vtp")
    , mesh(prefix + "-mesh.vtp")
    , picture(prefix + ".png")
  {
  }

  std::string ridges;
  std::string umbilics;
  std::string mesh;
  std::string picture;
};

std::vector<std::string> FilesToWrite(const Options& options)
{
  const FileNames files(options.output);
  std::vector<std::string> list{ files.ridges, files.umbilics };
  if (options.writeMesh)
  {
    list.push_back(files.mesh);
  }
  if (!options.noPicture)
  {
    list.push_back(files.picture);
  }
  return list;
}

/// Fails before the long job if the files cannot be written, without leaving a trace.
void CheckOutput(const Options& options)
{
  std::error_code error;
  const fs::path directory = fs::path(options.output).parent_path();
  if (!directory.empty() && !fs::is_directory(directory, error))
  {
    throw Failure("there is no directory " + directory.string(), "make it, or change --output");
  }
  for (const std::string& name : FilesToWrite(options))
  {
    if (!options.mesh.empty() && fs::equivalent(name, options.mesh, error))
    {
      throw Failure(name + " would overwrite the mesh", "change --output");
    }
    CheckWritable(name);
  }
}

/// Through a string: VTK's writer crashes on a full disk.
void AddData(OutputFiles& files, vtkPolyData* data, const std::string& name)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  // Encoded, as ParaView 5.11 with a recent Expat cannot read what is appended raw, the default.
  writer->SetDataModeToBinary();
  writer->WriteToOutputStringOn();
  writer->SetInputDataObject(data);
  writer->Write();
  const std::string bytes = writer->GetOutputString();
  files.Add(name, bytes.data(), bytes.size());
}

void AddPicture(OutputFiles& files, vtkImageData* picture, const std::string& name)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetCompressionLevel(9);
  writer->WriteToMemoryOn();
  writer->SetInputData(picture);
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  files.Add(name, reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetNumberOfValues()));
}

void WriteFiles(const Options& options, const Results& results, vtkImageData* picture)
{
  const FileNames names(options.output);
  OutputFiles files;
  AddData(files, results.ridges, names.ridges);
  AddData(files, results.umbilics, names.umbilics);
  if (options.writeMesh)
  {
    AddData(files, results.mesh, names.mesh);
  }
  if (picture)
  {
    AddPicture(files, picture, names.picture);
  }
  files.Complete();
}

std::string Count(std::size_t number, const char* one, const char* more)
{
  return std::to_string(number) + " " + (number == 1 ? one : more);
}

void WarnOfRepair(const MeshFile& file, const RepairReport& report, const Stages& stages)
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

/// Runs the filters one after the other, from the mesh to the ridges that are kept.
void RunFilters(const Options& options, Filters& filters, Stages& stages, Results& results)
{
  const std::string seeHelp = "see the options of this stage in vtkridges --help-all";
  const auto run = [&stages, &seeHelp](const char* name, vtkAlgorithm* filter)
  { stages.Run(name, seeHelp, filter, [filter] { filter->Update(); }); };
  if (options.mesh.empty())
  {
    results.name = "example";
    run("read", filters.example);
    filters.jetFitting->SetInputConnection(filters.example->GetOutputPort());
  }
  else
  {
    results.name = options.mesh;
    filters.jetFitting->SetInputData(ReadAndRepair(options, stages, results));
  }
  filters.umbilics->SetInputConnection(filters.jetFitting->GetOutputPort());
  filters.ridges->SetInputConnection(filters.umbilics->GetOutputPort());
  filters.sharpness->SetInputConnection(filters.ridges->GetOutputPort());
  vtkJetFitting* jetFitting = filters.jetFitting;
  stages.Run(
    "jet fitting", [jetFitting] { return FitAdvice(jetFitting->GetOutput()); }, jetFitting,
    [jetFitting]
    {
      jetFitting->Update();
      CheckFits(jetFitting->GetOutput());
    });
  run("umbilics", filters.umbilics);
  run("ridges", filters.ridges);
  run("filter", filters.sharpness);
  if (options.check)
  {
    filters.coherence->SetInputConnection(0, filters.umbilics->GetOutputPort(0));
    filters.coherence->SetInputConnection(1, filters.ridges->GetOutputPort());
    filters.coherence->SetInputConnection(2, filters.umbilics->GetOutputPort(1));
    run("checks", filters.coherence);
    results.checks = filters.coherence->GetOutput();
  }
  results.mesh = filters.umbilics->GetOutput();
  vtkDataArray* rings =
    results.mesh->GetFieldData()->GetArray(vtkRidgesArrayNames::SelectedNumberOfRings);
  results.selectedRings = rings ? static_cast<int>(rings->GetComponent(0, 0)) : 0;
  results.umbilics = vtkPolyData::SafeDownCast(filters.umbilics->GetOutput(1));
  results.allRidges = filters.ridges->GetOutput();
  results.ridges = filters.sharpness->GetOutput();
}

vtkSmartPointer<vtkImageData> Draw(
  const Options& options, const Results& results, vtkRidgeExampleSource* example)
{
  PictureOptions pictureOptions = options.picture;
  if (options.mesh.empty() && !pictureOptions.view &&
    example->GetSurface() == vtkRidgeExampleSource::BLEND)
  {
    // Where both parts of the blend and the valley between them are seen.
    pictureOptions.view = { 1.0, -1.0, 0.4 };
  }
  return DrawPicture(results.mesh, results.ridges, results.umbilics, pictureOptions);
}

/// More threads than processors gain nothing, and some back ends complain.
void SetThreads(int threads)
{
  if (threads > 0)
  {
    vtkSMPTools::Initialize(std::min(threads, vtkSMPTools::GetEstimatedNumberOfThreads()));
  }
}

ExitCode Run(const Options& options, Filters& filters)
{
  CheckOutput(options);
  if (!options.noPicture)
  {
    CheckDisplay();
  }
  SetThreads(options.threads);
  Stages stages(options.quiet);
  Results results;
  RunFilters(options, filters, stages, results);

  vtkSmartPointer<vtkImageData> picture;
  if (!options.noPicture)
  {
    stages.Run("picture", "add --no-picture", nullptr,
      [&picture, &options, &results, &filters]
      { picture = Draw(options, results, filters.example); });
  }
  stages.Run("write", "check the disk and the permissions", nullptr,
    [&options, &results, &picture] { WriteFiles(options, results, picture); });
  if (!options.quiet)
  {
    PrintReport(std::cout, results, stages.GetDurations(), FilesToWrite(options));
  }
  const vtkIdType failed = results.checks ? CountFailedChecks(results.checks) : 0;
  if (options.strict && failed > 0)
  {
    std::cerr << "vtkridges: " << failed << (failed == 1 ? " check" : " checks")
              << " failed : see the table of --check, or leave out --strict\n";
    return ExitCheckFailed;
  }
  return ExitDone;
}

} // namespace

int RunProgram(int argc, char** argv)
{
  Filters filters;
  Options options;
  if (const std::optional<int> exitCode = ParseCommandLine(argc, argv, options, filters))
  {
    return *exitCode;
  }
  try
  {
    return Run(options, filters);
  }
  catch (const Failure& failure)
  {
    std::cerr << "vtkridges: " << failure.what() << "\n";
  }
  catch (const std::bad_alloc&)
  {
    std::cerr << "vtkridges: there is not enough memory : give a smaller mesh\n";
  }
  catch (const std::exception& error)
  {
    std::cerr << "vtkridges: " << error.what() << " : this should not happen, please report it\n";
  }
  return ExitJobFailed;
}

} // namespace program
