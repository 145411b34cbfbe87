// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesHypotheses.h"

#include "Core/Certification/Hypothesis.h"

const std::array<vtkRidgesHypothesis, 12>& vtkRidgesHypotheses()
{
  static const std::array<vtkRidgesHypothesis, 12> all{ {
    { "projection", "2.2", ridges::MeshFollowsSurface,
      "the mesh is projected one-to-one to the surface" },
    { "S1", "5.2.1", ridges::NoRightAngle,
      "maximum directions at the ends of an edge are not at right angle" },
    { "S2", "5.2.1", ridges::NoUmbilicOnEdge, "no umbilic is on an edge" },
    { "S3", "5.2.1", ridges::NoRidgeThroughVertex, "no ridge goes through a vertex" },
    { "S4", "5.2.1", ridges::TransversalCrossings, "ridges cross edges transversally" },
    { "D1", "5.2.1", ridges::OneUmbilic,
      "a triangle contains at most one umbilic, and all are known" },
    { "D2", "5.2.1", ridges::NoRidgeInTriangle, "no ridge is inside a triangle" },
    { "2.2a", "6.3", ridges::DisjointPatches, "patches do not overlap" },
    { "2.2b", "6.3", ridges::NoRidgeInPatch, "no ridge is inside a patch" },
    { "2.2c", "6.3", ridges::OnlyRidgesOfUmbilic,
      "only ridges of its umbilic cross the border of a patch, once each" },
    { "2.2d.i", "6.3", ridges::CorrectOrientation,
      "the acute rule orients edges as continuity does" },
    { "2.2d.ii", "6.3", ridges::OneCrossing, "at most one ridge of a colour crosses an edge" },
  } };
  return all;
}
