// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RidgeGraph.h"

#include "EndMatching.h"
#include "FilterTestTools.h"
#include "MongeMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace ridges
{
namespace testing
{
namespace
{

namespace names = vtkRidgesArrayNames;

std::vector<vtkIdType> LineIds(vtkPolyData* ridges, vtkIdType line)
{
  vtkNew<vtkIdList> ids;
  ridges->GetLines()->GetCellAtId(line, ids);
  return { ids->begin(), ids->end() };
}

EdgeKey EdgeOfPoint(vtkPolyData* ridges, vtkIdType point)
{
  return { static_cast<vtkIdType>(Value(ridges->GetPointData(), names::EdgePoint0, point)),
    static_cast<vtkIdType>(Value(ridges->GetPointData(), names::EdgePoint1, point)) };
}

bool IsOnEdge(vtkPolyData* ridges, vtkIdType point)
{
  return EdgeOfPoint(ridges, point).first >= 0;
}

bool IsTurningPointInTriangle(vtkPolyData* ridges, vtkIdType point)
{
  return !IsOnEdge(ridges, point) &&
    Value(ridges->GetPointData(), names::TurningPoint, point) != 0.0;
}

/// The points of one colour, with the points they are joined to.
using Joined = std::map<vtkIdType, std::vector<vtkIdType>>;

Joined JoinPoints(vtkPolyData* ridges, bool maximum)
{
  Joined joined;
  for (vtkIdType line = 0; line < ridges->GetNumberOfLines(); ++line)
  {
    const int type = static_cast<int>(Value(ridges->GetCellData(), names::RidgeType, line));
    if ((type <= 2) == maximum)
    {
      const std::vector<vtkIdType> ids = LineIds(ridges, line);
      for (std::size_t i = 0; i + 1 < ids.size(); ++i)
      {
        joined[ids[i]].push_back(ids[i + 1]);
        joined[ids[i + 1]].push_back(ids[i]);
      }
    }
  }
  return joined;
}

double SizeOf(vtkPolyData* data)
{
  double size = 0.0;
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    size = std::max(size, PointAt(data, p).cwiseAbs().maxCoeff());
  }
  return size;
}

void ExpectPointsOnEdges(vtkPolyData* mesh, vtkPolyData* ridges)
{
  const double size = SizeOf(ridges);
  for (vtkIdType i = 0; i < ridges->GetNumberOfPoints(); ++i)
  {
    const EdgeKey edge = EdgeOfPoint(ridges, i);
    const double t = Value(ridges->GetPointData(), names::EdgeParameter, i);
    ASSERT_TRUE(t >= 0.0 && t <= 1.0) << t;
    if (edge.first < 0)
    {
      ASSERT_EQ(edge.second, -1);
      continue;
    }
    ASSERT_LT(edge.first, edge.second);
    ASSERT_EQ(Value(ridges->GetPointData(), names::Umbilic, i), -1.0);
    const Eigen::Vector3d expected =
      (1.0 - t) * PointAt(mesh, edge.first) + t * PointAt(mesh, edge.second);
    // Round-off only.
    ASSERT_LE((PointAt(ridges, i) - expected).norm(), 1e-15 * size) << i;
  }
}

/// Takes turning points inside triangles out of the pieces that they lie on.
void SpliceTurningPoints(const MongeMesh& mesh, vtkPolyData* ridges, Joined& joined)
{
  const double roundOff = 1e-14 * SizeOf(ridges);
  for (auto at = joined.begin(); at != joined.end();)
  {
    const vtkIdType point = at->first;
    if (!IsTurningPointInTriangle(ridges, point))
    {
      ++at;
      continue;
    }
    ASSERT_EQ(Value(ridges->GetPointData(), names::Umbilic, point), -1.0);
    ASSERT_EQ(at->second.size(), 2u) << "at a turning point";
    const vtkIdType a = at->second[0];
    const vtkIdType b = at->second[1];
    ASSERT_TRUE(IsOnEdge(ridges, a) && IsOnEdge(ridges, b));
    ASSERT_FALSE(mesh.TrianglesWith({ EdgeOfPoint(ridges, a), EdgeOfPoint(ridges, b) }).empty());
    const Eigen::Vector3d x = PointAt(ridges, point);
    const double there = (x - PointAt(ridges, a)).norm() + (x - PointAt(ridges, b)).norm();
    ASSERT_LE(there - (PointAt(ridges, a) - PointAt(ridges, b)).norm(), roundOff);
    std::replace(joined[a].begin(), joined[a].end(), point, b);
    std::replace(joined[b].begin(), joined[b].end(), point, a);
    at = joined.erase(at);
  }
}

/// One colour on the mesh, without its turning points.
class ColorCheck
{
public:
  ColorCheck(const MongeMesh& mesh, vtkPolyData* ridges, const Joined& joined, bool maximum)
    : Mesh_(mesh)
    , Ridges_(ridges)
    , Joined_(joined)
    , Maximum_(maximum)
  {
  }

  void ExpectCrossings() const;
  void ExpectEnds();
  void ExpectNoPiecesCross() const;

private:
  /// A piece in a triangle, from one place on its border to another, or to an umbilic inside.
  struct Piece
  {
    double from;
    double to; ///< Negative at an umbilic.
  };

  std::vector<EdgeKey> EdgesOf(const std::vector<vtkIdType>& points) const;
  std::vector<std::size_t> SingularTrianglesOf(
    vtkIdType point, const std::vector<vtkIdType>& neighbors) const;
  std::size_t ExpectedEndsAt(const MongeMesh::Region& region, std::size_t crossings) const;
  bool MayBeDrawnAnew(std::size_t region) const;
  std::vector<std::size_t> EarsAmong(
    const std::vector<std::size_t>& triangles, const EdgeKey& edge) const;
  double PlaceOnBorder(std::size_t triangle, vtkIdType point) const;
  static bool Cross(const Piece& a, const Piece& b);

  const MongeMesh& Mesh_;
  vtkPolyData* Ridges_;
  const Joined& Joined_;
  bool Maximum_;
  std::map<vtkIdType, std::size_t> TriangleOfUmbilic_;
};

std::vector<EdgeKey> ColorCheck::EdgesOf(const std::vector<vtkIdType>& points) const
{
  std::vector<EdgeKey> edges;
  edges.reserve(points.size());
  for (const vtkIdType point : points)
  {
    edges.push_back(EdgeOfPoint(this->Ridges_, point));
  }
  return edges;
}

void ColorCheck::ExpectCrossings() const
{
  std::map<EdgeKey, std::size_t> pointsOnEdge;
  for (const auto& [point, neighbors] : this->Joined_)
  {
    if (IsOnEdge(this->Ridges_, point))
    {
      const EdgeKey edge = EdgeOfPoint(this->Ridges_, point);
      ++pointsOnEdge[edge];
      const auto sides = this->Mesh_.sides.find(edge);
      ASSERT_NE(sides, this->Mesh_.sides.end()) << "no such edge";
      ASSERT_EQ(neighbors.size(), sides->second.size() == 2 ? 2u : 1u)
        << "at the edge " << edge.first << " " << edge.second;
    }
  }
  for (const auto& [edge, sides] : this->Mesh_.sides)
  {
    const std::size_t region = this->Mesh_.RegionAround(edge);
    if (region != MongeMesh::None && this->MayBeDrawnAnew(region))
    {
      continue;
    }
    const std::size_t stops = sides.size() <= 2 ? 1 : sides.size();
    const std::size_t expected = this->Mesh_.Crosses(edge, this->Maximum_) ? stops : 0;
    const auto found = pointsOnEdge.find(edge);
    ASSERT_EQ(found == pointsOnEdge.end() ? 0 : found->second, expected)
      << "at the edge " << edge.first << " " << edge.second;
  }
}

/// False where the acute rule alone draws a region for certain: where no triangle is singular, or
/// only that of an umbilic of one ridge at which one arrives, which then comes from the contour.
/// (Of three ridges two might join.)
bool ColorCheck::MayBeDrawnAnew(std::size_t region) const
{
  const MongeMesh::Region& r = this->Mesh_.regions[region];
  const auto isSingular = [this](std::size_t t) { return this->Mesh_.IsSingular(t); };
  const auto singular = std::count_if(r.triangles.begin(), r.triangles.end(), isSingular);
  if (singular == 0)
  {
    return false;
  }
  if (singular > 1 || r.umbilic == MongeMesh::None || !isSingular(r.umbilic) || r.ridgeCount != 1 ||
    !this->Mesh_.IsDisk(r))
  {
    return true;
  }
  int arriving = 0;
  for (int side = 0; side < 3; ++side)
  {
    const EdgeKey edge = this->Mesh_.SideOf(r.umbilic, side);
    arriving += this->Mesh_.Crosses(edge, this->Maximum_) ? 1 : 0;
  }
  return arriving != 1;
}

std::vector<std::size_t> ColorCheck::SingularTrianglesOf(
  vtkIdType point, const std::vector<vtkIdType>& neighbors) const
{
  std::vector<std::size_t> triangles;
  for (const std::size_t t : this->Mesh_.TrianglesWith(this->EdgesOf(neighbors)))
  {
    const std::size_t region = this->Mesh_.regionOf[t];
    const bool marched = region == MongeMesh::None || !this->MayBeDrawnAnew(region);
    if (marched && this->Mesh_.IsSingular(t) &&
      this->Mesh_.Contains(t, PointAt(this->Ridges_, point)))
    {
      triangles.push_back(t);
    }
  }
  return triangles;
}

/// Crossings are joined in pairs until no more are left than have to meet at the umbilic.
std::size_t ColorCheck::ExpectedEndsAt(const MongeMesh::Region& region, std::size_t crossings) const
{
  const bool anySingular = std::any_of(region.triangles.begin(), region.triangles.end(),
    [this](std::size_t t) { return this->Mesh_.IsSingular(t); });
  const auto wanted = static_cast<std::size_t>(region.ridgeCount);
  if (!anySingular)
  {
    return 0;
  }
  return crossings <= wanted ? crossings : wanted - (crossings - wanted) % 2;
}

void ColorCheck::ExpectEnds()
{
  std::vector<std::vector<std::size_t>> ends;
  std::map<std::size_t, std::size_t> endsAtUmbilic;
  for (const auto& [point, neighbors] : this->Joined_)
  {
    if (IsOnEdge(this->Ridges_, point))
    {
      continue;
    }
    const auto umbilic =
      static_cast<vtkIdType>(Value(this->Ridges_->GetPointData(), names::Umbilic, point));
    if (umbilic < 0)
    {
      ASSERT_TRUE(neighbors.size() == 1 || neighbors.size() == 3) << neighbors.size();
      ends.push_back(this->SingularTrianglesOf(point, neighbors));
      ASSERT_FALSE(ends.back().empty()) << "a ridge ends in a regular triangle or in a patch";
      this->TriangleOfUmbilic_[point] = ends.back().front();
      continue;
    }
    ASSERT_LT(static_cast<std::size_t>(umbilic), this->Mesh_.regions.size());
    const std::size_t t = this->Mesh_.regions[umbilic].umbilic;
    ASSERT_NE(t, MongeMesh::None) << "an umbilic without a triangle";
    ASSERT_TRUE(this->Mesh_.Contains(t, PointAt(this->Ridges_, point)));
    for (const vtkIdType neighbor : neighbors)
    {
      const EdgeKey edge = EdgeOfPoint(this->Ridges_, neighbor);
      ASSERT_TRUE(edge == this->Mesh_.SideOf(t, 0) || edge == this->Mesh_.SideOf(t, 1) ||
        edge == this->Mesh_.SideOf(t, 2));
    }
    ASSERT_EQ(endsAtUmbilic.count(umbilic), 0u) << "two points for one umbilic";
    endsAtUmbilic[umbilic] = neighbors.size();
    this->TriangleOfUmbilic_[point] = t;
  }
  for (std::size_t r = 0; r < this->Mesh_.regions.size(); ++r)
  {
    const MongeMesh::Region& region = this->Mesh_.regions[r];
    if (region.umbilic != MongeMesh::None && this->Mesh_.IsDisk(region))
    {
      ASSERT_EQ(endsAtUmbilic[r],
        this->ExpectedEndsAt(region, this->Mesh_.CountContourCrossings(r, this->Maximum_)))
        << "at umbilic " << r;
    }
  }
  std::size_t singular = 0;
  for (std::size_t t = 0; t < this->Mesh_.triangles.size(); ++t)
  {
    const std::size_t region = this->Mesh_.regionOf[t];
    const bool marched = region == MongeMesh::None ||
      (!this->MayBeDrawnAnew(region) && this->Mesh_.regions[region].umbilic != t);
    singular += marched && this->Mesh_.IsSingular(t) ? 1 : 0;
  }
  ASSERT_EQ(ends.size(), singular);
  ASSERT_TRUE(EndMatching(ends).Match()) << "two umbilics in one triangle";
}

/// Of the triangles at an edge those that hang on their region by this edge alone.
std::vector<std::size_t> ColorCheck::EarsAmong(
  const std::vector<std::size_t>& triangles, const EdgeKey& edge) const
{
  std::vector<std::size_t> ears;
  for (const std::size_t t : triangles)
  {
    int inner = 0;
    for (int side = 0; side < 3; ++side)
    {
      const EdgeKey other = this->Mesh_.SideOf(t, side);
      inner += other != edge && this->Mesh_.RegionAround(other) != MongeMesh::None ? 1 : 0;
    }
    if (inner == 0)
    {
      ears.push_back(t);
    }
  }
  return ears;
}

/// From 0 to 3 around the triangle.
double ColorCheck::PlaceOnBorder(std::size_t triangle, vtkIdType point) const
{
  const EdgeKey edge = EdgeOfPoint(this->Ridges_, point);
  const double t = Value(this->Ridges_->GetPointData(), names::EdgeParameter, point);
  int side = 0;
  while (this->Mesh_.SideOf(triangle, side) != edge)
  {
    ++side;
  }
  const bool forward = this->Mesh_.triangles[triangle][side] == edge.first;
  return std::fmod(side + (forward ? t : 1.0 - t), 3.0);
}

/// Whether their ends alternate around the triangle.
bool ColorCheck::Cross(const Piece& a, const Piece& b)
{
  if (a.to < 0.0 || b.to < 0.0)
  {
    return false; // lines to one point, or seen to by ExpectNoPiecesCross
  }
  const double low = std::min(a.from, a.to);
  const double high = std::max(a.from, a.to);
  const auto where = [&](double x)
  { return x > low && x < high ? 1 : (x < low || x > high ? 2 : 0); };
  return where(b.from) + where(b.to) == 3 && where(b.from) != 0 && where(b.to) != 0;
}

void ColorCheck::ExpectNoPiecesCross() const
{
  std::map<std::size_t, std::vector<Piece>> pieces;
  for (const auto& [point, neighbors] : this->Joined_)
  {
    for (const vtkIdType neighbor : neighbors)
    {
      const auto umbilic = this->TriangleOfUmbilic_.find(neighbor);
      if (umbilic != this->TriangleOfUmbilic_.end())
      {
        pieces[umbilic->second].push_back({ this->PlaceOnBorder(umbilic->second, point), -1.0 });
      }
      else if (point < neighbor && IsOnEdge(this->Ridges_, point))
      {
        const EdgeKey from = EdgeOfPoint(this->Ridges_, point);
        const EdgeKey to = EdgeOfPoint(this->Ridges_, neighbor);
        const auto triangles = this->Mesh_.TrianglesWith({ from, to });
        ASSERT_FALSE(triangles.empty()) << "a piece outside all triangles";
        // Along the contour of a patch a piece may follow the inner edge of a triangle.
        ASSERT_TRUE(from != to || this->Mesh_.RegionAround(from) != MongeMesh::None);
        const auto inside = from == to ? this->EarsAmong(triangles, from) : triangles;
        if (inside.size() == 1)
        {
          pieces[inside[0]].push_back(
            { this->PlaceOnBorder(inside[0], point), this->PlaceOnBorder(inside[0], neighbor) });
        }
      }
    }
  }
  for (const auto& [triangle, inside] : pieces)
  {
    for (std::size_t i = 0; i < inside.size(); ++i)
    {
      // All that run to an umbilic leave any other piece on one side.
      for (std::size_t j = 0; j < i; ++j)
      {
        ASSERT_FALSE(Cross(inside[i], inside[j]))
          << "in triangle " << triangle << ": from " << inside[i].from << " to " << inside[i].to
          << ", and from " << inside[j].from << " to " << inside[j].to;
        if (inside[i].to < 0.0 && inside[j].to < 0.0)
        {
          const Piece both = { inside[i].from, inside[j].from };
          const bool crossed = std::any_of(
            inside.begin(), inside.end(), [&](const Piece& other) { return Cross(both, other); });
          ASSERT_FALSE(crossed) << "at the umbilic in triangle " << triangle;
        }
      }
    }
  }
}

} // namespace

void ExpectCompleteRidgeGraph(vtkPolyData* mesh, vtkPolyData* ridges)
{
  ExpectPointsOnEdges(mesh, ridges);
  const MongeMesh mongeMesh(mesh);
  for (const bool maximum : { true, false })
  {
    SCOPED_TRACE(maximum ? "maximum" : "minimum");
    Joined joined = JoinPoints(ridges, maximum);
    ASSERT_NO_FATAL_FAILURE(SpliceTurningPoints(mongeMesh, ridges, joined));
    ColorCheck check(mongeMesh, ridges, joined, maximum);
    ASSERT_NO_FATAL_FAILURE(check.ExpectCrossings());
    ASSERT_NO_FATAL_FAILURE(check.ExpectEnds());
  }
}

void ExpectNoRidgesCross(vtkPolyData* mesh, vtkPolyData* ridges)
{
  const MongeMesh mongeMesh(mesh);
  for (const bool maximum : { true, false })
  {
    SCOPED_TRACE(maximum ? "maximum" : "minimum");
    Joined joined = JoinPoints(ridges, maximum);
    ASSERT_NO_FATAL_FAILURE(SpliceTurningPoints(mongeMesh, ridges, joined));
    ColorCheck check(mongeMesh, ridges, joined, maximum);
    ASSERT_NO_FATAL_FAILURE(check.ExpectEnds());
    ASSERT_NO_FATAL_FAILURE(check.ExpectNoPiecesCross());
  }
}

void ExpectJoinedPolylines(vtkPolyData* ridges)
{
  vtkCellData* data = ridges->GetCellData();
  const vtkIdType count = ridges->GetNumberOfLines();
  double ridge = 0.0;
  for (vtkIdType first = 0; first < count; ridge += 1.0)
  {
    ASSERT_EQ(Value(data, names::RidgeId, first), ridge);
    vtkIdType last = first;
    for (; last + 1 < count && Value(data, names::RidgeId, last + 1) == ridge; ++last)
    {
      ASSERT_EQ(LineIds(ridges, last).back(), LineIds(ridges, last + 1).front()) << last;
      ASSERT_EQ(Value(data, names::Closed, last), Value(data, names::Closed, last + 1));
    }
    const bool comesBack = LineIds(ridges, first).front() == LineIds(ridges, last).back();
    if (Value(data, names::Closed, first) != 0.0)
    {
      ASSERT_TRUE(comesBack) << "ridge " << ridge;
    }
    first = last + 1;
  }
}

} // namespace testing
} // namespace ridges
