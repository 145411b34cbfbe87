// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/StlReader.h"

#include "Console.h"
#include "Reading/ByteOrder.h"
#include "Reading/TextLines.h"

#include <algorithm>
#include <cctype>

namespace program
{
namespace
{

constexpr std::size_t HeaderSize = 84; ///< With the number of triangles in its last four bytes.
constexpr std::size_t FacetSize = 50;  ///< Normal and corners, in 32 bits, and two bytes.

std::size_t BinaryCount(std::string_view bytes)
{
  return LoadNumber<std::uint32_t>(bytes.data() + HeaderSize - 4, ByteOrder::LittleEndian);
}

PolygonMesh ParseBinary(std::string_view bytes)
{
  const std::size_t count = BinaryCount(bytes);
  PolygonMesh mesh;
  mesh.isSinglePrecision = true;
  mesh.points.reserve(3 * count);
  mesh.corners.reserve(3 * count);
  mesh.faceEnds.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const char* corners = bytes.data() + HeaderSize + i * FacetSize + 12;
    for (int k = 0; k < 3; ++k)
    {
      PolygonMesh::Point point{};
      for (int j = 0; j < 3; ++j)
      {
        point[j] = LoadNumber<float>(corners + 4 * (3 * k + j), ByteOrder::LittleEndian);
      }
      mesh.points.push_back(point);
    }
    const vtkIdType first = 3 * static_cast<vtkIdType>(i);
    mesh.AddTriangle(first, first + 1, first + 2);
  }
  return mesh;
}

class AsciiStl
{
public:
  AsciiStl(std::string_view text, const std::string& fileName)
    : Lines(text, fileName, '\0')
  {
  }

  PolygonMesh Parse()
  {
    while (this->Lines.NextWord())
    {
      this->Take("solid");
      this->Lines.SkipLine(); // its name
      for (std::string word = this->Keyword(); word != "endsolid"; word = this->Keyword())
      {
        if (word != "facet")
        {
          this->Lines.Fail(Quoted(word) + " is neither facet nor endsolid", "correct the line");
        }
        this->ReadFacet();
      }
      this->Lines.SkipLine();
    }
    return std::move(this->Mesh);
  }

private:
  std::string Keyword()
  {
    if (!this->Lines.NextWord())
    {
      this->Lines.Fail("the file ends within a solid, after " +
          std::to_string(this->Mesh.NumberOfFaces()) + " triangles",
        "give a complete file");
    }
    std::string word(this->Lines.Word());
    std::transform(word.begin(), word.end(), word.begin(),
      [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return word;
  }

  void Take(const char* expected)
  {
    const std::string word = this->Keyword();
    if (word != expected)
    {
      this->Lines.Fail(
        std::string(expected) + " is missing in front of " + Quoted(word), "correct the line");
    }
  }

  /// The normal is skipped, whatever its words are: it follows from the corners.
  void ReadFacet()
  {
    while (this->Keyword() != "outer")
    {
    }
    this->Take("loop");
    const auto first = static_cast<vtkIdType>(this->Mesh.points.size());
    for (int i = 0; i < 3; ++i)
    {
      this->Take("vertex");
      PolygonMesh::Point point{};
      for (double& coordinate : point)
      {
        const std::optional<double> number = this->Lines.Real();
        if (!number)
        {
          this->Lines.Fail("a vertex needs three numbers", "correct the line");
        }
        coordinate = *number;
      }
      this->Mesh.points.push_back(point);
    }
    this->Take("endloop");
    this->Take("endfacet");
    this->Mesh.AddTriangle(first, first + 1, first + 2);
  }

  TextLines Lines;
  PolygonMesh Mesh;
};

bool IsAscii(std::string_view bytes)
{
  std::string_view text = bytes.substr(0, 3) == "\xef\xbb\xbf" ? bytes.substr(3) : bytes;
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  text = first == std::string_view::npos ? std::string_view() : text.substr(first, 5);
  constexpr std::string_view keyword = "solid";
  return std::equal(text.begin(), text.end(), keyword.begin(), keyword.end(),
           [](unsigned char a, unsigned char b) { return std::tolower(a) == b; }) &&
    bytes.find('\0') == std::string_view::npos;
}

} // namespace

PolygonMesh ParseStl(std::string_view bytes, const std::string& fileName)
{
  // Many binary files begin with "solid": their size tells them apart.
  if (bytes.size() >= HeaderSize && bytes.size() == HeaderSize + FacetSize * BinaryCount(bytes))
  {
    return ParseBinary(bytes);
  }
  if (IsAscii(bytes))
  {
    return AsciiStl(bytes, fileName).Parse();
  }
  if (bytes.size() < HeaderSize)
  {
    throw Failure(fileName + " is not an STL file, it neither begins with solid nor has the " +
        std::to_string(HeaderSize) + " bytes of a binary header",
      "give a mesh in STL format");
  }
  const std::size_t count = BinaryCount(bytes);
  throw Failure(fileName + " has " + std::to_string(bytes.size()) + " bytes instead of the " +
      std::to_string(HeaderSize + FacetSize * count) + " of its " + std::to_string(count) +
      " triangles",
    "give a complete STL file");
}

} // namespace program
