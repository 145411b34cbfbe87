// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/OffReader.h"

#include "Reading/TextLines.h"

#include <algorithm>
#include <cctype>

namespace program
{
namespace
{

/// Reads [ST][C][N][4][n]OFF, if it is there, and goes to the counts.
void ReadHeader(TextLines& lines)
{
  if (!lines.NextLine())
  {
    lines.Fail("the file has nothing but comments and empty lines", "give a mesh");
  }
  std::string keyword(lines.PeekWord());
  if (keyword.find_first_not_of("0123456789") == std::string::npos)
  {
    return; // The keyword may be missing.
  }
  std::transform(keyword.begin(), keyword.end(), keyword.begin(),
    [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const bool isOff = keyword.size() >= 3 && keyword.compare(keyword.size() - 3, 3, "OFF") == 0 &&
    keyword.find_first_not_of("STCN4OF") == std::string::npos;
  if (!isOff)
  {
    lines.Fail("this is not an OFF file, it does not begin with OFF", "give a mesh in OFF format");
  }
  if (keyword.find('4') != std::string::npos || lines.PeekWord().front() == 'n')
  {
    lines.Fail("the points are not in three dimensions", "convert the mesh to plain OFF");
  }
  lines.Word();
  if (lines.PeekWord() == "BINARY")
  {
    lines.Fail("binary OFF is not supported", "convert the mesh to ASCII OFF or PLY");
  }
  if (!lines.NextWord())
  {
    lines.Fail("the file ends after its header", "give a complete file");
  }
}

std::size_t ReadCount(TextLines& lines, const char* things)
{
  const std::optional<long long> count = lines.Integer();
  if (!count || *count < 0)
  {
    lines.Fail(std::string("the number of ") + things + " is missing",
      "write the numbers of vertices, faces and edges");
  }
  return static_cast<std::size_t>(*count);
}

void NextItem(TextLines& lines, const char* things, std::size_t done, std::size_t count)
{
  if (!lines.NextLine())
  {
    lines.Fail("the file ends after " + CountOf(done, count, things), "give a complete file");
  }
}

void ReadFace(TextLines& lines, PolygonMesh& mesh)
{
  const std::optional<long long> size = lines.Integer();
  if (!size || *size < 0)
  {
    lines.Fail("a face must begin with its number of corners", "correct the line");
  }
  const auto vertexCount = static_cast<long long>(mesh.points.size());
  for (long long i = 0; i < *size; ++i)
  {
    const std::optional<long long> corner = lines.Integer();
    if (!corner)
    {
      lines.Fail("a face of " + std::to_string(*size) + " corners needs as many vertex numbers",
        "correct the line");
    }
    if (*corner < 0 || *corner >= vertexCount)
    {
      lines.Fail("there is no vertex " + std::to_string(*corner) + ", they are numbered 0 to " +
          std::to_string(vertexCount - 1),
        "correct the line");
    }
    mesh.corners.push_back(static_cast<vtkIdType>(*corner));
  }
  mesh.EndFace();
}

} // namespace

PolygonMesh ParseOff(std::string_view text, const std::string& fileName)
{
  TextLines lines(text, fileName, '#');
  ReadHeader(lines);
  const std::size_t vertexCount = ReadCount(lines, "vertices");
  lines.NextWord();
  const std::size_t faceCount = ReadCount(lines, "faces");

  PolygonMesh mesh;
  // A vertex takes at least 5 bytes and a face 1: a false count cannot make us allocate.
  mesh.points.reserve(std::min(vertexCount, lines.BytesLeft() / 5));
  for (std::size_t i = 0; i < vertexCount; ++i)
  {
    NextItem(lines, "vertices", i, vertexCount);
    const std::optional<double> x = lines.Real();
    const std::optional<double> y = lines.Real();
    const std::optional<double> z = lines.Real();
    if (!x || !y || !z)
    {
      lines.Fail("a vertex needs three numbers", "correct the line");
    }
    mesh.points.push_back({ *x, *y, *z });
  }
  mesh.faceEnds.reserve(std::min(faceCount, lines.BytesLeft()));
  for (std::size_t i = 0; i < faceCount; ++i)
  {
    NextItem(lines, "faces", i, faceCount);
    ReadFace(lines, mesh);
  }
  if (lines.NextLine() && lines.Real())
  {
    lines.Fail("the file goes on after its " + std::to_string(faceCount) + " faces",
      "correct the number of faces");
  }
  return mesh;
}

} // namespace program
