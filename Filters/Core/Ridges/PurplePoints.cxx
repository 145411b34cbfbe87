// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/PurplePoints.h"

#include <array>
#include <unordered_map>

namespace ridges
{
namespace
{

struct Passage
{
  Id ridge;
  double parameter; ///< From the edge's smaller point id to its larger.
  bool once;        ///< Whether this is the only passage of the colour over the edge.
};

using Passages = std::unordered_map<Id, Passage>;

Passages PassagesOf(const std::vector<RidgeTrace>& ridges)
{
  Passages passages;
  for (std::size_t r = 0; r < ridges.size(); ++r)
  {
    const std::size_t count = ridges[r].vertices.size() - (ridges[r].closed ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      const RidgeVertex& vertex = ridges[r].vertices[i];
      if (vertex.edge != RidgeVertex::None)
      {
        const auto inserted =
          passages.insert({ vertex.edge, { static_cast<Id>(r), vertex.point.parameter, true } });
        inserted.first->second.once = inserted.second;
      }
    }
  }
  return passages;
}

/// A piece of a ridge across a triangle, by where its ends are on the way around it: from side i
/// to side i + 1 that is i to i + 1.
struct Piece
{
  Id ridge = -1;
  std::array<double, 2> ends{};
};

bool FindPiece(const TriangleMesh& mesh, const Passages& passages, Id triangle, Piece& piece)
{
  int count = 0;
  for (int side = 0; side < 3; ++side)
  {
    const auto found = passages.find(mesh.EdgeOf(triangle, side));
    if (found == passages.end())
    {
      continue;
    }
    const Passage& passage = found->second;
    if (!passage.once || count == 2 || (count == 1 && passage.ridge != piece.ridge))
    {
      return false;
    }
    piece.ridge = passage.ridge;
    piece.ends[count++] = mesh.PlaceOnBorder(triangle, side, passage.parameter);
  }
  return count == 2;
}

/// The point on the way around a triangle, in the plane of the first two barycentric coordinates.
Eigen::Vector2d OnContour(double way)
{
  const double t = way - static_cast<int>(way);
  switch (static_cast<int>(way) % 3)
  {
    case 0:
      return { 1.0 - t, t };
    case 1:
      return { 0.0, 1.0 - t };
    default:
      return { t, 0.0 };
  }
}

} // namespace

std::vector<PurplePoint> FindPurplePoints(
  const TriangleMesh& mesh, const std::vector<RidgeTrace>& blue, const std::vector<RidgeTrace>& red)
{
  const Passages bluePassages = PassagesOf(blue);
  const Passages redPassages = PassagesOf(red);
  std::vector<PurplePoint> points;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    Piece b;
    Piece r;
    if (!FindPiece(mesh, bluePassages, t, b) || !FindPiece(mesh, redPassages, t, r))
    {
      continue;
    }
    // They cross if exactly one end of one is between the ends of the other.
    const auto between = [&r](double end) { return end > r.ends[0] && end < r.ends[1]; };
    if (between(b.ends[0]) == between(b.ends[1]))
    {
      continue;
    }
    const Eigen::Vector2d p = OnContour(b.ends[0]);
    const Eigen::Vector2d u = OnContour(b.ends[1]) - p;
    const Eigen::Vector2d q = OnContour(r.ends[0]);
    const Eigen::Vector2d v = OnContour(r.ends[1]) - q;
    const double cross = u[0] * v[1] - u[1] * v[0];
    const double s = cross != 0.0 ? ((q - p)[0] * v[1] - (q - p)[1] * v[0]) / cross : 0.5;
    const Eigen::Vector2d weights = p + s * u;
    const Triangle& corners = mesh.Corners(t);
    points.push_back({ t, b.ridge, r.ridge,
      weights[0] * mesh.Point(corners[0]) + weights[1] * mesh.Point(corners[1]) +
        (1.0 - weights[0] - weights[1]) * mesh.Point(corners[2]) });
  }
  return points;
}

} // namespace ridges
