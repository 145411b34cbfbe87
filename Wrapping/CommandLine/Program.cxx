// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include "CheckTable.h"
#include "Console.h"
#include "Options.h"
#include "OutputFiles.h"
#include "Picture.h"
#include "PiecePipeline.h"
#include "Pipeline.h"
#include "RankPipeline.h"
#include "Ranks.h"
#include "Reading/PiecesReader.h"
#include "Report.h"

#include "vtkPNGWriter.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
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
  explicit FileNames(const Options& options)
    : ridges(options.output + "-ridges.vtp")
    , umbilics(options.output + "-umbilics.vtp")
    , mesh(options.output + (options.numberOfRanks > 1 ? "-mesh.pvtp" : "-mesh.vtp"))
    , picture(options.output + ".png")
  {
  }

  std::string ridges;
  std::string umbilics;
  std::string mesh;
  std::string picture;
};

std::vector<std::string> FilesToWrite(const Options& options)
{
  const FileNames files(options);
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

bool IsOneOf(const std::string& name, const std::vector<std::string>& others)
{
  std::error_code error;
  return std::any_of(others.begin(), others.end(),
    [&name, &error](const std::string& other) { return fs::equivalent(name, other, error); });
}

/// The same for what each rank writes.
void CheckOutputOfRank(const Options& options, const Ranks& ranks)
{
  if (ranks.IsFirst())
  {
    CheckOutput(options);
  }
  if (ranks.AreSeveral() && options.writeMesh)
  {
    const std::string name = NameOfPiece(FileNames(options).mesh, ranks.Rank());
    if (IsOfPieces(options.mesh) && IsOneOf(name, PiecesOf(options.mesh)))
    {
      throw Failure(name + " would overwrite a piece of the mesh", "change --output");
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

/// The mesh, or a rank's piece of it.
void AddMesh(
  OutputFiles& files, const Results& results, const std::string& name, const Ranks& ranks)
{
  if (!ranks.AreSeveral())
  {
    AddData(files, results.mesh, name);
    return;
  }
  AddData(files, results.mesh, NameOfPiece(name, ranks.Rank()));
  if (ranks.IsFirst())
  {
    const std::string text = TextOfPieces(results.mesh, name, ranks.Size());
    files.Add(name, text.data(), text.size());
  }
}

void WriteFiles(
  const Options& options, const Results& results, vtkImageData* picture, const Ranks& ranks)
{
  const FileNames names(options);
  OutputFiles files;
  ranks.Together(
    [&files, &options, &results, &names, &ranks, picture]
    {
      if (ranks.IsFirst())
      {
        AddData(files, results.ridges, names.ridges);
        AddData(files, results.umbilics, names.umbilics);
      }
      if (options.writeMesh)
      {
        AddMesh(files, results, names.mesh, ranks);
      }
      if (picture)
      {
        AddPicture(files, picture, names.picture);
      }
    });
  ranks.Together([&files] { files.Complete(); });
}

vtkSmartPointer<vtkImageData> Draw(
  const Options& options, const Results& results, vtkRidgeExampleSource* example)
{
  PictureOptions pictureOptions = options.picture;
  if (options.mesh.empty() && !options.HasForms() && !pictureOptions.view &&
    example->GetSurface() == vtkRidgeExampleSource::BLEND)
  {
    // Where both parts of the blend and the valley between them are seen.
    pictureOptions.view = { 1.0, -1.0, 0.4 };
  }
  vtkPolyData* umbilics = results.areSalient ? nullptr : results.umbilics;
  return DrawPicture(results.mesh, results.ridges, umbilics, pictureOptions);
}

/// More threads than processors gain nothing, and some back ends complain.
void SetThreads(int threads)
{
  if (threads > 0)
  {
    vtkSMPTools::Initialize(std::min(threads, vtkSMPTools::GetEstimatedNumberOfThreads()));
  }
}

ExitCode Run(const Options& options, Filters& filters, const Ranks& ranks)
{
  ranks.Together([&options, &ranks] { CheckOutputOfRank(options, ranks); });
  if (!options.noPicture)
  {
    CheckDisplay();
  }
  SetThreads(options.threads);
  Stages stages(options.quiet || !ranks.IsFirst());
  Results results;
  if (ranks.AreSeveral())
  {
    RunOnRanks(options, filters, ranks, stages, results);
  }
  else if (options.pieces > 1)
  {
    RunInPieces(options, filters, stages, results);
  }
  else
  {
    RunFilters(options, filters, stages, results);
  }

  vtkSmartPointer<vtkImageData> picture;
  if (!options.noPicture)
  {
    stages.Run("picture", "add --no-picture", nullptr,
      [&picture, &options, &results, &filters]
      { picture = Draw(options, results, filters.example); });
  }
  stages.Run("write", "check the disk and the permissions", nullptr,
    [&options, &results, &picture, &ranks] { WriteFiles(options, results, picture, ranks); });
  if (!options.quiet)
  {
    const MeshCounts counts = results.counts ? *results.counts : CountMesh(results.mesh, ranks);
    PrintReport(std::cout, results, counts, stages.GetDurations(), FilesToWrite(options));
  }
  const vtkIdType failed = results.checks ? CountFailedChecks(results.checks) : 0;
  if (options.strict && failed > 0)
  {
    std::cerr << "vtkridges: " << failed << (failed == 1 ? " check" : " checks")
              << " failed : see the table of --check, or leave out --strict\n";
    return ExitCheckFailed;
  }
  const vtkIdType unproved = results.certificate ? CountFailedHypotheses(results.certificate) : 0;
  if (unproved > 0)
  {
    std::cerr << "vtkridges: " << unproved << (unproved == 1 ? " hypothesis is" : " hypotheses are")
              << " not proved : see the table, and Certificates.md\n";
    return ExitCheckFailed;
  }
  return ExitDone;
}

} // namespace

namespace
{

int RunOnThisRank(int argc, char** argv, const Ranks& ranks)
{
  Filters filters;
  Options options;
  options.numberOfRanks = ranks.Size();
  if (const std::optional<int> exitCode = ParseCommandLine(argc, argv, options, filters))
  {
    return *exitCode;
  }
  try
  {
    return Run(options, filters, ranks);
  }
  catch (const Failure& failure)
  {
    std::cerr << "vtkridges: " << failure.what() << "\n";
    return ExitJobFailed;
  }
  catch (const std::exception&)
  {
    if (ranks.AreSeveral())
    {
      // Others may wait for this one: that it ends without a word to MPI ends them.
      std::fprintf(stderr, "vtkridges: rank %d has failed : give a smaller mesh\n", ranks.Rank());
      std::_Exit(ExitJobFailed);
    }
    throw;
  }
}

} // namespace

int RunProgram(int argc, char** argv)
{
  try
  {
    const Ranks ranks(argc, argv);
    return RunOnThisRank(argc, argv, ranks);
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
