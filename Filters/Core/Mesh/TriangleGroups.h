// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_TriangleGroups_h
#define ridges_TriangleGroups_h

#include "Mesh/TriangleMesh.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace ridges
{

/// Groups of triangles, one behind the other in one array: there may be very many small ones.
class TriangleGroups
{
public:
  TriangleGroups() = default;
  /// `ends` holds the end of each group in `triangles`.
  TriangleGroups(std::vector<Id> triangles, std::vector<std::size_t> ends)
    : Triangles_(std::move(triangles))
    , Ends_(std::move(ends))
  {
  }

  std::size_t size() const { return this->Ends_.size(); }
  bool empty() const { return this->Ends_.empty(); }

  Span<Id> operator[](std::size_t group) const
  {
    const Id* base = this->Triangles_.data();
    return { base + (group > 0 ? this->Ends_[group - 1] : 0), base + this->Ends_[group] };
  }

  template <typename Triangles>
  void Add(const Triangles& group)
  {
    this->Triangles_.insert(this->Triangles_.end(), group.begin(), group.end());
    this->Ends_.push_back(this->Triangles_.size());
  }

private:
  std::vector<Id> Triangles_;
  std::vector<std::size_t> Ends_;
};

} // namespace ridges

#endif
