// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/EnclosedVolume.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace
{

using namespace ridges;

/// Far from the origin; the mesh keeps a pointer to them.
const std::vector<double> Points{ 1000, 1000, 1000, 1001, 1000, 1000, 1000, 1001, 1000, 1000, 1000,
  1001 };

/// A tetrahedron with normals that point outwards.
TriangleMesh Tetrahedron(bool turnAll, bool turnOne, std::size_t triangles = 4)
{
  std::vector<Triangle> list{ { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } };
  list.resize(triangles);
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    if (turnAll != (turnOne && i == 0))
    {
      std::swap(list[i][1], list[i][2]);
    }
  }
  TriangleMesh mesh(Points.data(), 4, list);
  mesh.BuildEdges();
  return mesh;
}

TEST(EnclosedVolume, IsNegativeInsideOut)
{
  EXPECT_FALSE(IsInsideOut(Tetrahedron(false, false)));
  EXPECT_TRUE(IsInsideOut(Tetrahedron(true, false)));
}

TEST(EnclosedVolume, NeedsAClosedSurfaceOfOneOrientation)
{
  EXPECT_FALSE(IsInsideOut(Tetrahedron(true, true)));
  EXPECT_FALSE(IsInsideOut(Tetrahedron(true, false, 3)));
  EXPECT_FALSE(IsInsideOut(Tetrahedron(true, false, 0)));
}

} // namespace
