// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/MeshReader.h"

#include "Console.h"
#include "Reading/FileBytes.h"
#include "Reading/LegacyVtkReader.h"
#include "Reading/ObjReader.h"
#include "Reading/OffReader.h"
#include "Reading/PiecesReader.h"
#include "Reading/PlyReader.h"
#include "Reading/StlReader.h"
#include "Reading/XmlVtkReader.h"

namespace program
{
namespace
{

MeshFile ParseByExtension(const std::string& bytes, const std::string& fileName)
{
  const std::string extension = ExtensionOf(fileName);
  if (extension == ".off")
  {
    return { ParseOff(bytes, fileName), nullptr };
  }
  if (extension == ".ply")
  {
    return { ParsePly(bytes, fileName), nullptr };
  }
  if (extension == ".obj")
  {
    return { ParseObj(bytes, fileName), nullptr };
  }
  if (extension == ".stl")
  {
    return { ParseStl(bytes, fileName), nullptr, false };
  }
  if (extension == ".vtk")
  {
    return { ParseLegacyVtk(bytes, fileName), nullptr };
  }
  if (extension == ".vtp")
  {
    const vtkSmartPointer<vtkPolyData> data = ParseXmlVtk(bytes, fileName);
    return { ToPolygonMesh(data, fileName), data };
  }
  throw Failure(
    fileName + " has an unknown extension", std::string("give one of ") + ReadableExtensions());
}

} // namespace

const char* ReadableExtensions()
{
  return ".off, .ply, .obj, .stl, .vtp, .pvtp, .vtk";
}

namespace
{

MeshFile WithTriangles(MeshFile file, const std::string& fileName)
{
  if (file.mesh.NumberOfFaces() == 0)
  {
    throw Failure(fileName + (file.mesh.points.empty() ? " has no points" : " has no triangles"),
      "give the mesh of a surface");
  }
  return file;
}

} // namespace

MeshFile ParseMesh(const std::string& bytes, const std::string& fileName)
{
  return WithTriangles(ParseByExtension(bytes, fileName), fileName);
}

MeshFile ReadMesh(const std::string& fileName)
{
  return IsOfPieces(fileName) ? WithTriangles(ReadPiecesOfRank(fileName, 0, 1), fileName)
                              : ParseMesh(ReadBytes(fileName), fileName);
}

MeshFile ReadPiecesOfRank(const std::string& fileName, int rank, int ranks)
{
  const vtkSmartPointer<vtkPolyData> data = ReadPieces(fileName, rank, ranks);
  return { ToPolygonMesh(data, fileName), data };
}

} // namespace program
