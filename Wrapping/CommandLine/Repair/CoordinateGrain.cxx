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

/// Whether all coordinates are multiples of a step, as numbers that were written with a few
/// decimals are.
bool AreMultiplesOf(double step, const PolygonMesh& mesh)
{
  // Products up to here are exact enough to see a hundredth of a step.
  constexpr double largest = 1e13;
  constexpr double tolerance = 0.01;
  const auto isMultiple = [step](double x)
  {
    const double count = x / step;
    return std::abs(count) < largest && std::abs(count - std::round(count)) < tolerance;
  };
  return std::all_of(mesh.corners.begin(), mesh.corners.end(),
    [&mesh, &isMultiple](vtkIdType corner)
    {
      const PolygonMesh::Point& point = mesh.points[static_cast<std::size_t>(corner)];
      return std::all_of(point.begin(), point.end(), isMultiple);
    });
}

std::string Formatted(const char* format, double a, double b, double c = 0.0)
{
  char text[256];
  std::snprintf(text, sizeof(text), format, a, b, c);
  return text;
}

} // namespace

GrainWarning WarnOfGrain(const PolygonMesh& mesh)
{
  const double edge = MeanEdge(mesh);
  if (!(edge > 0.0) || !std::isfinite(edge))
  {
    return {};
  }
  // A third derivative shows the grain divided by the cube of an edge, and is of the order of one
  // by the square of the size. At this ratio a smooth surface had 20 times its ridges; at a tenth
  // of it they were right.
  constexpr double coarse = 0.03;
  const Extent extent = ExtentOf(mesh);
  const double sizeInEdges = extent.size / edge;
  const double mostGrain = coarse * edge / (sizeInEdges * sizeInEdges);
  const double grain = GrainAt(extent.largest);
  const bool isFar = extent.largest > 4.0 * extent.size;
  if (mesh.isSinglePrecision)
  {
    if (grain <= mostGrain)
    {
      return {};
    }
    return { Formatted("the coordinates are in single precision, in steps of up to %.2g, which is "
                       "%.2g of the mean edge: the ridges may show these steps",
               grain, grain / edge),
      std::string("store the coordinates in double precision") +
        (isFar ? ", or relative to a point of the model" : "") +
        "; --neighborhood automatic reduces the effect" };
  }
  double step = std::pow(10.0, std::ceil(std::log10(mostGrain)));
  if (AreMultiplesOf(step, mesh))
  {
    while (10.0 * step <= edge && AreMultiplesOf(10.0 * step, mesh))
    {
      step *= 10.0;
    }
    // Steps as long as the edges were meant: those of a grid.
    if (step > 0.1 * edge)
    {
      return {};
    }
    return { Formatted("all coordinates are multiples of %.2g, which is %.2g of the mean edge: if "
                       "they have been rounded to that, the ridges may show it",
               step, step / edge),
      "store the coordinates with more digits; --neighborhood automatic reduces the effect" };
  }
  if (isFar && grain > mostGrain)
  {
    return { Formatted("the coordinates are far from the origin, up to %.2g, and need double "
                       "precision, which they have here: in single precision they would be rounded "
                       "to steps of %.2g, which is %.2g of the mean edge",
               extent.largest, grain, grain / edge),
      "keep them in double precision in other programs, or relative to a point of the model" };
  }
  return {};
}

} // namespace program
