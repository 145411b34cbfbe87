// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PairingRing_h
#define ridges_PairingRing_h

#include "Base/Types.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

namespace ridges
{

/// Elements around a contour that leave it in pairs of neighbours, the cheapest first; of equally
/// cheap ones those with fewer sides between them.
class PairingRing
{
public:
  using Cost = std::function<double(Id, Id)>;

  /// The elements are at increasing places of a contour of so many sides.
  PairingRing(const std::vector<std::size_t>& places, std::size_t sides, const Cost& cost)
    : Places_(places)
    , Sides_(sides)
    , Cost_(cost)
    , Size_(places.size())
    , Next_(places.size())
    , Previous_(places.size())
    , IsLeft_(places.size(), 1)
  {
    const Id count = static_cast<Id>(places.size());
    for (Id i = 0; i < count; ++i)
    {
      this->Next_[i] = i + 1 < count ? i + 1 : 0;
      this->Previous_[i] = i > 0 ? i - 1 : count - 1;
    }
    for (Id i = 0; i < count; ++i)
    {
      this->Offer(i);
    }
  }

  std::size_t Size() const { return this->Size_; }
  bool Has(Id i) const { return this->IsLeft_[i] != 0; }

  /// Needs two elements at least.
  std::pair<Id, Id> TakeCheapest()
  {
    while (this->IsOver(this->Offers_.front()))
    {
      std::pop_heap(this->Offers_.begin(), this->Offers_.end(), std::greater<Pair>());
      this->Offers_.pop_back();
    }
    const Id from = std::get<2>(this->Offers_.front());
    const Id to = std::get<3>(this->Offers_.front());
    this->IsLeft_[from] = 0;
    this->IsLeft_[to] = 0;
    this->Size_ -= 2;
    const Id before = this->Previous_[from];
    const Id after = this->Next_[to];
    this->Next_[before] = after;
    this->Previous_[after] = before;
    if (this->Size_ > 1)
    {
      this->Offer(before);
    }
    return { from, to };
  }

private:
  using Pair = std::tuple<double, std::size_t, Id, Id>; // Cost, sides between, and both.

  /// An element and the one behind it. Of two that are left each follows the other: the shorter way
  /// around.
  void Offer(Id from)
  {
    const Id to = this->Next_[from];
    const std::size_t between =
      (this->Places_[to] + this->Sides_ - this->Places_[from]) % this->Sides_;
    this->Offers_.emplace_back(this->Cost_(from, to), between, from, to);
    std::push_heap(this->Offers_.begin(), this->Offers_.end(), std::greater<Pair>());
  }

  /// Whether one of both has left, or others came between.
  bool IsOver(const Pair& pair) const
  {
    return !this->Has(std::get<2>(pair)) || this->Next_[std::get<2>(pair)] != std::get<3>(pair);
  }

  const std::vector<std::size_t>& Places_;
  std::size_t Sides_;
  const Cost& Cost_;
  std::size_t Size_;
  std::vector<Id> Next_;
  std::vector<Id> Previous_;
  std::vector<std::uint8_t> IsLeft_;
  std::vector<Pair> Offers_; ///< A heap.
};

} // namespace ridges

#endif
