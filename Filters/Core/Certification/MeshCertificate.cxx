// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certification/MeshCertificate.h"

#include "Certification/PatchSearch.h"
#include "Mesh/PositionOrder.h"

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

/// From the corner that comes first by position, so that the numbering of points changes nothing.
Triangle FromFirst(const TriangleMesh& mesh, const Triangle& corners)
{
  Triangle result = corners;
  for (int turn = 1; turn < 3; ++turn)
  {
    if (ComesBefore(mesh.Point(corners[turn]), mesh.Point(result[0])))
    {
      result = { corners[turn], corners[(turn + 1) % 3], corners[(turn + 2) % 3] };
    }
  }
  return result;
}

EdgeCertificate CertifyByPosition(const CertifiedInput& input, const Edge& edge, bool isDegenerate)
{
  const bool isReversed = ComesBefore(input.mesh.Point(edge.v1), input.mesh.Point(edge.v0));
  const Id first = isReversed ? edge.v1 : edge.v0;
  const Id second = isReversed ? edge.v0 : edge.v1;
  const MappedTriangle whole = MappedTriangleOf(input, { first, second, second });
  EdgeCertificate result = CertifyEdge(
    input.surface, whole, { input.field.D1(first), input.field.D1(second) }, isDegenerate);
  if (isReversed)
  {
    for (double& parameter : result.parameter)
    {
      parameter = 1.0 - parameter;
    }
  }
  return result;
}

/// As if of a surface that is not generic, to round-off.
enum class Degenerate
{
  No,
  Round, ///< k1 = k2
  Ridge  ///< b0 = 0 or b3 = 0
};

Degenerate DegeneracyOf(double k1, double k2, double b0, double b3)
{
  constexpr double roundOff = 1e-8;
  const double k = std::max(std::abs(k1), std::abs(k2));
  return k1 - k2 <= roundOff * k                               ? Degenerate::Round
    : std::min(std::abs(b0), std::abs(b3)) <= roundOff * k * k ? Degenerate::Ridge
                                                               : Degenerate::No;
}

/// Why no subdivision will help in a triangle: its corners and its middle are all degenerate. 0 if
/// that is not so.
std::uint16_t Degeneracy(const CertifiedInput& input, const Triangle& corners)
{
  const MongeField& field = input.field;
  bool isRound = true;
  for (const Id p : corners)
  {
    const Degenerate found = DegeneracyOf(field.k1[p], field.k2[p],
      field.Extremality(Color::Blue, p), field.Extremality(Color::Red, p));
    if (found == Degenerate::No)
    {
      return 0;
    }
    isRound = isRound && found == Degenerate::Round;
  }
  const MappedTriangle whole = MappedTriangleOf(input, corners);
  const Eigen::Vector3d middle = Eigen::Vector3d::Constant(1.0 / 3.0);
  const Eigen::Vector3d flat = whole.Position(middle);
  const Eigen::Vector3d normal = whole.Normal(middle);
  const Eigen::Vector3d x = flat + HeightAlong(input.surface, flat, normal, 0.0) * normal;
  const PrincipalFrame frame = PrincipalFrameAt(input.surface, x);
  const Eigen::Vector3d d1 = frame.axes.col(0);
  const Degenerate atMiddle = DegeneracyOf(frame.curvature[0], frame.curvature[1],
    ExtremalityAt(input.surface, x, 0, d1), ExtremalityAt(input.surface, x, 1, d1));
  return atMiddle == Degenerate::No ? 0
    : isRound                       ? OneUmbilic | NotGeneric
                                    : NoRidgeInTriangle | NotGeneric;
}

/// Finds what the memory does not have, in parallel, and keeps it.
class MeshSearch
{
public:
  MeshSearch(const CertifiedInput& input, CertificateMemory& memory, const RangeLoop& loop)
    : Input_(input)
    , Memory_(memory)
    , Loop_(loop)
    , Degenerate_(static_cast<std::size_t>(input.mesh.NumberOfTriangles()))
  {
    for (Id t = 0; t < input.mesh.NumberOfTriangles(); ++t)
    {
      this->Degenerate_[t] = Degeneracy(input, input.mesh.Corners(t));
    }
  }

  std::uint16_t DegeneracyOf(Id triangle) const { return this->Degenerate_[triangle]; }

  /// Umbilics that Newton's method reaches from the triangles, and those already known.
  void FindUmbilics()
  {
    const TriangleMesh& mesh = this->Input_.mesh;
    std::vector<Id> starts;
    for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      if (this->Degenerate_[t] == 0 && this->Memory_.IsNewStart(mesh.Corners(t)))
      {
        starts.push_back(t);
      }
    }
    std::vector<std::optional<Eigen::Vector3d>> found(starts.size());
    this->Loop_(static_cast<Id>(starts.size()),
      [this, &mesh, &starts, &found](Id begin, Id end)
      {
        for (Id i = begin; i < end; ++i)
        {
          Eigen::Vector3d x = mesh.Centroid(starts[i]);
          if (FindUmbilic(this->Input_.surface, 2.0 * LongestSide(mesh, starts[i]), x))
          {
            found[i] = x;
          }
        }
      });
    std::vector<std::pair<Eigen::Vector3d, double>> added;
    for (std::size_t i = 0; i < starts.size(); ++i)
    {
      const double side = LongestSide(mesh, starts[i]);
      if (found[i] && this->IsNew(*found[i], 1e-5 * side, added))
      {
        added.emplace_back(*found[i], 8.0 * side);
      }
    }
    std::sort(added.begin(), added.end(),
      [](const auto& a, const auto& b) { return ComesBefore(a.first, b.first); });
    std::vector<UmbilicCertificate> certificates(added.size());
    this->Loop_(static_cast<Id>(added.size()),
      [this, &added, &certificates](Id begin, Id end)
      {
        for (Id i = begin; i < end; ++i)
        {
          certificates[i] = CertifyUmbilic(this->Input_.surface, added[i].first, added[i].second);
        }
      });
    for (std::size_t i = 0; i < certificates.size(); ++i)
    {
      // Of umbilics that are not isolated, as along a curve, a few are enough.
      const double apart = 0.125 * added[i].second;
      if (certificates[i].isIsolated || this->IsNew(added[i].first, apart, {}))
      {
        this->Memory_.umbilics.push_back(certificates[i]);
      }
    }
  }

  void CertifyEdges(const std::vector<Id>& wanted)
  {
    const TriangleMesh& mesh = this->Input_.mesh;
    std::vector<Id> missing;
    std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(missing),
      [this, &mesh](Id e) { return !this->Memory_.Find(mesh.EdgeAt(e)); });
    std::vector<EdgeCertificate> found(missing.size());
    this->Loop_(static_cast<Id>(missing.size()),
      [this, &mesh, &missing, &found](Id begin, Id end)
      {
        for (Id i = begin; i < end; ++i)
        {
          found[i] = this->CertifyOneEdge(mesh.EdgeAt(missing[i]));
        }
      });
    for (std::size_t i = 0; i < missing.size(); ++i)
    {
      this->Memory_.Keep(mesh.EdgeAt(missing[i]), found[i]);
    }
  }

  void CertifyTriangles(const std::vector<Id>& wanted)
  {
    const TriangleMesh& mesh = this->Input_.mesh;
    std::vector<Id> missing;
    std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(missing),
      [this, &mesh](Id t) { return !this->Memory_.Find(mesh.Corners(t)); });
    std::vector<TriangleCertificate> found(missing.size());
    this->Loop_(static_cast<Id>(missing.size()),
      [this, &mesh, &missing, &found](Id begin, Id end)
      {
        for (Id i = begin; i < end; ++i)
        {
          const Id t = missing[i];
          const Triangle corners = FromFirst(mesh, mesh.Corners(t));
          if ((this->Degenerate_[t] & OneUmbilic) != 0)
          {
            found[i].failed = this->Degenerate_[t] | NoRidgeInTriangle;
            found[i].failed |=
              IsMapped(this->Input_.surface, MappedTriangleOf(this->Input_, corners))
              ? std::uint16_t(0)
              : std::uint16_t(MeshFollowsSurface);
            found[i].place = mesh.Centroid(t);
            continue;
          }
          found[i] = CertifyTriangle(this->Input_.surface, MappedTriangleOf(this->Input_, corners),
            this->Degenerate_[t] != 0);
          found[i].failed |= this->Degenerate_[t] & NotGeneric;
          found[i].failed |= this->NotGenericAt(found[i], LongestSide(mesh, t));
        }
      });
    for (std::size_t i = 0; i < missing.size(); ++i)
    {
      this->Memory_.Keep(mesh.Corners(missing[i]), found[i]);
    }
  }

private:
  EdgeCertificate CertifyOneEdge(const Edge& edge) const
  {
    const std::uint16_t degenerate =
      this->Degenerate_[edge.t0] | (edge.t1 < 0 ? std::uint16_t(0) : this->Degenerate_[edge.t1]);
    if ((degenerate & OneUmbilic) == 0)
    {
      EdgeCertificate result = CertifyByPosition(this->Input_, edge, degenerate != 0);
      result.failed |= degenerate & NotGeneric;
      return result;
    }
    EdgeCertificate result;
    result.failed = NotGeneric | NoUmbilicOnEdge | NoRidgeThroughVertex | TransversalCrossings |
      CorrectOrientation | OneCrossing;
    result.place = 0.5 * (this->Input_.mesh.Point(edge.v0) + this->Input_.mesh.Point(edge.v1));
    result.crossings = { -1, -1 };
    return result;
  }

  /// Whether a triangle fails because there are umbilics that are not isolated.
  std::uint16_t NotGenericAt(const TriangleCertificate& found, double side) const
  {
    Eigen::Vector3d x = found.place;
    const bool isThere = (found.failed & OneUmbilic) != 0 && (found.failed & NotGeneric) == 0 &&
      FindUmbilic(this->Input_.surface, 2.0 * side, x);
    return isThere && !CertifyUmbilic(this->Input_.surface, x, side).isIsolated ? NotGeneric : 0;
  }

  bool IsNew(const Eigen::Vector3d& x, double distance,
    const std::vector<std::pair<Eigen::Vector3d, double>>& added) const
  {
    const auto& known = this->Memory_.umbilics;
    return std::none_of(known.begin(), known.end(),
             [&x, distance](const auto& u) { return (u.position - x).norm() <= distance; }) &&
      std::none_of(added.begin(), added.end(),
        [&x, distance](const auto& u) { return (u.first - x).norm() <= distance; });
  }

  const CertifiedInput& Input_;
  CertificateMemory& Memory_;
  const RangeLoop& Loop_;
  std::vector<std::uint16_t> Degenerate_;
};

} // namespace

std::uint16_t MeshCertificate::FailedAt(const TriangleMesh& mesh, Id triangle) const
{
  std::uint16_t failed = this->triangles[triangle] ? this->triangles[triangle]->failed : 0;
  for (int side = 0; side < 3; ++side)
  {
    const auto& edge = this->edges[mesh.EdgeOf(triangle, side)];
    failed |= edge ? edge->failed : 0;
  }
  const Id patch = this->patchOfTriangle[triangle];
  return patch < 0 ? failed : failed | this->patches[patch].failed;
}

bool MeshCertificate::HoldsEverywhere() const
{
  const auto holds = [](const auto& certificate)
  { return !certificate || certificate->failed == 0; };
  return std::all_of(this->edges.begin(), this->edges.end(), holds) &&
    std::all_of(this->triangles.begin(), this->triangles.end(), holds) &&
    std::all_of(this->patches.begin(), this->patches.end(),
      [](const PatchCertificate& patch) { return patch.failed == 0; });
}

std::uint64_t CertificateMemory::KeyOf(const Edge& edge)
{
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(edge.v0)) << 32) |
    static_cast<std::uint32_t>(edge.v1);
}

std::size_t CertificateMemory::TriangleHash::operator()(const Triangle& triangle) const
{
  std::uint64_t hash = 0;
  for (const Id p : triangle)
  {
    hash = (hash ^ static_cast<std::uint32_t>(p)) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 29;
  }
  return hash;
}

const EdgeCertificate* CertificateMemory::Find(const Edge& edge) const
{
  const auto found = this->Edges_.find(KeyOf(edge));
  return found == this->Edges_.end() ? nullptr : &found->second;
}

void CertificateMemory::Keep(const Edge& edge, const EdgeCertificate& certificate)
{
  this->Edges_[KeyOf(edge)] = certificate;
}

const TriangleCertificate* CertificateMemory::Find(const Triangle& triangle) const
{
  const auto found = this->Triangles_.find(triangle);
  return found == this->Triangles_.end() ? nullptr : &found->second;
}

void CertificateMemory::Keep(const Triangle& triangle, const TriangleCertificate& certificate)
{
  this->Triangles_[triangle] = certificate;
}

void CertificateMemory::Forget(const std::vector<std::uint8_t>& moved)
{
  for (auto entry = this->Edges_.begin(); entry != this->Edges_.end();)
  {
    const std::uint64_t key = entry->first;
    const bool isGone = moved[key >> 32] != 0 || moved[key & 0xffffffffU] != 0;
    entry = isGone ? this->Edges_.erase(entry) : std::next(entry);
  }
  for (auto entry = this->Triangles_.begin(); entry != this->Triangles_.end();)
  {
    const Triangle& t = entry->first;
    const bool isGone = moved[t[0]] != 0 || moved[t[1]] != 0 || moved[t[2]] != 0;
    entry = isGone ? this->Triangles_.erase(entry) : std::next(entry);
  }
}

bool CertificateMemory::IsNewStart(const Triangle& triangle)
{
  return this->Starts_.insert(triangle).second;
}

MeshCertificate CertifyMesh(const CertifiedInput& input, CertificateMemory& memory,
  const RangeLoop& loop, const Monitor& monitor)
{
  const TriangleMesh& mesh = input.mesh;
  MeshCertificate result;
  MeshSearch search(input, memory, loop);
  search.FindUmbilics();
  if (!monitor(0.2))
  {
    return result;
  }
  PatchSearch patches(input, memory);
  result.patches = patches.Find(
    memory.umbilics, [&search](const std::vector<Id>& wanted) { search.CertifyEdges(wanted); },
    [&search](const std::vector<Id>& wanted) { search.CertifyTriangles(wanted); });
  result.patchOfTriangle.assign(static_cast<std::size_t>(mesh.NumberOfTriangles()), -1);
  for (std::size_t i = 0; i < result.patches.size(); ++i)
  {
    for (const Id t : result.patches[i].patch)
    {
      result.patchOfTriangle[t] = static_cast<Id>(i);
    }
  }
  if (!monitor(0.3))
  {
    return result;
  }
  const auto isInside = [&mesh, &result](const Edge& edge)
  {
    const Id patch = result.patchOfTriangle[edge.t0];
    return patch >= 0 && edge.t1 >= 0 && result.patchOfTriangle[edge.t1] == patch;
  };
  std::vector<Id> edges;
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    if (!isInside(mesh.EdgeAt(e)))
    {
      edges.push_back(e);
    }
  }
  std::vector<Id> triangles;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (result.patchOfTriangle[t] < 0)
    {
      triangles.push_back(t);
    }
  }
  search.CertifyEdges(edges);
  if (!monitor(0.6))
  {
    return result;
  }
  search.CertifyTriangles(triangles);
  result.edges.resize(static_cast<std::size_t>(mesh.NumberOfEdges()));
  result.triangles.resize(static_cast<std::size_t>(mesh.NumberOfTriangles()));
  for (const Id e : edges)
  {
    result.edges[e] = *memory.Find(mesh.EdgeAt(e));
  }
  for (const Id t : triangles)
  {
    result.triangles[t] = *memory.Find(mesh.Corners(t));
  }
  return result;
}

} // namespace ridges
