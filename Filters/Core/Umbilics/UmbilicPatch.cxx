// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/UmbilicPatch.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace ridges
{

UmbilicPatch::UmbilicPatch(const TriangleMesh& mesh)
  : Mesh_(mesh)
  , TriangleStamps_(mesh.NumberOfTriangles(), 0)
  , PointStamps_(mesh.NumberOfPoints(), 0)
{
}

Span<Id> UmbilicPatch::Grow(Id triangle, double size)
{
  return this->GrowTo(triangle, size * this->OneRingGrade(triangle));
}

Span<Id> UmbilicPatch::GrowTo(Id triangle, double threshold)
{
  if (++this->Stamp_ == 0)
  {
    std::fill(this->TriangleStamps_.begin(), this->TriangleStamps_.end(), 0);
    std::fill(this->PointStamps_.begin(), this->PointStamps_.end(), 0);
    this->Stamp_ = 1;
  }
  this->Patch_.clear();
  this->Queue_.clear();
  this->Thresholds_.clear();
  this->Center_ = this->Mesh_.Centroid(triangle);

  double reached = 0.0;
  this->Thresholds_.push_back(reached);
  this->Add(triangle);
  while (!this->Queue_.empty() && this->Queue_.front().grade <= threshold)
  {
    const Id nearest = this->Queue_.front().triangle;
    reached = std::max(reached, this->Queue_.front().grade);
    std::pop_heap(this->Queue_.begin(), this->Queue_.end());
    this->Queue_.pop_back();
    // A triangle refused now comes back when another of its neighbours has joined.
    if (!this->Contains(nearest) && this->StaysDisk(nearest))
    {
      this->Thresholds_.push_back(reached);
      this->Add(nearest);
    }
  }
  return { this->Patch_.data(), this->Patch_.data() + this->Patch_.size() };
}

double UmbilicPatch::OneRingGrade(Id triangle) const
{
  const Eigen::Vector3d center = this->Mesh_.Centroid(triangle);
  double squared = 0.0;
  for (const Id corner : this->Mesh_.Corners(triangle))
  {
    for (const Id t : this->Mesh_.TrianglesAround(corner))
    {
      squared = std::max(squared, (this->Mesh_.Centroid(t) - center).squaredNorm());
    }
  }
  return std::sqrt(squared);
}

// The Euler characteristic has to stay 1: a triangle brings one face, an edge for each side that
// the patch does not have, and a point for each corner that it does not have.
bool UmbilicPatch::StaysDisk(Id triangle) const
{
  const Triangle& corners = this->Mesh_.Corners(triangle);
  int shared = 0;
  int newPoints = 0;
  for (int side = 0; side < 3; ++side)
  {
    newPoints += this->PointStamps_[corners[side]] != this->Stamp_ ? 1 : 0;
    const Id neighbor = this->Mesh_.Neighbor(triangle, side);
    if (neighbor >= 0 && this->Contains(neighbor))
    {
      // A side that both run through in the same direction cannot be glued in one orientation.
      if (RunsThrough(this->Mesh_.Corners(neighbor), corners[side], corners[(side + 1) % 3]))
      {
        return false;
      }
      ++shared;
    }
  }
  return (shared == 1 && newPoints == 1) || shared == 2;
}

void UmbilicPatch::Add(Id triangle)
{
  this->TriangleStamps_[triangle] = this->Stamp_;
  for (const Id corner : this->Mesh_.Corners(triangle))
  {
    this->PointStamps_[corner] = this->Stamp_;
  }
  this->Patch_.push_back(triangle);
  for (int side = 0; side < 3; ++side)
  {
    const Id neighbor = this->Mesh_.Neighbor(triangle, side);
    if (neighbor >= 0 && !this->Contains(neighbor))
    {
      this->Queue_.push_back({ (this->Mesh_.Centroid(neighbor) - this->Center_).norm(), neighbor });
      std::push_heap(this->Queue_.begin(), this->Queue_.end());
    }
  }
}

std::vector<Id> UmbilicPatch::Contour() const
{
  std::unordered_map<Id, Id> next;
  for (const Id t : this->Patch_)
  {
    const Triangle& corners = this->Mesh_.Corners(t);
    for (int side = 0; side < 3; ++side)
    {
      const Id neighbor = this->Mesh_.Neighbor(t, side);
      if (neighbor < 0 || !this->Contains(neighbor))
      {
        next[corners[side]] = corners[(side + 1) % 3];
      }
    }
  }
  std::vector<Id> contour;
  if (!this->Patch_.empty())
  {
    const Id start = next.begin()->first;
    Id p = start;
    do
    {
      contour.push_back(p);
      p = next.at(p);
    } while (p != start && contour.size() <= next.size());
  }
  return contour;
}

} // namespace ridges
