// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The program vtkridges: a mesh in, its ridges and umbilics out, as files and as a picture.
 */

#include "CheckTable.h"
#include "Console.h"
#include "MeshReader.h"
#include "Options.h"
#include "Picture.h"
#include "Report.h"

#include "vtkPNGWriter.h"
#include "vtkSMPTools.h"
#include "vtkXMLPolyDataWriter.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>

namespace
{

using namespace program;
namespace fs = std::filesystem;

struct OutputFiles
{
  explicit OutputFiles(const std::string& prefix)
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
  const OutputFiles files(options.output);
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
    const bool existed = fs::exists(name, error);
    if (fs::is_directory(name, error) || !std::ofstream(name, std::ios::app))
    {
      throw Failure(name + " cannot be written", "check the permissions, or change --output");
    }
    if (!existed)
    {
      fs::remove(name, error);
    }
  }
}

/// Encoded, as ParaView 5.11 with a recent Expat cannot read what is appended raw, the default.
vtkNew<vtkXMLPolyDataWriter> MakeDataWriter()
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetDataModeToBinary();
  return writer;
}

template <typename Writer>
void WriteBy(Writer* writer, vtkDataObject* data, const std::string& name)
{
  writer->SetFileName(name.c_str());
  writer->SetInputDataObject(data);
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    throw Failure(name + " cannot be written", "check the disk and the permissions");
  }
}

ExitCode Run(const Options& options, Filters& filters)
{
  const OutputFiles files(options.output);
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
  if (options.mesh.empty())
  {
    stages.Run("read", seeHelp, filters.example, [&] { filters.example->Update(); });
    filters.jetFitting->SetInputConnection(filters.example->GetOutputPort());
  }
  else
  {
    stages.Run("read", "check " + options.mesh, nullptr,
      [&] { mesh = Mend(ReadMesh(options.mesh), options.meshMending); });
    if (mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
    {
      throw Failure(options.mesh + " has no triangles", "give the mesh of a surface");
    }
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
    options.check ? filters.coherence->GetOutput() : nullptr };

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
    [&]
    {
      WriteBy(MakeDataWriter().Get(), results.ridges, files.ridges);
      WriteBy(MakeDataWriter().Get(), results.umbilics, files.umbilics);
      if (options.writeMesh)
      {
        WriteBy(MakeDataWriter().Get(), results.mesh, files.mesh);
      }
      if (picture)
      {
        vtkNew<vtkPNGWriter> writer;
        writer->SetCompressionLevel(9);
        WriteBy(writer.Get(), picture, files.picture);
      }
    });
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
