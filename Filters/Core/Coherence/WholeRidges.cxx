// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Coherence/WholeRidges.h"

#include <algorithm>
#include <map>

namespace ridges
{
namespace
{

Color ColorOf(RidgeType type)
{
  return type == RidgeType::MinimumElliptic || type == RidgeType::MinimumHyperbolic ? Color::Red
                                                                                    : Color::Blue;
}

void Append(const RidgePicture& picture, const PictureLine& line, std::vector<RidgeChain>& chains)
{
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
  {
    const Id from = line.points[i];
    const Id to = line.points[i + 1];
    const bool goesOn =
      !chains.empty() && chains.back().points.back() == from && !picture.points[from].IsUmbilic();
    if (!goesOn)
    {
      chains.emplace_back();
      chains.back().points.push_back(from);
    }
    chains.back().points.push_back(to);
    chains.back().types.push_back(line.type);
  }
}

// A loop of which a polyline is missing may be cut where it starts: not to be taken for two ends.
void Close(const RidgePicture& picture, std::vector<RidgeChain>& chains)
{
  RidgeChain& first = chains.front();
  RidgeChain& last = chains.back();
  if (last.points.back() != first.points.front() ||
    picture.points[first.points.front()].IsUmbilic())
  {
    return;
  }
  if (chains.size() == 1)
  {
    first.closed = true;
    return;
  }
  last.points.insert(last.points.end(), first.points.begin() + 1, first.points.end());
  last.types.insert(last.types.end(), first.types.begin(), first.types.end());
  chains.erase(chains.begin());
}

/// A usable triangle with both edges; another one than `avoided` if there is one.
Id CommonTriangle(const RidgePicture& picture, Id edge0, Id edge1, Id avoided)
{
  Id found = -1;
  const std::vector<Id> others = TrianglesAt(*picture.mesh, edge1);
  for (const Id t : TrianglesAt(*picture.mesh, edge0))
  {
    const bool common = std::find(others.begin(), others.end(), t) != others.end();
    if (common && picture.isUsable[t] && (found < 0 || found == avoided))
    {
      found = t;
    }
  }
  return found;
}

/// The triangle in which a ridge comes from an edge to an umbilic.
Id TriangleToUmbilic(const RidgePicture& picture, const PicturePoint& end, Id edge, Id avoided)
{
  const PictureUmbilic* umbilic = picture.UmbilicOf(end.umbilic);
  Id found = -1;
  for (const Id t : TrianglesAt(*picture.mesh, edge))
  {
    const bool fits = umbilic ? t == umbilic->triangle : end.umbilic < 0;
    if (fits && picture.isUsable[t] && (found < 0 || found == avoided))
    {
      found = t;
    }
  }
  return found;
}

} // namespace

std::vector<WholeRidge> FindWholeRidges(const RidgePicture& picture)
{
  std::map<Id, WholeRidge> byId;
  for (const PictureLine& line : picture.lines)
  {
    const auto inserted = byId.insert({ line.ridge, WholeRidge{ line.ridge, ColorOf(line.type) } });
    WholeRidge& ridge = inserted.first->second;
    ridge.isOfOneColor = ridge.isOfOneColor && ridge.color == ColorOf(line.type);
    (line.closed ? ridge.saysClosed : ridge.saysOpen) = true;
    Append(picture, line, ridge.chains);
  }
  std::vector<WholeRidge> ridges;
  for (auto& item : byId)
  {
    if (!item.second.chains.empty())
    {
      Close(picture, item.second.chains);
    }
    ridges.push_back(std::move(item.second));
  }
  return ridges;
}

std::vector<RidgePiece> PiecesOf(const RidgePicture& picture, const RidgeChain& chain)
{
  std::vector<Id> stops;
  for (const Id p : chain.points)
  {
    const PicturePoint& point = picture.points[p];
    if (point.edge != PicturePoint::None || point.IsUmbilic())
    {
      stops.push_back(p);
    }
  }
  // A loop may start at a turning point.
  if (chain.closed && !stops.empty() && stops.front() != stops.back())
  {
    stops.push_back(stops.front());
  }
  std::vector<RidgePiece> pieces;
  Id before = -1;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i)
  {
    const PicturePoint& a = picture.points[stops[i]];
    const PicturePoint& b = picture.points[stops[i + 1]];
    Id triangle = -1;
    if (a.edge >= 0 && b.edge >= 0)
    {
      // In regions a ridge may enter a triangle and leave it through the same edge.
      triangle = CommonTriangle(picture, a.edge, b.edge, before);
    }
    else if (a.edge >= 0 && b.IsUmbilic())
    {
      triangle = TriangleToUmbilic(picture, b, a.edge, before);
    }
    else if (b.edge >= 0 && a.IsUmbilic())
    {
      triangle = TriangleToUmbilic(picture, a, b.edge, before);
    }
    pieces.push_back({ triangle, stops[i], stops[i + 1] });
    before = triangle;
  }
  return pieces;
}

} // namespace ridges
