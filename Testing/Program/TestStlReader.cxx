// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"
#include "Reading/StlReader.h"

#include <gtest/gtest.h>

namespace
{

using program::PolygonMesh;

const std::string Facet = "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n"
                          "  vertex 0 0.1 0\n endloop\nendfacet\n";

std::string ReasonOf(const std::string& bytes)
{
  return FailureOf(bytes, "m.stl");
}

std::string BinaryFile()
{
  for (const MeshBytes& file : WriteInAllFormats(Ellipsoid(2)))
  {
    if (file.name == "binary.stl")
    {
      return file.bytes;
    }
  }
  return {};
}

TEST(StlReader, ReadsAsciiInDoublePrecision)
{
  const PolygonMesh mesh = program::ParseStl("solid\n" + Facet + "endsolid\n", "m.stl");
  ASSERT_EQ(mesh.points.size(), 3U);
  EXPECT_EQ(mesh.points[2][1], 0.1);
  EXPECT_FALSE(mesh.isSinglePrecision);
}

TEST(StlReader, ReadsSeveralSolidsAndAnyNormal)
{
  const std::string odd = "FACET NORMAL nan\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\n"
                          "ENDLOOP\nENDFACET\n";
  const PolygonMesh mesh = program::ParseStl(
    "solid one two\n" + Facet + "endsolid one two\n\nSolid\n" + odd + "EndSolid", "m.stl");
  EXPECT_EQ(mesh.NumberOfFaces(), 2U);
}

TEST(StlReader, ReadsBinaryFilesThatBeginWithSolid)
{
  std::string bytes = BinaryFile();
  bytes.replace(0, 6, "solid ");
  EXPECT_EQ(program::ParseStl(bytes, "m.stl").NumberOfFaces(), 80U);
}

TEST(StlReader, HoldsBinaryFilesAgainstTheirCount)
{
  const std::string bytes = BinaryFile();
  EXPECT_EQ(ReasonOf(bytes), "none");
  EXPECT_EQ(ReasonOf(bytes.substr(0, 2000)),
    "m.stl has 2000 bytes instead of the 4084 of its 80 triangles : give a complete STL file");
  std::string less = bytes;
  less[80] = 79;
  EXPECT_NE(ReasonOf(less).find("instead of the 4034 of its 79 triangles"), std::string::npos);
  std::string more = bytes;
  more[83] = '\x7f';
  EXPECT_NE(ReasonOf(more).find("of its 2130706512 triangles"), std::string::npos);
}

TEST(StlReader, RejectsInvalidText)
{
  const std::pair<std::string, const char*> invalid[] = {
    { "solid\n" + Facet, "line 8: the file ends within a solid, after 1 triangles" },
    { "solid\n" + Facet.substr(0, 30), "the file ends within a solid, after 0 triangles" },
    { "solid\n" + Facet + "face\n", "line 9: 'face' is neither facet nor endsolid" },
    { "solid\nfacet\nouter loop\nvertex 0 0\nendloop\n", "line 4: a vertex needs three numbers" },
    { "solid\nfacet\nouter loop\nvertex 0 0 0\nendloop\n", "vertex is missing in front of" },
    { "so", "not an STL file" },
  };
  for (const auto& [text, expected] : invalid)
  {
    EXPECT_NE(ReasonOf(text).find(expected), std::string::npos)
      << text << "fails with: " << ReasonOf(text);
  }
}

} // namespace
