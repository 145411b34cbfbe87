// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/UmbilicPatch.h"

#include "Mesh/PositionOrder.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace ridges
{

Span<Id> UmbilicPatch::Grow(Id triangle, double size)
{
  return this->GrowTo(triangle, size * this->OneRingGrade(triangle));
}

Span<Id> UmbilicPatch::GrowTo(Id triangle, double threshold)
{
  this->Start(triangle);
  while (this->GrowByOne(threshold))
  {
  }
  return this->Triangles();
}

void UmbilicPatch::Start(Id triangle)
{
  this->IsInside_.Clear();
  this->IsCorner_.Clear();
  this->Patch_.clear();
  this->Queue_.clear();
  this->Reached_ = 0.0;
  this->Center_ = this->Mesh_.Centroid(triangle);
  this->Add(triangle);
}

bool UmbilicPatch::GrowByOne(double threshold)
{
  while (!this->Queue_.empty() && this->Queue_.front().grade <= threshold)
  {
    const Candidate nearest = this->Queue_.front();
    std::pop_heap(this->Queue_.begin(), this->Queue_.end(),
      [this](const Candidate& a, const Candidate& b) { return this->IsFarther(a, b); });
    this->Queue_.pop_back();
    this->Reached_ = std::max(this->Reached_, nearest.grade);
    // A triangle refused now comes back when another of its neighbours has joined.
    if (!this->Contains(nearest.triangle) && this->StaysDisk(nearest.triangle))
    {
      this->Add(nearest.triangle);
      return true;
    }
  }
  return false;
}

bool UmbilicPatch::IsFarther(const Candidate& a, const Candidate& b) const
{
  return a.grade != b.grade
    ? a.grade > b.grade
    : a.triangle != b.triangle && ComesBefore(this->Mesh_, b.triangle, a.triangle);
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
    newPoints += this->IsCorner_.Contains(corners[side]) ? 0 : 1;
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
  this->Threshold_ = this->Reached_;
  this->IsInside_[triangle] = true;
  for (const Id corner : this->Mesh_.Corners(triangle))
  {
    this->IsCorner_[corner] = true;
    this->Mesh_.LookAt(corner);
  }
  this->Patch_.push_back(triangle);
  for (int side = 0; side < 3; ++side)
  {
    const Id neighbor = this->Mesh_.Neighbor(triangle, side);
    if (neighbor >= 0 && !this->Contains(neighbor))
    {
      this->Queue_.push_back({ (this->Mesh_.Centroid(neighbor) - this->Center_).norm(), neighbor });
      std::push_heap(this->Queue_.begin(), this->Queue_.end(),
        [this](const Candidate& a, const Candidate& b) { return this->IsFarther(a, b); });
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
  if (!next.empty())
  {
    const auto comesFirst = [this](const auto& a, const auto& b)
    { return PointComesBefore(this->Mesh_, a.first, b.first); };
    const Id start = std::min_element(next.begin(), next.end(), comesFirst)->first;
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
