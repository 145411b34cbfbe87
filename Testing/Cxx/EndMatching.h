// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef EndMatching_h
#define EndMatching_h

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace ridges
{
namespace testing
{

/// Gives each end a triangle of its own out of those it may belong to, two where an umbilic lies on
/// an edge: a matching by augmenting paths.
class EndMatching
{
public:
  explicit EndMatching(std::vector<std::vector<std::size_t>> choices)
    : Choices_(std::move(choices))
  {
  }

  bool Match()
  {
    for (std::size_t end = 0; end < this->Choices_.size(); ++end)
    {
      std::set<std::size_t> tried;
      if (!this->Place(end, tried))
      {
        return false;
      }
    }
    return true;
  }

private:
  bool Place(std::size_t end, std::set<std::size_t>& tried)
  {
    for (const std::size_t t : this->Choices_[end])
    {
      if (tried.insert(t).second && (!this->EndOf_.count(t) || this->Place(this->EndOf_[t], tried)))
      {
        this->EndOf_[t] = end;
        return true;
      }
    }
    return false;
  }

  std::vector<std::vector<std::size_t>> Choices_;
  std::map<std::size_t, std::size_t> EndOf_;
};

} // namespace testing
} // namespace ridges

#endif
