// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Coherence/RidgeChecks.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

bool EndsWell(const RidgePicture& picture, Id end)
{
  const PicturePoint& point = picture.points[end];
  return point.umbilic >= 0 ? picture.UmbilicOf(point.umbilic) != nullptr
                            : point.edge >= 0 && picture.IsBorder(point.edge);
}

/// The first point at which a ridge is not what definition 4 says, or -1.
Id FirstFault(const RidgePicture& picture, const WholeRidge& ridge)
{
  for (const RidgeChain& chain : ridge.chains)
  {
    for (const RidgePiece& piece : PiecesOf(picture, chain))
    {
      if (piece.triangle < 0)
      {
        return piece.from;
      }
    }
    if (!chain.closed)
    {
      for (const Id end : { chain.points.front(), chain.points.back() })
      {
        if (!EndsWell(picture, end))
        {
          return end;
        }
      }
    }
  }
  const RidgeChain& first = ridge.chains.front();
  const bool whole = ridge.chains.size() == 1 && ridge.isOfOneColor &&
    (first.closed ? !ridge.saysOpen : !ridge.saysClosed);
  return whole ? -1 : first.points.back();
}

/// A point on the border of a triangle: side and fraction of it, 0 to 3 all around.
double BorderCoordinate(const RidgePicture& picture, Id triangle, const PicturePoint& point)
{
  const TriangleMesh& mesh = *picture.mesh;
  const int side = mesh.SideOf(triangle, point.edge);
  return std::fmod(mesh.PlaceOnBorder(triangle, side, point.parameter), 3.0);
}

Eigen::Vector3d BorderPoint(const TriangleMesh& mesh, Id triangle, double coordinate)
{
  const int side = std::min(static_cast<int>(coordinate), 2);
  const double fraction = coordinate - side;
  const Triangle& corners = mesh.Corners(triangle);
  return (1.0 - fraction) * mesh.Point(corners[side]) +
    fraction * mesh.Point(corners[(side + 1) % 3]);
}

/// A piece of a ridge in its triangle: between two points of the border, or from one to a point
/// inside.
struct Chord
{
  Id triangle;
  Color color;
  Id ridge;
  bool toUmbilic;
  double start;
  double end; ///< Unless it leads to an umbilic, start < end.
  Eigen::Vector3d umbilic;
};

Chord MakeChord(const RidgePicture& picture, const WholeRidge& ridge, const RidgePiece& piece)
{
  const PicturePoint* from = &picture.points[piece.from];
  const PicturePoint* to = &picture.points[piece.to];
  if (from->edge < 0)
  {
    std::swap(from, to);
  }
  Chord chord{ piece.triangle, ridge.color, ridge.id, to->edge < 0, 0.0, 0.0, to->position };
  chord.start = BorderCoordinate(picture, piece.triangle, *from);
  if (!chord.toUmbilic)
  {
    chord.end = BorderCoordinate(picture, piece.triangle, *to);
    if (chord.end < chord.start)
    {
      std::swap(chord.start, chord.end);
    }
  }
  return chord;
}

// The ends of two chords alternate along the border if they cross. For one that ends inside, the
// place of its end decides. Those that only touch do not cross.
bool Cross(const TriangleMesh& mesh, const Chord& a, const Chord& b)
{
  if (a.toUmbilic)
  {
    return !b.toUmbilic && Cross(mesh, b, a);
  }
  const auto isBetween = [&a](double x) { return x > a.start && x < a.end; };
  const auto touches = [&a](double x) { return x == a.start || x == a.end; };
  if (touches(b.start) || (!b.toUmbilic && touches(b.end)))
  {
    return false;
  }
  if (!b.toUmbilic)
  {
    return isBetween(b.start) != isBetween(b.end);
  }
  const Eigen::Vector3d origin = BorderPoint(mesh, a.triangle, a.start);
  const Eigen::Vector3d along = BorderPoint(mesh, a.triangle, a.end) - origin;
  // From start to end the border runs around what is on the right of the chord.
  const double side = mesh.AreaNormal(a.triangle).dot(along.cross(b.umbilic - origin));
  return isBetween(b.start) ? side > 0.0 : side < 0.0;
}

} // namespace

CoherenceCheck CheckRidgeEnds(const RidgePicture& picture, const std::vector<WholeRidge>& ridges)
{
  CoherenceCheck check(CheckKind::RidgeEnds, OffenderKind::Ridge);
  EndCounts counts;
  counts.ridges = ridges.size();
  for (const WholeRidge& ridge : ridges)
  {
    if (ridge.chains.empty())
    {
      continue;
    }
    const Id fault = FirstFault(picture, ridge);
    if (fault >= 0)
    {
      check.offenders.push_back({ { ridge.id, -1 }, picture.points[fault].position });
    }
    for (const RidgeChain& chain : ridge.chains)
    {
      counts.loops += chain.closed ? 1 : 0;
      for (const Id end : { chain.points.front(), chain.points.back() })
      {
        const bool isGood = !chain.closed && EndsWell(picture, end);
        counts.atUmbilics += isGood && picture.points[end].umbilic >= 0 ? 1 : 0;
        counts.atBorders += isGood && picture.points[end].umbilic < 0 ? 1 : 0;
      }
    }
  }
  check.applies = !ridges.empty();
  check.numbers = counts;
  return check;
}

CoherenceCheck CheckTurningPoints(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges)
{
  CoherenceCheck check(CheckKind::TurningPoints, OffenderKind::Ridge);
  TurningCounts counts;
  for (const WholeRidge& ridge : ridges)
  {
    for (const RidgeChain& chain : ridge.chains)
    {
      const std::size_t last = chain.types.size();
      std::size_t turns = 0;
      Id fault = -1;
      for (std::size_t i = 0; i < last + (chain.closed ? 0 : 1); ++i)
      {
        const bool isEnd = !chain.closed && (i == 0 || i == last);
        const RidgeType before = chain.types[i == 0 ? last - 1 : i - 1];
        const bool turns1 = !isEnd && chain.types[i] != before;
        turns += picture.points[chain.points[i]].turning ? 1 : 0;
        if (fault < 0 && picture.points[chain.points[i]].turning != turns1)
        {
          fault = chain.points[i];
        }
      }
      counts.turningPoints += turns;
      const bool isWhole = chain.closed ||
        (picture.points[chain.points.front()].IsUmbilic() &&
          picture.points[chain.points.back()].IsUmbilic());
      counts.ridges += isWhole ? 1 : 0;
      if (fault < 0 && isWhole && turns % 2 != 0)
      {
        fault = chain.points.front();
      }
      if (fault >= 0 && (check.offenders.empty() || check.offenders.back().ids[0] != ridge.id))
      {
        check.offenders.push_back({ { ridge.id, -1 }, picture.points[fault].position });
      }
    }
  }
  check.applies = counts.ridges > 0;
  check.numbers = counts;
  return check;
}

CoherenceCheck CheckNoIntersections(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges, const Monitor& monitor)
{
  CoherenceCheck check(CheckKind::Intersections, OffenderKind::Triangle);
  std::vector<Chord> chords;
  for (std::size_t i = 0; i < ridges.size(); ++i)
  {
    constexpr std::size_t between = 4096;
    if (i % between == 0 && !monitor(0.5 * static_cast<double>(i) / ridges.size()))
    {
      return check;
    }
    const WholeRidge& ridge = ridges[i];
    for (const RidgeChain& chain : ridge.chains)
    {
      for (const RidgePiece& piece : PiecesOf(picture, chain))
      {
        if (piece.triangle >= 0)
        {
          chords.push_back(MakeChord(picture, ridge, piece));
        }
      }
    }
  }
  if (!monitor(0.5))
  {
    return check;
  }
  std::stable_sort(chords.begin(), chords.end(),
    [](const Chord& a, const Chord& b)
    { return std::make_pair(a.triangle, a.color) < std::make_pair(b.triangle, b.color); });
  for (auto first = chords.begin(); first != chords.end();)
  {
    const auto last = std::find_if(first, chords.end(),
      [&first](const Chord& c)
      { return c.triangle != first->triangle || c.color != first->color; });
    bool cross = false;
    for (auto a = first; a != last; ++a)
    {
      cross = cross ||
        std::any_of(
          a + 1, last, [&picture, &a](const Chord& b) { return Cross(*picture.mesh, *a, b); });
    }
    const Id t = first->triangle;
    if (cross && (check.offenders.empty() || check.offenders.back().ids[0] != t))
    {
      check.offenders.push_back({ { t, -1 }, picture.mesh->Centroid(t) });
    }
    first = last;
  }
  check.applies = !ridges.empty();
  return check;
}

} // namespace ridges
