// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SparseIds_h
#define ridges_SparseIds_h

#include "Mesh/Triangle.h"

#include <cstddef>
#include <vector>

namespace ridges
{

/// An id for each of many points, -1 unless it was set. Only where points are set it takes memory:
/// points that follow each other in number mostly are set, or not, together.
class SparseIds
{
public:
  explicit SparseIds(Id count) { this->Grow(count); }

  /// To more points than before.
  void Grow(Id count) { this->Pages_.resize(PageOf(count) + 1); }

  Id operator[](Id p) const
  {
    const std::vector<Id>& page = this->Pages_[PageOf(p)];
    return page.empty() ? -1 : page[p % PageSize];
  }

  void Set(Id p, Id id)
  {
    std::vector<Id>& page = this->Pages_[PageOf(p)];
    if (page.empty())
    {
      page.assign(PageSize, -1);
    }
    page[p % PageSize] = id;
  }

private:
  static constexpr Id PageSize = 1024;

  static std::size_t PageOf(Id p) { return static_cast<std::size_t>(p / PageSize); }

  std::vector<std::vector<Id>> Pages_;
};

} // namespace ridges

#endif
