// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesCollect_h
#define vtkRidgesCollect_h

#include "Core/Base/Types.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <utility>
#include <vector>

/**
 * Collects from [0, count) in parallel: `collect(begin, end, found)` appends what it finds in a
 * range. A functor over the numbers of the ranges for vtkSMPTools; private to the module.
 */
template <typename Found, typename Collect>
class vtkRidgesCollector
{
public:
  vtkRidgesCollector(ridges::Id count, Collect collect)
    : Count(count)
    , Body(std::move(collect))
    , Parts(count / Size + (count % Size > 0 ? 1 : 0))
  {
  }

  vtkIdType GetNumberOfRanges() const { return static_cast<vtkIdType>(this->Parts.size()); }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    for (auto range = static_cast<ridges::Id>(begin); range < end; ++range)
    {
      const ridges::Id first = Size * range;
      this->Body(first, first + std::min(Size, this->Count - first), this->Parts[range]);
    }
  }

  /// Appends all in the order of the ranges, which do not depend on the threads.
  void AppendTo(std::vector<Found>& all) const
  {
    std::size_t size = all.size();
    for (const std::vector<Found>& part : this->Parts)
    {
      size += part.size();
    }
    all.reserve(size);
    for (const std::vector<Found>& part : this->Parts)
    {
      all.insert(all.end(), part.begin(), part.end());
    }
  }

private:
  static constexpr ridges::Id Size = 8192;

  ridges::Id Count;
  Collect Body;
  std::vector<std::vector<Found>> Parts;
};

/// The numbers in [0, count) with is(number), in order: for what is too fast to be aborted.
template <typename Is>
std::vector<ridges::Id> vtkRidgesWhere(ridges::Id count, Is is)
{
  const auto collect = [&is](ridges::Id begin, ridges::Id end, std::vector<ridges::Id>& found)
  {
    for (ridges::Id i = begin; i < end; ++i)
    {
      if (is(i))
      {
        found.push_back(i);
      }
    }
  };
  vtkRidgesCollector<ridges::Id, decltype(collect)> collector(count, collect);
  vtkSMPTools::For(0, collector.GetNumberOfRanges(), collector);
  std::vector<ridges::Id> all;
  collector.AppendTo(all);
  return all;
}

#endif
