// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Types_h
#define ridges_Types_h

#include <cstdint>
#include <functional>

namespace ridges
{

/// Index of a point, an edge or a triangle. 32 bits keep the adjacency small.
using Id = std::int32_t;

/// Runs body(begin, end) over ranges that make up [0, count), maybe at the same time: how callers
/// lend threads to the numerics, which have none of their own.
using RangeLoop = std::function<void(Id count, const std::function<void(Id, Id)>& body)>;

/// A run of consecutive values owned by somebody else.
template <typename T>
struct Span
{
  const T* first = nullptr;
  const T* last = nullptr;

  const T* begin() const { return first; }
  const T* end() const { return last; }
  Id size() const { return static_cast<Id>(last - first); }
  const T& operator[](Id i) const { return first[i]; }
};

} // namespace ridges

#endif
