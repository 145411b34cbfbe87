// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"

#include "Console.h"
#include "Reading/MeshReader.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyDataWriter.h"
#include "vtkRidgeExampleSource.h"
#include "vtkXMLPolyDataWriter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>

#ifdef _WIN32
#include <process.h>
#else
#include <unistd.h>
#endif

using program::Face;
using program::PolygonMesh;

namespace
{

std::string Text(const PolygonMesh::Point& point)
{
  char text[96];
  std::snprintf(text, sizeof(text), "%.17g %.17g %.17g", point[0], point[1], point[2]);
  return text;
}

/// On the machines of the tests, which are little-endian.
template <typename T>
std::string Bytes(T value, bool isReversed = false)
{
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (isReversed)
  {
    std::reverse(bytes.begin(), bytes.end());
  }
  return bytes;
}

std::string WriteOff(const PolygonMesh& mesh)
{
  std::string text = "OFF\n" + std::to_string(mesh.points.size()) + " " +
    std::to_string(mesh.NumberOfFaces()) + " 0\n";
  for (const PolygonMesh::Point& point : mesh.points)
  {
    text += Text(point) + "\n";
  }
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    text += std::to_string(mesh.FaceAt(f).size());
    for (const vtkIdType corner : mesh.FaceAt(f))
    {
      text += " " + std::to_string(corner);
    }
    text += "\n";
  }
  return text;
}

std::string WriteObj(const PolygonMesh& mesh)
{
  std::string text = "# comment\no name\n";
  for (const PolygonMesh::Point& point : mesh.points)
  {
    text += "v " + Text(point) + "\n";
  }
  text += "vt 0 0\nvn 0 0 1\nusemtl stone\n";
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    text += "f";
    for (const vtkIdType corner : mesh.FaceAt(f))
    {
      text += " " + std::to_string(corner + 1) + "/1/1";
    }
    text += "\n";
  }
  return text;
}

std::string WriteStl(const PolygonMesh& mesh, bool isBinary)
{
  std::string text = isBinary ? std::string(80, 's') : "solid name\n";
  text += isBinary ? Bytes(static_cast<std::uint32_t>(mesh.NumberOfFaces())) : "";
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    text += isBinary ? std::string(12, '\0') : "facet normal 0 0 1\nouter loop\n";
    for (const vtkIdType corner : mesh.FaceAt(f))
    {
      const PolygonMesh::Point& point = mesh.points[static_cast<std::size_t>(corner)];
      text += isBinary ? "" : "vertex " + Text(point) + "\n";
      for (int i = 0; isBinary && i < 3; ++i)
      {
        text += Bytes(static_cast<float>(point[i]));
      }
    }
    text += isBinary ? std::string(2, '\0') : "endloop\nendfacet\n";
  }
  return text + (isBinary ? "" : "endsolid name\n");
}

std::string WriteLegacyVtk(const PolygonMesh& mesh, bool isBinary, bool isVersion4)
{
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetInputData(mesh.ToPolyData());
  writer->SetFileType(isBinary ? VTK_BINARY : VTK_ASCII);
  if (isVersion4)
  {
    writer->SetFileVersion(vtkPolyDataWriter::VTK_LEGACY_READER_VERSION_4_2);
  }
  writer->WriteToOutputStringOn();
  writer->Write();
  return { writer->GetOutputString(), static_cast<std::size_t>(writer->GetOutputStringLength()) };
}

std::string WriteXmlVtk(const PolygonMesh& mesh, int mode, bool isEncoded, bool isCompressed)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(mesh.ToPolyData());
  writer->SetDataMode(mode);
  writer->SetEncodeAppendedData(isEncoded);
  writer->SetCompressorType(isCompressed ? vtkXMLPolyDataWriter::ZLIB : vtkXMLPolyDataWriter::NONE);
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputString();
}

} // namespace

std::string ScratchPath(const std::string& name)
{
#ifdef _WIN32
  const auto process = _getpid();
#else
  const auto process = getpid();
#endif
  const std::string unique = "vtkridges-" + std::to_string(process) + "-" + name;
  return (std::filesystem::path(testing::TempDir()) / unique).string();
}

std::string WritePly(const PolygonMesh& mesh, const std::string& format)
{
  std::string text = "ply\nformat " + format + " 1.0\ncomment made by a test\nelement vertex " +
    std::to_string(mesh.points.size()) +
    "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nelement face " +
    std::to_string(mesh.NumberOfFaces()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  const bool isAscii = format == "ascii";
  const bool isReversed = format == "binary_big_endian";
  for (const PolygonMesh::Point& point : mesh.points)
  {
    text += isAscii ? Text(point) + " 255\n" : "";
    for (int i = 0; !isAscii && i < 3; ++i)
    {
      text += Bytes(point[i], isReversed);
    }
    text += isAscii ? "" : "\xff";
  }
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const Face face = mesh.FaceAt(f);
    text += isAscii ? std::to_string(face.size()) : std::string(1, static_cast<char>(face.size()));
    for (const vtkIdType corner : face)
    {
      text += isAscii ? " " + std::to_string(corner)
                      : Bytes(static_cast<std::int32_t>(corner), isReversed);
    }
    text += isAscii ? "\n" : "";
  }
  return text;
}

PolygonMesh Ellipsoid(int frequency)
{
  vtkNew<vtkRidgeExampleSource> source;
  source->SetSurfaceToEllipsoid();
  source->SetFrequency(frequency);
  source->Update();
  vtkPolyData* data = source->GetOutput();
  PolygonMesh mesh;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    mesh.points.emplace_back();
    data->GetPoint(i, mesh.points.back().data());
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < data->GetNumberOfPolys(); ++i)
  {
    data->GetPolys()->GetCellAtId(i, corners);
    mesh.AddTriangle(corners->GetId(0), corners->GetId(1), corners->GetId(2));
  }
  return mesh;
}

PolygonMesh Soup(const PolygonMesh& mesh)
{
  PolygonMesh soup;
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    for (const vtkIdType corner : mesh.FaceAt(f))
    {
      soup.corners.push_back(static_cast<vtkIdType>(soup.points.size()));
      soup.points.push_back(mesh.points[static_cast<std::size_t>(corner)]);
    }
    soup.EndFace();
  }
  return soup;
}

std::vector<MeshBytes> WriteInAllFormats(const PolygonMesh& mesh)
{
  using Xml = vtkXMLPolyDataWriter;
  return {
    { "mesh.off", WriteOff(mesh) },
    { "mesh.obj", WriteObj(mesh) },
    { "ascii.ply", WritePly(mesh, "ascii") },
    { "little.ply", WritePly(mesh, "binary_little_endian") },
    { "big.ply", WritePly(mesh, "binary_big_endian") },
    { "ascii.stl", WriteStl(mesh, false) },
    { "binary.stl", WriteStl(mesh, true) },
    { "ascii.vtk", WriteLegacyVtk(mesh, false, false) },
    { "binary.vtk", WriteLegacyVtk(mesh, true, false) },
    { "ascii4.vtk", WriteLegacyVtk(mesh, false, true) },
    { "binary4.vtk", WriteLegacyVtk(mesh, true, true) },
    { "ascii.vtp", WriteXmlVtk(mesh, Xml::Ascii, true, false) },
    { "binary.vtp", WriteXmlVtk(mesh, Xml::Binary, true, false) },
    { "compressed.vtp", WriteXmlVtk(mesh, Xml::Binary, true, true) },
    { "appended.vtp", WriteXmlVtk(mesh, Xml::Appended, true, true) },
    { "raw.vtp", WriteXmlVtk(mesh, Xml::Appended, false, false) },
  };
}

std::string FailureOf(const std::string& bytes, const std::string& name)
{
  try
  {
    program::ParseMesh(bytes, name);
  }
  catch (const program::Failure& failure)
  {
    return failure.what();
  }
  return "none";
}
