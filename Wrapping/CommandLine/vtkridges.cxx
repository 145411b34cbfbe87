// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The program vtkridges: a mesh in, its ridges and umbilics out, as files and as a picture.
 */

#include "CheckTable.h"
#include "Console.h"
#include "Options.h"
#include "OutputFiles.h"
#include "Picture.h"
#include "Reading/MeshReader.h"
#include "Repair/CoordinateGrain.h"
#include "Repair/RepairMesh.h"
#include "Report.h"

#include "vtkPNGWriter.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLPolyDataWriter.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>

namespace
{

using namespace program;
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

void WarnOfRepair(const MeshFile& file, const RepairReport& report, const Stages& stages)
{
  const auto count = [](std::size_t number, const char* one, const char* more)
  { return std::to_string(number) + " " + (number == 1 ? one : more); };
  const InvalidFaces& removed = report.removed;
  if (removed.collapsed > 0)
  {
    stages.Warn(count(removed.collapsed, "face has", "faces have") +
        " fewer than three different corners and are left out",
      "check the mesh");
  }
  if (removed.notFinite > 0)
  {
    stages.Warn(count(removed.notFinite, "face has a corner", "faces have corners") +
        " whose coordinates are not finite, and are left out",
      "check the mesh");
  }
  const std::size_t odd = report.orientation.oddEdges;
  if (odd > 0)
  {
    stages.Warn("the surface cannot be oriented, as it is one-sided like a Moebius strip: the "
                "faces at " +
        count(odd, "edge", "edges") + " keep opposite orientations",
      "cut it there");
  }
  const std::string grain = WarnOfGrain(file.mesh);
  if (!grain.empty())
  {
    stages.Warn(grain,
      "store the coordinates in double precision, or nearer to the origin; --neighborhood "
      "automatic "
      "reduces the effect");
  }
}

vtkSmartPointer<vtkPolyData> ReadAndRepair(
  const Options& options, Stages& stages, std::size_t& joinedPoints)
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
    });
  WarnOfRepair(file, report, stages);
  // In STL all are: that says nothing.
  joinedPoints = file.hasNeighbours ? report.joinedPoints : 0;
  return file.data && !report.HasChanged() ? file.data : file.mesh.ToPolyData();
}

ExitCode Run(const Options& options, Filters& filters)
{
  CheckOutput(options);
  if (!options.noPicture)
  {
    CheckDisplay();
  }
  if (options.threads > 0)
  {
    vtkSMPTools::Initialize(options.threads);
  }

  Stages stages(options.quiet);
  const std::string seeHelp = "see --monge-order and the options of this stage in vtkridges --help";
  const std::string seeFitting = "see --merge, --orient and Jet fitting in vtkridges --help";
  vtkSmartPointer<vtkPolyData> mesh;
  std::size_t joinedPoints = 0;
  if (options.mesh.empty())
  {
    stages.Run("read", seeHelp, filters.example, [&] { filters.example->Update(); });
    filters.jetFitting->SetInputConnection(filters.example->GetOutputPort());
  }
  else
  {
    mesh = ReadAndRepair(options, stages, joinedPoints);
    filters.jetFitting->SetInputData(mesh);
  }
  filters.umbilics->SetInputConnection(filters.jetFitting->GetOutputPort());
  filters.ridges->SetInputConnection(filters.umbilics->GetOutputPort());
  filters.sharpness->SetInputConnection(filters.ridges->GetOutputPort());
  const std::pair<const char*, vtkAlgorithm*> pipeline[] = {
    { "jet fitting", filters.jetFitting },
    { "umbilics", filters.umbilics },
    { "ridges", filters.ridges },
    { "filter", filters.sharpness },
  };
  for (const auto& [name, algorithm] : pipeline)
  {
    const std::string& advice = algorithm == filters.jetFitting.Get() ? seeFitting : seeHelp;
    stages.Run(name, advice, algorithm, [algorithm = algorithm] { algorithm->Update(); });
  }
  if (options.check)
  {
    filters.coherence->SetInputConnection(0, filters.umbilics->GetOutputPort(0));
    filters.coherence->SetInputConnection(1, filters.ridges->GetOutputPort());
    filters.coherence->SetInputConnection(2, filters.umbilics->GetOutputPort(1));
    stages.Run("checks", seeHelp, filters.coherence, [&] { filters.coherence->Update(); });
  }
  const Results results{ options.mesh.empty() ? "example" : options.mesh,
    filters.umbilics->GetOutput(), vtkPolyData::SafeDownCast(filters.umbilics->GetOutput(1)),
    filters.ridges->GetOutput(), filters.sharpness->GetOutput(),
    options.check ? filters.coherence->GetOutput() : nullptr, joinedPoints };

  vtkSmartPointer<vtkImageData> picture;
  if (!options.noPicture)
  {
    stages.Run("picture", "add --no-picture", nullptr,
      [&]
      {
        PictureOptions pictureOptions = options.picture;
        if (options.mesh.empty() && !pictureOptions.view &&
          filters.example->GetSurface() == vtkRidgeExampleSource::BLEND)
        {
          // Where both parts of the blend and the valley between them are seen.
          pictureOptions.view = { 1.0, -1.0, 0.4 };
        }
        picture = DrawPicture(results.mesh, results.ridges, results.umbilics, pictureOptions);
      });
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

int main(int argc, char* argv[])
{
#ifdef SIGXFSZ
  // A file that grows beyond a limit is an error of the file, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
#endif
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
