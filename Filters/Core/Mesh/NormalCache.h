// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_NormalCache_h
#define ridges_NormalCache_h

#include "Mesh/TriangleMesh.h"

#include <unordered_map>
#include <vector>

namespace ridges
{

/**
 * The normals of points, of unit length or zero, each computed when it is first needed, and kept
 * until another takes its place. For whoever needs those of neighbours, point after point. One per
 * thread.
 */
class NormalCache
{
public:
  explicit NormalCache(const TriangleMesh& mesh)
    : Mesh_(mesh)
  {
  }

  Eigen::Vector3d At(Id point)
  {
    // Those of large fans take long, and all points of the fan need them: none takes their place.
    constexpr Id largestFan = 32;
    if (this->Mesh_.TrianglesAround(point).size() > largestFan)
    {
      const auto [entry, isNew] = this->OfLargeFans_.try_emplace(point);
      if (isNew)
      {
        entry->second = this->Mesh_.PointNormal(point).stableNormalized();
      }
      return entry->second;
    }
    constexpr Id size = 4096;
    this->Entries_.resize(size);
    Entry& entry = this->Entries_[point % size];
    if (entry.point != point)
    {
      entry = { point, this->Mesh_.PointNormal(point).stableNormalized() };
    }
    return entry.normal;
  }

private:
  struct Entry
  {
    Id point = -1;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  };

  const TriangleMesh& Mesh_;
  std::vector<Entry> Entries_;
  std::unordered_map<Id, Eigen::Vector3d> OfLargeFans_;
};

} // namespace ridges

#endif
