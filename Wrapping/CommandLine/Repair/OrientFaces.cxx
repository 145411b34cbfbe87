// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Repair/OrientFaces.h"

#include "Repair/MeshEdges.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace program
{
namespace
{

using Vector = PolygonMesh::Point;

Vector Difference(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Faces in connected parts, each with the sense in which it runs relative to the root of its part.
class Parts
{
public:
  explicit Parts(std::size_t faces)
    : Parent(faces)
    , IsTurned(faces, 0)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), std::size_t{ 0 });
  }

  /// The root, and whether the face runs against it.
  std::pair<std::size_t, bool> Find(std::size_t face)
  {
    std::size_t root = face;
    char turned = 0;
    while (this->Parent[root] != root)
    {
      turned ^= this->IsTurned[root];
      root = this->Parent[root];
    }
    // All on the way are hung on the root, with the sense that is left from there on.
    char left = turned;
    while (this->Parent[face] != face)
    {
      const std::size_t next = this->Parent[face];
      const char step = this->IsTurned[face];
      this->Parent[face] = root;
      this->IsTurned[face] = left;
      left ^= step;
      face = next;
    }
    return { root, turned != 0 };
  }

  /// Says that one face must be turned relative to the other, or not. False if that is impossible.
  bool Join(std::size_t a, std::size_t b, bool turned)
  {
    const auto [rootOfA, isATurned] = this->Find(a);
    const auto [rootOfB, isBTurned] = this->Find(b);
    const bool rootsTurned = turned != (isATurned != isBTurned);
    if (rootOfA == rootOfB)
    {
      return !rootsTurned;
    }
    const auto [low, high] = std::minmax(rootOfA, rootOfB);
    this->Parent[high] = low;
    this->IsTurned[high] = rootsTurned ? 1 : 0;
    return true;
  }

private:
  std::vector<std::size_t> Parent;
  std::vector<char> IsTurned; ///< Relative to the parent.
};

struct PartMeasure
{
  bool isClosed = true;
  double volume = 0.0; ///< Enclosed, if the root's sense is outward; relative to its first point.
  double area = 0.0;   ///< Of faces in the root's sense,
  double areaTurned = 0.0; ///< and of the others, as they were.
};

/// Twice the area and six times the volume of the cone over a face, as a fan of triangles.
void Measure(
  const PolygonMesh& mesh, const Face& face, const Vector& apex, double& area, double& volume)
{
  const auto point = [&mesh, &face](std::size_t i) -> const Vector&
  { return mesh.points[static_cast<std::size_t>(face[i])]; };
  for (std::size_t i = 1; i + 1 < face.size(); ++i)
  {
    const Vector normal = Cross(Difference(point(i), point(0)), Difference(point(i + 1), point(0)));
    area += std::sqrt(Dot(normal, normal));
    volume += Dot(normal, Difference(point(0), apex));
  }
}

std::vector<PartMeasure> MeasureParts(
  const PolygonMesh& mesh, const std::vector<FaceSide>& sides, Parts& parts)
{
  std::vector<PartMeasure> measures(mesh.NumberOfFaces());
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const auto [root, turned] = parts.Find(f);
    const Vector& apex = mesh.points[static_cast<std::size_t>(mesh.FaceAt(root)[0])];
    double area = 0.0;
    double volume = 0.0;
    Measure(mesh, mesh.FaceAt(f), apex, area, volume);
    measures[root].volume += turned ? -volume : volume;
    (turned ? measures[root].areaTurned : measures[root].area) += area;
  }
  ForEachEdge(sides,
    [&parts, &measures](auto first, auto last)
    {
      for (auto side = first; last - first != 2 && side != last; ++side)
      {
        measures[parts.Find(side->face).first].isClosed = false;
      }
    });
  return measures;
}

} // namespace

Orientation OrientFaces(PolygonMesh& mesh)
{
  const std::vector<FaceSide> sides = SortedSides(mesh);
  Parts parts(mesh.NumberOfFaces());
  Orientation result;
  std::vector<std::size_t> oneSided;
  ForEachEdge(sides,
    [&parts, &result, &oneSided](auto first, auto last)
    {
      if (last - first == 2)
      {
        const bool runAlike = first->isForward == (first + 1)->isForward;
        if (!parts.Join(first->face, (first + 1)->face, runAlike))
        {
          ++result.oddEdges;
          oneSided.push_back(first->face);
        }
      }
    });
  std::vector<PartMeasure> measures = MeasureParts(mesh, sides, parts);
  for (const std::size_t face : oneSided)
  {
    measures[parts.Find(face).first].isClosed = false; // It has no outside.
  }
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const auto [root, turned] = parts.Find(f);
    const PartMeasure& part = measures[root];
    const bool isRootWrong = part.isClosed ? part.volume < 0.0 : part.areaTurned > part.area;
    if (turned != isRootWrong)
    {
      const Face face = mesh.FaceAt(f);
      const std::ptrdiff_t begin = face.begin() - mesh.corners.data();
      // From the second corner on, so that the first stays.
      std::reverse(mesh.corners.begin() + begin + 1,
        mesh.corners.begin() + begin + static_cast<std::ptrdiff_t>(face.size()));
      ++result.turnedFaces;
    }
  }
  return result;
}

bool IsInsideOut(const PolygonMesh& mesh)
{
  bool isClosed = mesh.NumberOfFaces() > 0;
  ForEachEdge(SortedSides(mesh),
    [&isClosed](auto first, auto last)
    { isClosed &= last - first == 2 && first->isForward != (first + 1)->isForward; });
  if (!isClosed)
  {
    return false;
  }
  const Vector& apex = mesh.points[static_cast<std::size_t>(mesh.FaceAt(0)[0])];
  double area = 0.0;
  double volume = 0.0;
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    Measure(mesh, mesh.FaceAt(f), apex, area, volume);
  }
  return volume < 0.0;
}

} // namespace program
