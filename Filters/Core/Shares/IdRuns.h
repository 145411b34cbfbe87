// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_IdRuns_h
#define ridges_IdRuns_h

#include "Mesh/Triangle.h"

#include <cstddef>
#include <vector>

namespace ridges
{

/// A list of ids, most of which are one more than the one before, or all -1, in little memory.
class IdRuns
{
public:
  IdRuns() = default;

  explicit IdRuns(const std::vector<Id>& ids)
    : Count_(static_cast<Id>(ids.size()))
  {
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      const bool goesOn = i > 0 && ids[i] == (ids[i - 1] < 0 ? -1 : ids[i - 1] + 1);
      if (!goesOn)
      {
        this->Runs_.push_back({ static_cast<Id>(i), ids[i] });
      }
    }
    this->Runs_.shrink_to_fit();
  }

  std::vector<Id> Ids() const
  {
    std::vector<Id> ids;
    ids.reserve(this->Count_);
    for (std::size_t run = 0; run < this->Runs_.size(); ++run)
    {
      const bool isLast = run + 1 == this->Runs_.size();
      const Id end = isLast ? this->Count_ : this->Runs_[run + 1].begin;
      for (Id id = this->Runs_[run].first; static_cast<Id>(ids.size()) < end; id += id < 0 ? 0 : 1)
      {
        ids.push_back(id);
      }
    }
    return ids;
  }

  bool operator==(const IdRuns& other) const
  {
    return this->Count_ == other.Count_ && this->Runs_ == other.Runs_;
  }

private:
  struct Run
  {
    Id begin; ///< In the list.
    Id first; ///< Id.

    bool operator==(const Run& other) const
    {
      return this->begin == other.begin && this->first == other.first;
    }
  };

  std::vector<Run> Runs_;
  Id Count_ = 0;
};

} // namespace ridges

#endif
