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

struct Extent
{
  double largest = 0.0; ///< Coordinate, by absolute value.
  double size = 0.0;    ///< Half the diagonal of the bounding box.
};

Extent ExtentOf(const PolygonMesh& mesh)
{
  PolygonMesh::Point low;
  PolygonMesh::Point high;
  low.fill(std::numeric_limits<double>::max());
  high.fill(std::numeric_limits<double>::lowest());
  for (const vtkIdType corner : mesh.corners)
  {
    const PolygonMesh::Point& point = mesh.points[static_cast<std::size_t>(corner)];
    for (std::size_t i = 0; i < 3; ++i)
    {
      low[i] = std::min(low[i], point[i]);
      high[i] = std::max(high[i], point[i]);
    }
  }
  Extent extent;
  extent.size = 0.5 * std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  for (std::size_t i = 0; i < 3; ++i)
  {
    extent.largest = std::max({ extent.largest, std::abs(low[i]), std::abs(high[i]) });
  }
  return extent;
}

/// The distance to the next number in single precision.
double GrainAt(double x)
{
  const auto single = static_cast<float>(x);
  return std::nextafter(single, std::numeric_limits<float>::infinity()) - single;
}

} // namespace

GrainWarning WarnOfGrain(const PolygonMesh& mesh)
{
  if (!mesh.isSinglePrecision || mesh.corners.empty())
  {
    return {};
  }
  // A third derivative shows the grain divided by the cube of an edge, and is of the order of one
  // by the square of the size. At this ratio a smooth surface had 20 times its ridges; at a tenth
  // of it they were right.
  constexpr double coarse = 0.03;
  const double edge = MeanEdge(mesh);
  const Extent extent = ExtentOf(mesh);
  const double grain = GrainAt(extent.largest);
  const double sizeInEdges = extent.size / edge;
  if (!(edge > 0.0) || grain / edge * sizeInEdges * sizeInEdges <= coarse)
  {
    return {};
  }
  char text[256];
  std::snprintf(text, sizeof(text),
    "the coordinates are in single precision, in steps of up to %.2g, which is %.2g of the mean "
    "edge: the ridges may show these steps",
    grain, grain / edge);
  const bool isFar = extent.largest > 4.0 * extent.size;
  return { text,
    std::string("store the coordinates in double precision") +
      (isFar ? ", or relative to a point of the model" : "") +
      "; --neighborhood automatic reduces the effect" };
}

} // namespace program
