// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshReader.h"

#include "Console.h"
#include "OffReader.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPolyDataNormals.h"
#include "vtkPolyDataReader.h"
#include "vtkSTLReader.h"
#include "vtkStaticCleanPolyData.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

namespace program
{
namespace
{

/// Fails with the reason if a file cannot be opened: VTK's readers differ in what they say then.
void CheckReadable(const std::string& fileName)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(fileName, error);
  if (!std::filesystem::exists(status))
  {
    throw Failure(fileName + " does not exist", "check the path");
  }
  if (std::filesystem::is_directory(status))
  {
    throw Failure(fileName + " is a directory", "give a mesh");
  }
  if (!std::ifstream(fileName))
  {
    throw Failure(fileName + " cannot be opened", "check its permissions");
  }
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> ReadBy(Reader* reader, const std::string& fileName)
{
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> ReadByExtension(const std::string& fileName)
{
  std::string extension = std::filesystem::path(fileName).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".off")
  {
    return ReadOff(fileName);
  }
  if (extension == ".ply")
  {
    vtkNew<vtkPLYReader> reader;
    // A seam of the texture is no border of the surface.
    reader->SetDuplicatePointsForFaceTexture(false);
    return ReadBy(reader.Get(), fileName);
  }
  if (extension == ".obj")
  {
    return ReadBy(vtkNew<vtkOBJReader>().Get(), fileName);
  }
  if (extension == ".stl")
  {
    return ReadBy(vtkNew<vtkSTLReader>().Get(), fileName);
  }
  if (extension == ".vtp")
  {
    return ReadBy(vtkNew<vtkXMLPolyDataReader>().Get(), fileName);
  }
  if (extension == ".vtk")
  {
    return ReadBy(vtkNew<vtkPolyDataReader>().Get(), fileName);
  }
  throw Failure(fileName + " has an extension that is not known",
    std::string("give one of ") + ReadableExtensions());
}

} // namespace

const char* ReadableExtensions()
{
  return ".off, .ply, .obj, .stl, .vtp, .vtk";
}

vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& fileName)
{
  CheckReadable(fileName);
  return ReadByExtension(fileName);
}

vtkSmartPointer<vtkPolyData> Mend(vtkPolyData* mesh, const Mending& mending)
{
  vtkSmartPointer<vtkPolyData> result = mesh;
  if (mending.merge)
  {
    vtkNew<vtkStaticCleanPolyData> clean;
    clean->SetInputData(result);
    clean->Update();
    result = clean->GetOutput();
  }
  if (mending.orient)
  {
    vtkNew<vtkPolyDataNormals> orient;
    orient->SetInputData(result);
    orient->ConsistencyOn();
    orient->AutoOrientNormalsOn();
    orient->SplittingOff();
    // With no normals to compute the filter would pass its input.
    orient->ComputePointNormalsOff();
    orient->ComputeCellNormalsOn();
    orient->Update();
    orient->GetOutput()->GetCellData()->RemoveArray("Normals");
    result = orient->GetOutput();
  }
  return result;
}

} // namespace program
