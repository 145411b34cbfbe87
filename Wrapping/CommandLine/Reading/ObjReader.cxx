// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/ObjReader.h"

#include "Console.h"
#include "Reading/TextLines.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace program
{
namespace
{

class ObjParser
{
public:
  ObjParser(std::string_view text, const std::string& fileName)
    : Lines(text, fileName, '#')
  {
  }

  PolygonMesh Parse(std::string_view text)
  {
    while (this->Lines.NextLine())
    {
      const std::string_view statement = this->Lines.Word();
      if (statement == "v")
      {
        this->ReadVertex();
      }
      else if (statement == "f" || statement == "fo")
      {
        this->ReadFace();
      }
    }
    // Faces may come before their vertices.
    const auto count = static_cast<long long>(this->Mesh.points.size());
    if (this->GreatestVertex > count)
    {
      this->Lines.FailAt(this->GreatestVertexLine,
        "there is no vertex " + std::to_string(this->GreatestVertex) + ", the file has " +
          std::to_string(count),
        "give a complete file");
    }
    this->CheckEnd(text);
    return std::move(this->Mesh);
  }

private:
  /// Nothing in the format says where a file ends: one that stops in a line, with vertices that no
  /// face has used yet, was cut.
  void CheckEnd(std::string_view text) const
  {
    if (text.empty() || text.back() == '\n' || text.back() == '\r')
    {
      return;
    }
    std::vector<bool> isUsed(this->Mesh.points.size(), false);
    for (const vtkIdType corner : this->Mesh.corners)
    {
      isUsed[static_cast<std::size_t>(corner)] = true;
    }
    const auto unused = std::count(isUsed.begin(), isUsed.end(), false);
    if (unused > 0)
    {
      this->Lines.Fail("the file stops in a line, and " + std::to_string(unused) +
          " of its vertices are in no face",
        "give a complete file");
    }
  }

  /// The next word of a statement, which a backslash at the end of a line continues.
  std::string_view Word()
  {
    std::string_view word = this->Lines.Word();
    while (!word.empty() && word.back() == '\\' && this->Lines.AtLineEnd())
    {
      word.remove_suffix(1);
      if (!this->Lines.NextLine() || !word.empty())
      {
        break;
      }
      word = this->Lines.Word();
    }
    return word;
  }

  /// Weights and colours after the coordinates are skipped.
  void ReadVertex()
  {
    PolygonMesh::Point point{};
    for (double& coordinate : point)
    {
      const std::optional<double> number = ToReal(this->Word());
      if (!number)
      {
        this->Lines.Fail("a vertex needs three numbers", "correct the line");
      }
      coordinate = *number;
    }
    this->Mesh.points.push_back(point);
  }

  void ReadFace()
  {
    const std::size_t begin = this->Mesh.corners.size();
    for (std::string_view word = this->Word(); !word.empty(); word = this->Word())
    {
      this->Mesh.corners.push_back(this->VertexOf(word));
    }
    if (this->Mesh.corners.size() - begin < 3)
    {
      this->Lines.Fail("a face needs three corners", "correct the line");
    }
    this->Mesh.EndFace();
  }

  /// The vertex of a corner: the number in front of the first slash.
  vtkIdType VertexOf(std::string_view corner)
  {
    const std::optional<long long> number = ToInteger(corner.substr(0, corner.find('/')));
    if (!number)
    {
      this->Lines.Fail(Quoted(corner) + " is not a corner of a face",
        "write the numbers of its vertices, as 1, 1/2 or 1//3");
    }
    const auto count = static_cast<long long>(this->Mesh.points.size());
    if (*number == 0 || *number < -count)
    {
      this->Lines.Fail("there is no vertex " + std::to_string(*number) +
          ", they are numbered from 1, or from -1 backwards",
        "correct the line");
    }
    if (*number > this->GreatestVertex)
    {
      this->GreatestVertex = *number;
      this->GreatestVertexLine = this->Lines.LineNumber();
    }
    return static_cast<vtkIdType>(*number > 0 ? *number - 1 : count + *number);
  }

  long long GreatestVertex = 0;
  long long GreatestVertexLine = 0;
  TextLines Lines;
  PolygonMesh Mesh;
};

} // namespace

PolygonMesh ParseObj(std::string_view text, const std::string& fileName)
{
  if (text.find('\0') != std::string_view::npos)
  {
    throw Failure(fileName + " has zero bytes, which the text of an OBJ file never has",
      "give a mesh in OBJ format, in ASCII or UTF-8");
  }
  return ObjParser(text, fileName).Parse(text);
}

} // namespace program
