// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/CoordinateGrain.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace program
{
namespace
{

double MeanEdge(const PolygonMesh& mesh)
{
  double sum = 0.0;
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const Face face = mesh.FaceAt(f);
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const PolygonMesh::Point& a = mesh.points[static_cast<std::size_t>(face[i])];
      const PolygonMesh::Point& b = mesh.points[static_cast<std::size_t>(face.Next(i))];
      sum += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
  }
  return mesh.corners.empty() ? 0.0 : sum / static_cast<double>(mesh.corners.size());
}

/// The distance of the largest coordinate to the next number in single precision.
double Grain(const PolygonMesh& mesh)
{
  double largest = 0.0;
  for (const vtkIdType corner : mesh.corners)
  {
    for (const double x : mesh.points[static_cast<std::size_t>(corner)])
    {
      largest = std::max(largest, std::abs(x));
    }
  }
  const auto single = static_cast<float>(largest);
  return std::nextafter(single, std::numeric_limits<float>::infinity()) - single;
}

} // namespace

std::string WarnOfGrain(const PolygonMesh& mesh)
{
  constexpr double coarse = 1e-5; // of an edge
  if (!mesh.isSinglePrecision)
  {
    return {};
  }
  const double edge = MeanEdge(mesh);
  const double grain = Grain(mesh);
  if (!(edge > 0.0) || grain <= coarse * edge)
  {
    return {};
  }
  char text[256];
  std::snprintf(text, sizeof(text),
    "the coordinates are in single precision, in steps of up to %.2g, which is %.2g of the mean "
    "edge: the ridges may show these steps",
    grain, grain / edge);
  return text;
}

} // namespace program
