// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Coherence/PatchChecks.h"

#include "Mesh/Regions.h"

#include <algorithm>
#include <map>
#include <set>

namespace ridges
{
namespace
{

/// Triangles of the patches, by the ids of their umbilics.
std::map<Id, std::vector<Id>> FindPatches(const RidgePicture& picture)
{
  std::map<Id, std::vector<Id>> patches;
  for (Id t = 0; t < picture.mesh->NumberOfTriangles(); ++t)
  {
    if (picture.patchOf[t] >= 0)
    {
      patches[picture.patchOf[t]].push_back(t);
    }
  }
  return patches;
}

// Connected through edges, and of characteristic 1: then nothing is enclosed, and no point is
// touched twice.
bool IsDisk(const TriangleMesh& mesh, const std::vector<Id>& patch)
{
  const std::set<Id> triangles(patch.begin(), patch.end());
  std::set<Id> points;
  std::set<Id> edges;
  std::set<Id> reached{ patch.front() };
  const std::vector<Id> connected = TrianglesFrom(mesh, patch.front(),
    [&triangles, &reached](Id, Id next)
    { return triangles.count(next) > 0 && reached.insert(next).second; });
  for (const Id t : connected)
  {
    for (int side = 0; side < 3; ++side)
    {
      points.insert(mesh.Corners(t)[side]);
      edges.insert(mesh.EdgeOf(t, side));
    }
  }
  return reached.size() == triangles.size() && points.size() + triangles.size() == edges.size() + 1;
}

/// The patch that a ridge does not leave, or -1.
Id PatchAround(const RidgePicture& picture, const WholeRidge& ridge)
{
  Id patch = -1;
  for (const RidgeChain& chain : ridge.chains)
  {
    for (const RidgePiece& piece : PiecesOf(picture, chain))
    {
      const Id here = piece.triangle >= 0 ? picture.patchOf[piece.triangle] : -1;
      if (here < 0 || (patch >= 0 && here != patch))
      {
        return -1;
      }
      patch = here;
    }
  }
  return patch;
}

bool LeadsFromUmbilicToBorder(const RidgePicture& picture, const WholeRidge& ridge, Id umbilic)
{
  const RidgeChain& chain = ridge.chains.front();
  const PicturePoint& first = picture.points[chain.points.front()];
  const PicturePoint& last = picture.points[chain.points.back()];
  return ridge.chains.size() == 1 && !chain.closed &&
    ((first.umbilic == umbilic && last.edge >= 0) || (last.umbilic == umbilic && first.edge >= 0));
}

/// As one of the three ridges at an umbilic may do with another.
bool LeadsFromUmbilicToItself(const RidgePicture& picture, const WholeRidge& ridge, Id umbilic)
{
  const RidgeChain& chain = ridge.chains.front();
  const PictureUmbilic* around = picture.UmbilicOf(umbilic);
  return around && around->ridgeCount == 3 && ridge.chains.size() == 1 && !chain.closed &&
    picture.points[chain.points.front()].umbilic == umbilic &&
    picture.points[chain.points.back()].umbilic == umbilic;
}

} // namespace

CoherenceCheck CheckPatches(const RidgePicture& picture)
{
  CoherenceCheck check(CheckKind::Patches, OffenderKind::Umbilic);
  std::map<Id, std::vector<Id>> patches = FindPatches(picture);
  check.numbers = patches.size();
  check.applies = !patches.empty() || !picture.umbilics.empty();
  for (const PictureUmbilic& umbilic : picture.umbilics)
  {
    const auto patch = patches.find(umbilic.id);
    const bool good = patch != patches.end() && IsDisk(*picture.mesh, patch->second) &&
      std::binary_search(patch->second.begin(), patch->second.end(), umbilic.triangle);
    if (!good)
    {
      check.offenders.push_back({ { umbilic.id, -1 }, umbilic.position });
    }
  }
  for (const PictureUmbilic& umbilic : picture.umbilics)
  {
    patches.erase(umbilic.id);
  }
  for (const auto& [id, triangles] : patches) // of no umbilic
  {
    check.offenders.push_back({ { id, -1 }, picture.mesh->Centroid(triangles.front()) });
  }
  return check;
}

CoherenceCheck CheckRidgesInPatches(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges)
{
  CoherenceCheck check(CheckKind::RidgesInPatches, OffenderKind::Ridge);
  for (const WholeRidge& ridge : ridges)
  {
    const Id patch = PatchAround(picture, ridge);
    if (patch >= 0 && !LeadsFromUmbilicToBorder(picture, ridge, patch) &&
      !LeadsFromUmbilicToItself(picture, ridge, patch))
    {
      const Id point = ridge.chains.front().points.front();
      check.offenders.push_back({ { ridge.id, -1 }, picture.points[point].position });
    }
  }
  check.applies = !picture.umbilics.empty();
  return check;
}

CoherenceCheck CheckPatchContours(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges)
{
  CoherenceCheck check(CheckKind::PatchContours, OffenderKind::Umbilic);
  std::map<Id, std::array<int, 2>> counts;
  // Ends of ridges from an umbilic to itself that do not leave its patch.
  std::map<Id, std::array<int, 2>> inside;
  const auto count = [&picture, &counts](Id p, Color color)
  {
    const Id edge = picture.points[p].edge;
    const std::vector<Id> triangles =
      edge >= 0 ? TrianglesAt(*picture.mesh, edge) : std::vector<Id>();
    std::set<Id> patches;
    for (const Id t : triangles)
    {
      patches.insert(picture.patchOf[t]);
    }
    for (const Id patch : patches)
    {
      if (patch >= 0 && (patches.size() > 1 || picture.IsBorder(edge)))
      {
        ++counts[patch][color == Color::Blue ? 0 : 1];
      }
    }
  };
  for (const WholeRidge& ridge : ridges)
  {
    const Id patch = PatchAround(picture, ridge);
    if (patch >= 0 && LeadsFromUmbilicToItself(picture, ridge, patch))
    {
      inside[patch][ridge.color == Color::Blue ? 0 : 1] += 2;
    }
    for (const RidgeChain& chain : ridge.chains)
    {
      for (std::size_t i = chain.closed ? 1 : 0; i < chain.points.size(); ++i)
      {
        count(chain.points[i], ridge.color);
      }
    }
  }
  RidgeCounts first;
  first.umbilics = picture.umbilics.size();
  for (const PictureUmbilic& umbilic : picture.umbilics)
  {
    std::array<int, 2> found = counts[umbilic.id];
    for (std::size_t color = 0; color < found.size(); ++color)
    {
      found[color] += found[color] < umbilic.ridgeCount ? inside[umbilic.id][color] : 0;
    }
    if (!HasItsRidges(picture, umbilic, found))
    {
      if (check.offenders.empty())
      {
        first = { first.umbilics, found[0], found[1], umbilic.ridgeCount };
      }
      check.offenders.push_back({ { umbilic.id, -1 }, umbilic.position });
    }
  }
  check.applies = !picture.umbilics.empty();
  check.numbers = first;
  return check;
}

} // namespace ridges
