// SPDX-License-Identifier: BSD-3-Clause
#include "RidgeGraph.h"

#include "EndMatching.h"
#include "FilterTestTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
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

using EdgeKey = std::pair<vtkIdType, vtkIdType>;

EdgeKey KeyOf(vtkIdType p, vtkIdType q)
{
  return { std::min(p, q), std::max(p, q) };
}

std::vector<vtkIdType> LineIds(vtkPolyData* ridges, vtkIdType line)
{
  vtkNew<vtkIdList> ids;
  ridges->GetLines()->GetCellAtId(line, ids);
  return { ids->begin(), ids->end() };
}

EdgeKey EdgeOfPoint(vtkPolyData* ridges, vtkIdType point)
{
  return { static_cast<vtkIdType>(Value(ridges->GetPointData(), "EdgePoint0", point)),
    static_cast<vtkIdType>(Value(ridges->GetPointData(), "EdgePoint1", point)) };
}

/// The usable triangles of a mesh with Monge arrays, and the acute rule on them.
class MongeMesh
{
public:
  explicit MongeMesh(vtkPolyData* mesh)
    : Mesh_(mesh)
  {
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
    {
      mesh->GetPolys()->GetCellAtId(cell, ids);
      const std::vector<vtkIdType> corners(ids->begin(), ids->end());
      const bool distinct = std::set<vtkIdType>(corners.begin(), corners.end()).size() == 3;
      if (distinct &&
        std::all_of(
          corners.begin(), corners.end(), [this](vtkIdType p) { return this->IsUsable(p); }))
      {
        for (int i = 0; i < 3; ++i)
        {
          this->Sides[KeyOf(corners[i], corners[(i + 1) % 3])].push_back(this->Triangles.size());
        }
        this->Triangles.push_back({ corners[0], corners[1], corners[2] });
      }
    }
  }

  bool Crosses(const EdgeKey& edge, bool maximum) const
  {
    const auto sign = [&](vtkIdType p) {
      return Value(this->Mesh_->GetPointData(), "ThirdOrder", p, maximum ? 0 : 3) >= 0.0 ? 1 : -1;
    };
    return this->AcuteSign(edge) * sign(edge.first) * sign(edge.second) < 0;
  }

  bool IsSingular(std::size_t triangle) const
  {
    const auto& t = this->Triangles[triangle];
    return this->AcuteSign({ t[0], t[1] }) * this->AcuteSign({ t[1], t[2] }) *
      this->AcuteSign({ t[2], t[0] }) <
      0;
  }

  bool Contains(std::size_t triangle, const Eigen::Vector3d& x) const
  {
    const auto& t = this->Triangles[triangle];
    const Eigen::Vector3d origin = PointAt(this->Mesh_, t[0]);
    Eigen::Matrix3d sides;
    sides.col(0) = PointAt(this->Mesh_, t[1]) - origin;
    sides.col(1) = PointAt(this->Mesh_, t[2]) - origin;
    sides.col(2) = sides.col(0).cross(sides.col(1)).normalized() * sides.col(0).norm();
    const Eigen::Vector3d weights = sides.fullPivLu().solve(x - origin);
    constexpr double tolerance = 1e-9; // far above round-off, far below the size of a triangle
    return weights[0] >= -tolerance && weights[1] >= -tolerance &&
      weights[0] + weights[1] <= 1.0 + tolerance && std::abs(weights[2]) <= tolerance;
  }

  std::vector<std::array<vtkIdType, 3>> Triangles;
  std::map<EdgeKey, std::vector<std::size_t>> Sides;

private:
  bool IsUsable(vtkIdType p) const
  {
    vtkDataArray* status = this->Mesh_->GetPointData()->GetArray("FitStatus");
    return !status || !(static_cast<int>(status->GetComponent(p, 0)) & 8);
  }

  int AcuteSign(const EdgeKey& edge) const
  {
    vtkPointData* data = this->Mesh_->GetPointData();
    const Eigen::Vector3d d = VectorAt(data, "MaximumDirection", edge.first);
    return d.dot(VectorAt(data, "MaximumDirection", edge.second)) >= 0.0 ? 1 : -1;
  }

  vtkPolyData* Mesh_;
};

/// The points of one colour, with the points they are joined to.
using Joined = std::map<vtkIdType, std::vector<vtkIdType>>;

Joined JoinPoints(vtkPolyData* ridges, bool maximum)
{
  Joined joined;
  for (vtkIdType line = 0; line < ridges->GetNumberOfLines(); ++line)
  {
    const int type = static_cast<int>(Value(ridges->GetCellData(), "RidgeType", line));
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

/// The singular triangles that contain the point and have all the edges of its neighbours.
std::vector<std::size_t> SingularTrianglesOf(const MongeMesh& mesh, vtkPolyData* ridges,
  vtkIdType point, const std::vector<vtkIdType>& neighbors)
{
  std::vector<std::size_t> triangles;
  const auto sides = mesh.Sides.find(EdgeOfPoint(ridges, neighbors.front()));
  if (sides != mesh.Sides.end())
  {
    for (const std::size_t t : sides->second)
    {
      const bool hasAll = std::all_of(neighbors.begin(), neighbors.end(),
        [&](vtkIdType neighbor)
        {
          const auto other = mesh.Sides.find(EdgeOfPoint(ridges, neighbor));
          return other != mesh.Sides.end() &&
            std::find(other->second.begin(), other->second.end(), t) != other->second.end();
        });
      if (hasAll && mesh.IsSingular(t) && mesh.Contains(t, PointAt(ridges, point)))
      {
        triangles.push_back(t);
      }
    }
  }
  return triangles;
}

void ExpectPointsOnEdges(vtkPolyData* mesh, vtkPolyData* ridges)
{
  double size = 0.0;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    size = std::max(size, PointAt(mesh, p).cwiseAbs().maxCoeff());
  }
  for (vtkIdType i = 0; i < ridges->GetNumberOfPoints(); ++i)
  {
    const EdgeKey edge = EdgeOfPoint(ridges, i);
    const double t = Value(ridges->GetPointData(), "EdgeParameter", i);
    ASSERT_TRUE(t >= 0.0 && t <= 1.0) << t;
    if (edge.first < 0)
    {
      ASSERT_EQ(edge.second, -1);
      continue;
    }
    ASSERT_LT(edge.first, edge.second);
    const Eigen::Vector3d expected =
      (1.0 - t) * PointAt(mesh, edge.first) + t * PointAt(mesh, edge.second);
    // Round-off only.
    ASSERT_LE((PointAt(ridges, i) - expected).norm(), 1e-15 * size) << i;
  }
}

void ExpectCompleteColor(
  const MongeMesh& mesh, vtkPolyData* ridges, const Joined& joined, bool maximum)
{
  std::map<EdgeKey, std::size_t> pointsOnEdge;
  std::vector<std::vector<std::size_t>> ends;
  for (const auto& [point, neighbors] : joined)
  {
    const EdgeKey edge = EdgeOfPoint(ridges, point);
    if (edge.first < 0)
    {
      ASSERT_TRUE(neighbors.size() == 1 || neighbors.size() == 3) << neighbors.size();
      ends.push_back(SingularTrianglesOf(mesh, ridges, point, neighbors));
      ASSERT_FALSE(ends.back().empty()) << "a ridge ends in a regular triangle";
      continue;
    }
    ++pointsOnEdge[edge];
    const auto sides = mesh.Sides.find(edge);
    ASSERT_NE(sides, mesh.Sides.end()) << "no such edge";
    ASSERT_EQ(neighbors.size(), sides->second.size() == 2 ? 2u : 1u)
      << "at the edge " << edge.first << " " << edge.second;
  }
  for (const auto& [edge, sides] : mesh.Sides)
  {
    const std::size_t stops = sides.size() <= 2 ? 1 : sides.size();
    const std::size_t expected = mesh.Crosses(edge, maximum) ? stops : 0;
    const auto found = pointsOnEdge.find(edge);
    ASSERT_EQ(found == pointsOnEdge.end() ? 0 : found->second, expected)
      << "at the edge " << edge.first << " " << edge.second;
  }
  std::size_t singular = 0;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    singular += mesh.IsSingular(t) ? 1 : 0;
  }
  ASSERT_EQ(ends.size(), singular);
  ASSERT_TRUE(EndMatching(ends).Match()) << "two umbilics in one triangle";
}

} // namespace

void ExpectCompleteRidgeGraph(vtkPolyData* mesh, vtkPolyData* ridges)
{
  ExpectPointsOnEdges(mesh, ridges);
  const MongeMesh mongeMesh(mesh);
  for (const bool maximum : { true, false })
  {
    SCOPED_TRACE(maximum ? "maximum" : "minimum");
    ExpectCompleteColor(mongeMesh, ridges, JoinPoints(ridges, maximum), maximum);
  }
}

void ExpectJoinedPolylines(vtkPolyData* ridges)
{
  vtkCellData* data = ridges->GetCellData();
  const vtkIdType count = ridges->GetNumberOfLines();
  for (vtkIdType first = 0; first < count;)
  {
    const double id = Value(data, "RidgeId", first);
    vtkIdType last = first;
    for (; last + 1 < count && Value(data, "RidgeId", last + 1) == id; ++last)
    {
      ASSERT_EQ(LineIds(ridges, last).back(), LineIds(ridges, last + 1).front()) << last;
      ASSERT_EQ(Value(data, "Closed", last), Value(data, "Closed", last + 1));
    }
    const bool comesBack = LineIds(ridges, first).front() == LineIds(ridges, last).back();
    if (Value(data, "Closed", first) != 0.0)
    {
      ASSERT_TRUE(comesBack) << "ridge " << id;
    }
    first = last + 1;
  }
}

} // namespace testing
} // namespace ridges
