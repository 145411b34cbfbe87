// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/TestFields.h"
#include "ParametricMesh.h"

#include "Mesh/CoordinateRounding.h"

#include <gtest/gtest.h>

#include <limits>

TEST(CoordinateRounding, IsThatOfTheCoarsestTypeThatHoldsAllCoordinates)
{
  using namespace ridges;
  using namespace ridges::testing;
  const MeshedSurface exact(Icosphere(3));
  const MeshedSurface rounded(RoundToSingle(Icosphere(3)));
  EXPECT_EQ(CoordinateRounding(exact.Triangles()), 0.5 * std::numeric_limits<double>::epsilon());
  EXPECT_EQ(CoordinateRounding(rounded.Triangles()), 0.5 * std::numeric_limits<float>::epsilon());
}
