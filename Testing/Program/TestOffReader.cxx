// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"
#include "Reading/OffReader.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

program::PolygonMesh Parse(const std::string& text)
{
  return program::ParseOff(text, "m.off");
}

void ExpectTriangle(const std::string& text)
{
  SCOPED_TRACE(text);
  const program::PolygonMesh mesh = Parse(text);
  ASSERT_EQ(mesh.points.size(), 3U);
  EXPECT_EQ(mesh.points[1][0], 1.5);
  EXPECT_EQ(mesh.points[2][1], -2e-3);
  EXPECT_EQ(mesh.corners, (std::vector<vtkIdType>{ 2, 0, 1 }));
  EXPECT_EQ(mesh.faceEnds, (std::vector<std::size_t>{ 3 }));
}

TEST(OffReader, ReadsAllVariantsOfTheFormat)
{
  ExpectTriangle("OFF\n3 1 0\n0 0 0\n1.5 0 0\n0 -2e-3 0\n3 2 0 1\n");
  ExpectTriangle("OFF 3 1 0\n0 0 0\n1.5 0 0\n0 -2e-3 0\n3 2 0 1");              // no last line end
  ExpectTriangle("off\r\n3 1\r\n0 0 0\r\n1.5 0 0\r\n0 -2e-3 0\r\n3 2 0 1\r\n"); // no edges
  ExpectTriangle("3 1 0\n0 0 0\n1.5 0 0\n0 -2e-3 0\n3 2 0 1\n");                // no keyword
  ExpectTriangle("OFF\n3\n1 0\n0 0 0\n1.5 0 0\n0 -2e-3 0\n3 2 0 1\n"); // counts on two lines
  ExpectTriangle("# by hand\n\nOFF # header\n\n 3 1 0 # counts\n# points\n\t0 0 0\n+1.5 0 0 # b\n"
                 "0 -2e-3 0\n\n3 2 0 1 # face\n# end\n");
  ExpectTriangle("COFF\n3 1 0\n0 0 0 255 0 0 255\n1.5 0 0 0 0 0 0\n0 -2e-3 0 1 1 1 1\n"
                 "3 2 0 1 0.5 0.5 0.5\n");
  ExpectTriangle("STCNOFF 3 1 0\n0 0 0 0 0 1 9 9 9 9 .5 .5\n1.5 0 0 0 0 1\n0 -2e-3 0 x\n"
                 "3 2 0 1\nwhat follows does not matter\n");
}

TEST(OffReader, ReadsFacesOfAnySize)
{
  const program::PolygonMesh mesh = Parse(
    "OFF\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 2 0\n4 0 1 2 3\n3 0 1 2\n5 0 1 2 4 3\n2 0 1\n1 0\n");
  EXPECT_EQ(mesh.faceEnds, (std::vector<std::size_t>{ 4, 7, 12 }));
}

TEST(OffReader, KeepsDoublePrecision)
{
  const program::PolygonMesh mesh = Parse("OFF 1 0 0\n0.1 1e300 -123456789.123456789\n");
  EXPECT_EQ(mesh.points[0][0], 0.1);
  EXPECT_EQ(mesh.points[0][1], 1e300);
  EXPECT_EQ(mesh.points[0][2], -123456789.123456789);
}

TEST(OffReader, NamesFileAndLineOfAnError)
{
  EXPECT_EQ(FailureOf("OFF\n# comment\n1 0 0\n0 zero 0\n", "m.off"),
    "m.off, line 4: a vertex needs three numbers : correct the line");
}

TEST(OffReader, RejectsInvalidFiles)
{
  const std::pair<const char*, const char*> faults[] = {
    { "# nothing\n", "line 1: the file has nothing but comments" },
    { "ply\n", "line 1: this is not an OFF file" },
    { "nOFF\n4 1 1 0\n", "not in three dimensions" },
    { "4OFF\n1 1 0\n", "not in three dimensions" },
    { "OFF BINARY\n1 1 0\n", "binary OFF" },
    { "OFF\n", "ends after its header" },
    { "OFF\nthree 1 0\n", "line 2: the number of vertices is missing" },
    { "OFF\n-3 1 0\n", "line 2: the number of vertices is missing" },
    { "OFF\n3\n", "the number of faces is missing" },
    { "OFF\n3 1.5 0\n", "the number of faces is missing" },
    { "OFF\n99999999999999 1 0\n", "the file ends after 0 of 99999999999999 vertices" },
    { "OFF\n3 1 0\n0 0 0\n1 0 0\n", "the file ends after 2 of 3 vertices" },
    { "OFF\n1 1 0\n0 0\n0\n", "line 3: a vertex needs three numbers" },
    { "OFF\n1 1 0\n0 0 0x\n", "line 3: a vertex needs three numbers" },
    { "OFF\n1 1 0\n0 0 0\n", "the file ends after 0 of 1 faces" },
    { "OFF\n1 1 0\n0 0 0\nx\n", "line 4: a face must begin with its number of corners" },
    { "OFF\n1 1 0\n0 0 0\n-3 0 0 0\n", "line 4: a face must begin" },
    { "OFF\n1 1 0\n0 0 0\n3 0 0\n0\n", "line 4: a face of 3 corners needs as many" },
    { "OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "line 4: there is no vertex 1" },
    { "OFF\n1 1 0\n0 0 0\n3 0 0 -1\n", "line 4: there is no vertex -1" },
    { "OFF\n1 1 0\n0 0 0\n3 0 0 0\n3 0 0 0\n", "line 5: the file goes on after its 1 faces" },
  };
  for (const auto& [text, expected] : faults)
  {
    EXPECT_NE(FailureOf(text, "m.off").find(expected), std::string::npos)
      << text << "\nfails with: " << FailureOf(text, "m.off");
  }
}

} // namespace
