// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"
#include "Reading/PlyReader.h"

#include <gtest/gtest.h>

namespace
{

using Ids = std::vector<vtkIdType>;
using program::PolygonMesh;

const std::string Head = "ply\nformat ascii 1.0\n";
const std::string Vertices =
  "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string Faces = "element face 2\nproperty list uchar int vertex_index\n";
const std::string Points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";

PolygonMesh Parse(const std::string& text)
{
  return program::ParsePly(text, "m.ply");
}

std::string ReasonOf(const std::string& text)
{
  return FailureOf(text, "m.ply");
}

TEST(PlyReader, ReadsAFileWithoutLastLineEnd)
{
  const PolygonMesh mesh =
    Parse(Head + Vertices + Faces + "end_header\n" + Points + "3 0 1 2\n3 2 1 3");
  EXPECT_EQ(mesh.corners, (Ids{ 0, 1, 2, 2, 1, 3 }));
  EXPECT_TRUE(mesh.isSinglePrecision);
}

TEST(PlyReader, SkipsOtherElementsAndProperties)
{
  const PolygonMesh mesh = Parse(Head +
    "obj_info scanned\nelement camera 1\nproperty list int float views\nproperty double focus\n"
    "element vertex 3\nproperty uchar red\nproperty double z\nproperty double x\nproperty double "
    "y\nproperty list uchar float weights\nelement face 1\nproperty list uchar float texcoord\n"
    "property list uint8 uint32 vertex_indices\nproperty char flag\nelement edge 1\nproperty int "
    "vertex1\nend_header\n2 0.5 0.5\n9\n255 3 1 2 0\n0 6 4 5 2 .5 .5\n0 9 7 8 0\n6 0 0 1 1 0 1 3 0 "
    "1 2 7\n0\n");
  ASSERT_EQ(mesh.points.size(), 3U);
  EXPECT_EQ(mesh.points[1], (PolygonMesh::Point{ 4.0, 5.0, 6.0 }));
  EXPECT_EQ(mesh.corners, (Ids{ 0, 1, 2 }));
  EXPECT_FALSE(mesh.isSinglePrecision);
}

TEST(PlyReader, DecodesTriangleStrips)
{
  const PolygonMesh mesh = Parse(Head + Vertices +
    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + Points +
    "9 0 1 2 3 -1\n 3 2 1 -1\n");
  EXPECT_EQ(mesh.corners, (Ids{ 0, 1, 2, 1, 3, 2, 3, 2, 1 }));
}

TEST(PlyReader, ReadsHeadersWithReturnsBeforeBinaryData)
{
  const PolygonMesh expected = Ellipsoid(2);
  std::string bytes = WritePly(expected, "binary_little_endian");
  const std::size_t size = bytes.find("end_header\n") + 11;
  for (const char* lineEnd : { "\r", "\r\n" })
  {
    std::string header;
    for (const char c : bytes.substr(0, size))
    {
      header += c == '\n' ? std::string(lineEnd) : std::string(1, c);
    }
    EXPECT_EQ(Parse(header + bytes.substr(size)).points, expected.points);
  }
}

TEST(PlyReader, RejectsInvalidFiles)
{
  const std::string good = Head + Vertices + Faces + "end_header\n";
  const std::pair<std::string, const char*> invalid[] = {
    { "solid\n", "line 1: this is not a PLY file" },
    { "ply\nformat binary 1.0\n", "line 2: 'binary' is not a format of PLY" },
    { Head + "element vertex many\n", "line 3: an element needs a name and a count" },
    { Head + "element vertex -1\n", "line 3: an element needs a name and a count" },
    { Head + "element vertex 3\nproperty real x\n", "line 4: 'real' is not a type of PLY" },
    { Head + "property int x\n", "line 3: 'property' is not a statement" },
    { Head + Vertices, "the header does not end with end_header" },
    { "ply\n" + Vertices + "end_header\n", "the header names no format" },
    { Head + "element vertex 1\nproperty int x\nproperty int y\nend_header\n0 0\n",
      "the vertices lack x, y or z" },
    { Head + Vertices + "element face 1\nproperty int id\nend_header\n" + Points + "0\n",
      "the elements 'face' lack the list vertex_indices" },
    { good + "0 0 0\n1 0 0\n", "the file ends after 2 of 4 elements 'vertex'" },
    { good + Points + "3 0 1 2\n", "the file ends after 1 of 2 elements 'face'" },
    { good + Points + "3 0 1 2\n3 0", "the file ends after 1 of 2 elements 'face'" },
    { good + Points + "3 0 1 2\n3 0 1 4\n", "'face' 1: there is no vertex 4, they are numbered 0" },
    { good + Points + "3 0 1 2\n3 0 1 -1\n", "'face' 1: there is no vertex -1" },
    { good + Points + "3 0 1 2\n3 0 1 .5\n", "'face' 1: a corner is not the number of a vertex" },
    { good + Points + "3 0 1 2\n-3 0 1 2\n", "'face' 1: a list has an invalid size" },
    { good + Points + "3 0 1 2\n999999 0 1 2\n", "the file ends after 1 of 2 elements 'face'" },
    { good + "0 0 zero\n", "'zero' is not a number" },
    { good + Points + "3 0 1 2\n3 2 1 3\n3 2 1 3\n", "the file goes on after the elements" },
    { Head + "element vertex 999999999999\nproperty float x\nproperty float y\nproperty float z\n" +
        Faces + "end_header\n" + Points,
      "the file ends after 4 of 999999999999 elements 'vertex'" },
  };
  for (const auto& [text, expected] : invalid)
  {
    EXPECT_NE(ReasonOf(text).find(expected), std::string::npos)
      << text << "fails with: " << ReasonOf(text);
  }
}

TEST(PlyReader, FindsTheEndOfABinaryFileThatIsCut)
{
  for (const char* format : { "binary_little_endian", "binary_big_endian" })
  {
    const std::string bytes = WritePly(Ellipsoid(2), format);
    const std::size_t header = bytes.find("end_header\n") + 11;
    for (std::size_t size = header; size < bytes.size(); ++size)
    {
      EXPECT_NE(ReasonOf(bytes.substr(0, size)).find("the file ends after"), std::string::npos)
        << size << " of " << bytes.size() << " bytes";
    }
    EXPECT_NE(ReasonOf(bytes + "more").find("goes on"), std::string::npos);
  }
}

} // namespace
