// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certification/PatchSearch.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace ridges
{

MappedTriangle MappedTriangleOf(const CertifiedInput& input, const Triangle& corners)
{
  MappedTriangle whole;
  for (int i = 0; i < 3; ++i)
  {
    whole.point[i] = input.mesh.Point(corners[i]);
    whole.normal[i] =
      Eigen::Map<const Eigen::Vector3d>(input.normals + 3 * static_cast<std::size_t>(corners[i]));
  }
  return whole;
}

double LongestSide(const TriangleMesh& mesh, Id triangle)
{
  double longest = 0.0;
  const Triangle& corners = mesh.Corners(triangle);
  for (int i = 0; i < 3; ++i)
  {
    const Eigen::Vector3d side = mesh.Point(corners[(i + 1) % 3]) - mesh.Point(corners[i]);
    longest = std::max(longest, side.norm());
  }
  return longest;
}

namespace
{

/// Covers the round-off of what is computed without intervals.
constexpr double Slack = 1e-12;

/// The weights with which a triangle is mapped to a point, as far as Newton's method gets.
Eigen::Vector3d WeightsOf(const MappedTriangle& whole, const Eigen::Vector3d& x)
{
  Eigen::Vector3d weights = Eigen::Vector3d::Constant(1.0 / 3.0);
  double height = 0.0;
  for (int step = 0; step < 6; ++step)
  {
    const Eigen::Vector3d normal = whole.Normal(weights);
    Eigen::Matrix3d slope;
    slope.col(0) = whole.Position({ -1.0, 1.0, 0.0 }) + height * whole.Normal({ -1.0, 1.0, 0.0 });
    slope.col(1) = whole.Position({ -1.0, 0.0, 1.0 }) + height * whole.Normal({ -1.0, 0.0, 1.0 });
    slope.col(2) = normal;
    const Eigen::Vector3d off = x - whole.Position(weights) - height * normal;
    const Eigen::Vector3d move = slope.inverse() * off;
    weights += Eigen::Vector3d(-move[0] - move[1], move[0], move[1]);
    height += move[2];
  }
  return weights;
}

} // namespace

Id PatchSearch::TriangleOf(const UmbilicCertificate& umbilic) const
{
  const TriangleMesh& mesh = this->Input_.mesh;
  constexpr double tolerance = -1e-6; // on an edge it is in one of two
  Id best = -1;
  double most = tolerance;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if ((mesh.Centroid(t) - umbilic.position).norm() <= 2.0 * LongestSide(mesh, t))
    {
      const double least =
        WeightsOf(MappedTriangleOf(this->Input_, mesh.Corners(t)), umbilic.position).minCoeff();
      if (least > most)
      {
        most = least;
        best = t;
      }
    }
  }
  return best;
}

std::vector<Id> PatchSearch::RingsAround(Id triangle, int rings) const
{
  const TriangleMesh& mesh = this->Input_.mesh;
  std::set<Id> patch{ triangle };
  for (int ring = 0; ring < rings; ++ring)
  {
    const std::vector<Id> before(patch.begin(), patch.end());
    for (const Id t : before)
    {
      for (const Id p : mesh.Corners(t))
      {
        const Span<Id> around = mesh.TrianglesAround(p);
        patch.insert(around.begin(), around.end());
      }
    }
  }
  return { patch.begin(), patch.end() };
}

bool PatchSearch::IsInDisk(const UmbilicCertificate& umbilic, Id triangle) const
{
  const MappedTriangle whole = MappedTriangleOf(this->Input_, this->Input_.mesh.Corners(triangle));
  std::vector<std::pair<Part, int>> tasks{ { Part::WholeTriangle(), 0 } };
  while (!tasks.empty())
  {
    const auto [part, depth] = tasks.back();
    tasks.pop_back();
    const PartBounds bounds = BoundPart(this->Input_.surface, whole, part, 0.0);
    bool isInside = bounds.isMapped;
    if (isInside)
    {
      const Eigen::Vector3d middle = umbilic.frame.transpose() * (bounds.center - umbilic.position);
      const Eigen::Vector3d sides(
        Magnitude(bounds.box[0]), Magnitude(bounds.box[1]), Magnitude(bounds.box[2]));
      const Eigen::Vector3d reach = (umbilic.frame.transpose() * bounds.frame).cwiseAbs() * sides +
        Slack * middle.cwiseAbs() +
        Eigen::Vector3d::Constant(Slack * (sides.sum() + umbilic.position.norm()) + umbilic.error);
      isInside = middle.head<2>().norm() + reach.head<2>().norm() < umbilic.radius &&
        std::abs(middle[2]) + reach[2] < umbilic.height;
    }
    if (isInside)
    {
      continue;
    }
    if (depth == 4)
    {
      return false;
    }
    for (const auto& quarter : Quarters(part.corner))
    {
      tasks.push_back({ { quarter, 3 }, depth + 1 });
    }
  }
  return true;
}

bool PatchSearch::IsDisk(const std::vector<Id>& patch) const
{
  const TriangleMesh& mesh = this->Input_.mesh;
  std::set<Id> points;
  std::set<Id> edges;
  for (const Id t : patch)
  {
    for (int side = 0; side < 3; ++side)
    {
      points.insert(mesh.Corners(t)[side]);
      edges.insert(mesh.EdgeOf(t, side));
      if (mesh.Neighbor(t, side) < 0)
      {
        return false; // at the border of the mesh ridges may leave it
      }
    }
  }
  return points.size() + patch.size() == edges.size() + 1;
}

std::vector<Id> PatchSearch::BorderOf(const std::vector<Id>& patch) const
{
  const TriangleMesh& mesh = this->Input_.mesh;
  std::vector<Id> border;
  for (const Id t : patch)
  {
    for (int side = 0; side < 3; ++side)
    {
      if (!std::binary_search(patch.begin(), patch.end(), mesh.Neighbor(t, side)))
      {
        border.push_back(mesh.EdgeOf(t, side));
      }
    }
  }
  return border;
}

std::uint16_t PatchSearch::FailedOnBorder(
  const UmbilicCertificate& umbilic, const std::vector<Id>& border) const
{
  std::uint16_t failed = 0;
  std::array<int, 2> crossings{};
  int turns = 1;
  for (const Id e : border)
  {
    const EdgeCertificate& edge = *this->Memory_.Find(this->Input_.mesh.EdgeAt(e));
    failed |= edge.failed;
    turns *= edge.orientation;
    crossings[0] += edge.crossings[0];
    crossings[1] += edge.crossings[1];
  }
  // d1 comes back reversed if and only if the umbilic is inside.
  const bool isRight = turns == -1 && crossings == umbilic.ridgeCount;
  return failed == 0 && !isRight ? std::uint16_t(OnlyRidgesOfUmbilic) : failed;
}

/// Whether d1 turns little in the triangles around a patch. In those next to an umbilic it does
/// not, and to refine them brings others as near.
bool PatchSearch::IsIsolatedFrom(const std::vector<Id>& patch, const std::vector<Id>& wider) const
{
  return std::all_of(wider.begin(), wider.end(),
    [this, &patch](Id t)
    {
      return std::binary_search(patch.begin(), patch.end(), t) ||
        (this->Memory_.Find(this->Input_.mesh.Corners(t))->failed & OneUmbilic) == 0;
    });
}

/// The smallest patch that is isolated or, without one, the largest that has the right border.
void PatchSearch::Choose(
  const Certify& certifyEdges, const Certify& certifyTriangles, PatchCertificate& found) const
{
  constexpr int mostRings = 4;
  found.patch = this->RingsAround(found.triangle, 1);
  for (int rings = 0; rings <= mostRings; ++rings)
  {
    const std::vector<Id> patch = this->RingsAround(found.triangle, rings);
    const bool isInside = this->IsDisk(patch) &&
      std::all_of(patch.begin(), patch.end(),
        [this, &found](Id t) { return this->IsInDisk(found.umbilic, t); });
    if (!isInside)
    {
      return;
    }
    const std::vector<Id> border = this->BorderOf(patch);
    certifyEdges(border);
    const std::uint16_t failed = this->FailedOnBorder(found.umbilic, border);
    if (failed != 0)
    {
      if (found.failed != 0)
      {
        found.patch = patch;
        found.failed = OnlyRidgesOfUmbilic;
      }
      continue;
    }
    found.patch = patch;
    found.failed = 0;
    const std::vector<Id> wider = this->RingsAround(found.triangle, rings + 1);
    std::vector<Id> around;
    std::set_difference(
      wider.begin(), wider.end(), patch.begin(), patch.end(), std::back_inserter(around));
    certifyTriangles(around);
    if (rings > 0 && this->IsIsolatedFrom(patch, wider))
    {
      return;
    }
  }
}

std::vector<PatchCertificate> PatchSearch::Find(const std::vector<UmbilicCertificate>& umbilics,
  const Certify& certifyEdges, const Certify& certifyTriangles)
{
  std::vector<PatchCertificate> result;
  std::set<Id> taken;
  for (const UmbilicCertificate& umbilic : umbilics)
  {
    PatchCertificate found{ umbilic, this->TriangleOf(umbilic), {}, 0 };
    if (found.triangle < 0)
    {
      continue;
    }
    // As long as nothing is known of a patch.
    found.failed = MeshFollowsSurface | OneUmbilic | NoRidgeInPatch | OnlyRidgesOfUmbilic;
    if (umbilic.radius > 0.0)
    {
      this->Choose(certifyEdges, certifyTriangles, found);
    }
    else // by the surface alone
    {
      found.patch = this->RingsAround(found.triangle, 1);
      found.failed |= NotGeneric;
    }
    const bool isFree = std::none_of(
      found.patch.begin(), found.patch.end(), [&taken](Id t) { return taken.count(t) > 0; });
    found.failed |= isFree ? std::uint16_t(0) : std::uint16_t(DisjointPatches);
    taken.insert(found.patch.begin(), found.patch.end());
    result.push_back(std::move(found));
  }
  return result;
}

} // namespace ridges
