// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Fixtures/TestFields.h"

#include "Umbilics/WeakZones.h"

#include <gtest/gtest.h>

#include <set>

namespace
{

using namespace ridges;
using namespace ridges::testing;

} // namespace

//------------------------------------------------------------------------------
TEST(WeakZones, AreTheConnectedOnesWithAPointInside)
{
  const MeshedSurface surface(Icosphere(10));
  const TriangleMesh& mesh = surface.Triangles();
  std::vector<std::uint8_t> weak(mesh.NumberOfTriangles(), 0);
  EXPECT_TRUE(WeakZones(mesh, weak).empty());
  for (const Id t : mesh.TrianglesAround(200))
  {
    weak[t] = 1;
  }
  weak[0] = 1; // No point of a lone triangle is inside.
  const auto one = WeakZones(mesh, weak);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(std::set<Id>(one[0].begin(), one[0].end()),
    std::set<Id>(mesh.TrianglesAround(200).begin(), mesh.TrianglesAround(200).end()));
  weak.assign(weak.size(), 1);
  const auto all = WeakZones(mesh, weak);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(static_cast<Id>(all[0].size()), mesh.NumberOfTriangles());
}
