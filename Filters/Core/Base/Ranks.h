// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Ranks_h
#define ridges_Ranks_h

#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace ridges
{

/// Leaves new values as they are in memory: what is received or copied is written once.
// NOLINTBEGIN(readability-identifier-naming): the names are those of the standard library.
template <typename T>
struct UnsetAllocator : std::allocator<T>
{
  template <typename Other>
  struct rebind
  {
    using other = UnsetAllocator<Other>;
  };

  template <typename U>
  void construct(U* place)
  {
    ::new (static_cast<void*>(place)) U;
  }
  template <typename U, typename First, typename... Others>
  void construct(U* place, First&& first, Others&&... others)
  {
    ::new (static_cast<void*>(place))
      U(std::forward<First>(first), std::forward<Others>(others)...);
  }
};
// NOLINTEND(readability-identifier-naming)

using Bytes = std::vector<char, UnsetAllocator<char>>;

/**
 * The processes that work on one mesh together, and how they talk: whoever calls the numerics lends
 * it to them. All ranks have to call the same functions in the same order, or they wait forever.
 */
class Ranks
{
public:
  virtual ~Ranks() = default;

  virtual int Rank() const = 0;
  virtual int Size() const = 0;

  /// What keeps this rank from having its piece of the mesh; empty if nothing does.
  virtual std::string Fault() const { return {}; }

  /// Sends a message to each rank, this one included; what they sent to this one, in their order.
  virtual std::vector<Bytes> Exchange(std::vector<Bytes> messages) = 0;

  /// Sends the same message to all; what all sent, in their order.
  virtual std::vector<Bytes> GatherAll(Bytes message) = 0;
};

/// Whether there are others to work with.
inline bool AreSeveral(const Ranks* ranks)
{
  return ranks && ranks->Size() > 1;
}

/// Alone.
class OneRank : public Ranks
{
public:
  int Rank() const override { return 0; }
  int Size() const override { return 1; }
  std::vector<Bytes> Exchange(std::vector<Bytes> messages) override { return messages; }
  std::vector<Bytes> GatherAll(Bytes message) override { return { std::move(message) }; }
};

} // namespace ridges

#endif
