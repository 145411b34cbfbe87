// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"
#include "Reading/ObjReader.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using Ids = std::vector<vtkIdType>;

const std::string ThreeVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

Ids CornersOf(const std::string& text)
{
  return program::ParseObj(text, "m.obj").corners;
}

std::string ReasonOf(const std::string& text)
{
  return FailureOf(text, "m.obj");
}

TEST(ObjReader, ReadsEveryWayToWriteACorner)
{
  const Ids expected{ 0, 1, 2 };
  for (const char* face : { "f 1 2 3", "f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/3/1",
         "f 1// 2// 3//", "f 1/1/ 2/2/ 3/3/", "f -3 -2 -1", "f  1\t2  3  ", "f 1 2 3 # face",
         "f 1 2 \\\n3", "f 1 2\\\r\n 3", "fo 1 2 3", "f +1 2 3" })
  {
    EXPECT_EQ(CornersOf(ThreeVertices + face), expected) << face;
  }
}

TEST(ObjReader, JoinsFacesByVertexNumbersAcrossSeams)
{
  const std::string text = ThreeVertices +
    "v 1 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\nvn 1 0 0\nf 1/1/1 2/1/1 3/1/1\nf 3/2/2 2/2/2 4/2/2\n";
  const program::PolygonMesh mesh = program::ParseObj(text, "m.obj");
  EXPECT_EQ(mesh.points.size(), 4U);
  EXPECT_EQ(mesh.corners, (Ids{ 0, 1, 2, 2, 1, 3 }));
}

TEST(ObjReader, SkipsOtherStatements)
{
  const std::string text = "mtllib a.mtl\ng\nusemtl \ns off\no \nvp 0.1\nl 1 2\np 1\n# \\\n" +
    ThreeVertices + "unknown 1 2 3\nf 1 2 3\n";
  EXPECT_EQ(CornersOf(text), (Ids{ 0, 1, 2 }));
}

TEST(ObjReader, ReadsFacesBeforeTheirVertices)
{
  EXPECT_EQ(CornersOf("f 1 2 3\n" + ThreeVertices), (Ids{ 0, 1, 2 }));
}

TEST(ObjReader, SkipsWeightsAndColoursOfVertices)
{
  const program::PolygonMesh mesh =
    program::ParseObj("v 0.1 +.5 -3e-2 1\nv 1 2 3 0.5 0.5 0.5\nv 1 2 nan\n", "m.obj");
  ASSERT_EQ(mesh.points.size(), 3U);
  EXPECT_EQ(mesh.points[0], (program::PolygonMesh::Point{ 0.1, 0.5, -3e-2 }));
  EXPECT_TRUE(std::isnan(mesh.points[2][2]));
}

TEST(ObjReader, RejectsInvalidStatements)
{
  const std::pair<const char*, const char*> invalid[] = {
    { "f 1 2 9\n", "line 4: there is no vertex 9, the file has 3" },
    { "f 0 1 2\n", "line 4: there is no vertex 0" },
    { "f 1 2 -4\n", "line 4: there is no vertex -4" },
    { "f 1 2 99999999999999999999\n", "line 4: '99999999999999999999' is not a corner" },
    { "f 1 2 x\n", "line 4: 'x' is not a corner of a face" },
    { "f 1 2 /3\n", "line 4: '/3' is not a corner" },
    { "f 1 2\n", "line 4: a face needs three corners" },
    { "v 1 2\n", "line 4: a vertex needs three numbers" },
    { "v 1,5 2,5 3,5\n", "line 4: a vertex needs three numbers" },
    { "v 1 1 0\nf 1 2 3", "line 5: the file stops in a line, and 1 of its vertices" },
    { "v 1 2 3x\n", "line 4: a vertex needs three numbers" },
  };
  for (const auto& [text, expected] : invalid)
  {
    EXPECT_NE(ReasonOf(ThreeVertices + text).find(expected), std::string::npos)
      << text << "fails with: " << ReasonOf(ThreeVertices + text);
  }
}

} // namespace
