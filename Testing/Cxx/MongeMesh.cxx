// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MongeMesh.h"

#include "FilterTestTools.h"
#include "vtkRidgesUmbilicInput.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <set>

namespace ridges
{
namespace testing
{

namespace names = vtkRidgesArrayNames;

EdgeKey KeyOf(vtkIdType p, vtkIdType q)
{
  return { std::min(p, q), std::max(p, q) };
}

MongeMesh::MongeMesh(vtkPolyData* mesh)
  : Mesh_(mesh)
{
  this->FetchPoints();
  vtkNew<vtkIdList> ids;
  std::vector<vtkIdType> cells;
  const vtkIdType firstPoly = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    const std::vector<vtkIdType> corners(ids->begin(), ids->end());
    const bool distinct = std::set<vtkIdType>(corners.begin(), corners.end()).size() == 3;
    const auto isUsable = [this](vtkIdType p) { return this->IsUsable_[p]; };
    if (distinct && std::all_of(corners.begin(), corners.end(), isUsable))
    {
      for (int i = 0; i < 3; ++i)
      {
        this->sides[KeyOf(corners[i], corners[(i + 1) % 3])].push_back(this->triangles.size());
      }
      this->triangles.push_back({ corners[0], corners[1], corners[2] });
      cells.push_back(firstPoly + cell);
    }
  }
  this->FetchRegions(cells);
}

void MongeMesh::FetchPoints()
{
  vtkPointData* data = this->Mesh_->GetPointData();
  vtkDataArray* status = data->GetArray(names::FitStatus);
  vtkDataArray* directions = data->GetArray(names::MaximumDirection);
  vtkDataArray* thirdOrder = data->GetArray(names::ThirdOrder);
  for (vtkIdType p = 0; p < this->Mesh_->GetNumberOfPoints(); ++p)
  {
    this->IsUsable_.push_back(!status || !(static_cast<int>(status->GetComponent(p, 0)) & 8));
    Eigen::Vector3d d;
    directions->GetTuple(p, d.data());
    this->Directions_.push_back(d);
    this->Extremalities_.push_back(
      { thirdOrder->GetComponent(p, 0), thirdOrder->GetComponent(p, 3) });
  }
}

void MongeMesh::FetchRegions(const std::vector<vtkIdType>& cells)
{
  this->regionOf.assign(this->triangles.size(), None);
  vtkRidgesUmbilicInput input;
  input.FetchFromMesh(this->Mesh_);
  const auto& umbilics = input.GetUmbilics();
  for (const vtkRidgesUmbilicInput::Umbilic& umbilic : umbilics)
  {
    this->regions.emplace_back();
    this->regions.back().ridgeCount = umbilic.ridgeCount;
  }
  const vtkRidgesRegions patches(this->Mesh_, names::UmbilicPatch);
  const vtkRidgesRegions cancelled(this->Mesh_, names::CancelledUmbilics);
  for (std::size_t t = 0; t < cells.size(); ++t)
  {
    const vtkIdType inPatch = patches.At(cells[t]);
    const vtkIdType inCancelled = cancelled.At(cells[t]);
    if (inPatch < 0 && inCancelled < 0)
    {
      continue;
    }
    const std::size_t region = inPatch >= 0
      ? static_cast<std::size_t>(inPatch)
      : umbilics.size() + static_cast<std::size_t>(inCancelled);
    this->regions.resize(std::max(this->regions.size(), region + 1));
    this->regionOf[t] = region;
    this->regions[region].triangles.push_back(t);
    if (inPatch >= 0 && region < umbilics.size() && umbilics[region].cell == cells[t])
    {
      this->regions[region].umbilic = t;
    }
  }
}

bool MongeMesh::Crosses(const EdgeKey& edge, bool maximum) const
{
  const auto sign = [&](vtkIdType p)
  { return this->Extremalities_[p][maximum ? 0 : 1] >= 0.0 ? 1 : -1; };
  return this->AcuteSign(edge) * sign(edge.first) * sign(edge.second) < 0;
}

bool MongeMesh::IsSingular(std::size_t triangle) const
{
  const auto& t = this->triangles[triangle];
  return this->AcuteSign({ t[0], t[1] }) * this->AcuteSign({ t[1], t[2] }) *
    this->AcuteSign({ t[2], t[0] }) <
    0;
}

bool MongeMesh::Contains(std::size_t triangle, const Eigen::Vector3d& x) const
{
  const auto& t = this->triangles[triangle];
  const Eigen::Vector3d origin = PointAt(this->Mesh_, t[0]);
  Eigen::Matrix3d axes;
  axes.col(0) = PointAt(this->Mesh_, t[1]) - origin;
  axes.col(1) = PointAt(this->Mesh_, t[2]) - origin;
  axes.col(2) = axes.col(0).cross(axes.col(1)).normalized() * axes.col(0).norm();
  const Eigen::Vector3d weights = axes.fullPivLu().solve(x - origin);
  constexpr double tolerance = 1e-9; // far above round-off, far below the size of a triangle
  return weights[0] >= -tolerance && weights[1] >= -tolerance &&
    weights[0] + weights[1] <= 1.0 + tolerance && std::abs(weights[2]) <= tolerance;
}

EdgeKey MongeMesh::SideOf(std::size_t triangle, int side) const
{
  const auto& t = this->triangles[triangle];
  return KeyOf(t[side], t[(side + 1) % 3]);
}

std::vector<std::size_t> MongeMesh::TrianglesWith(const std::vector<EdgeKey>& edges) const
{
  std::vector<std::size_t> found;
  const auto around = this->sides.find(edges.front());
  if (around != this->sides.end())
  {
    for (const std::size_t t : around->second)
    {
      const auto has = [&](const EdgeKey& edge) {
        return edge == this->SideOf(t, 0) || edge == this->SideOf(t, 1) ||
          edge == this->SideOf(t, 2);
      };
      if (std::all_of(edges.begin(), edges.end(), has))
      {
        found.push_back(t);
      }
    }
  }
  return found;
}

std::size_t MongeMesh::RegionAround(const EdgeKey& edge) const
{
  const auto around = this->sides.find(edge);
  if (around == this->sides.end() || around->second.size() != 2)
  {
    return None;
  }
  const std::size_t region = this->regionOf[around->second[0]];
  return region == this->regionOf[around->second[1]] ? region : None;
}

bool MongeMesh::IsDisk(const Region& region) const
{
  std::set<vtkIdType> points;
  std::set<EdgeKey> edges;
  std::map<vtkIdType, int> contour;
  for (const std::size_t t : region.triangles)
  {
    points.insert(this->triangles[t].begin(), this->triangles[t].end());
    for (int side = 0; side < 3; ++side)
    {
      const EdgeKey edge = this->SideOf(t, side);
      edges.insert(edge);
      if (this->RegionAround(edge) == None)
      {
        ++contour[edge.first];
        ++contour[edge.second];
      }
    }
  }
  return points.size() + region.triangles.size() == edges.size() + 1 &&
    std::all_of(contour.begin(), contour.end(), [](const auto& at) { return at.second == 2; });
}

std::size_t MongeMesh::CountContourCrossings(std::size_t region, bool maximum) const
{
  std::size_t count = 0;
  for (const std::size_t t : this->regions[region].triangles)
  {
    for (int side = 0; side < 3; ++side)
    {
      const EdgeKey edge = this->SideOf(t, side);
      count += this->RegionAround(edge) == None && this->Crosses(edge, maximum) ? 1 : 0;
    }
  }
  return count;
}

int MongeMesh::AcuteSign(const EdgeKey& edge) const
{
  return this->Directions_[edge.first].dot(this->Directions_[edge.second]) >= 0.0 ? 1 : -1;
}

} // namespace testing
} // namespace ridges
