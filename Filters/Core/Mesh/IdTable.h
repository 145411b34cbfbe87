// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_IdTable_h
#define ridges_IdTable_h

#include "Mesh/TriangleMesh.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace ridges
{

/**
 * Values by id, for a small part of a large mesh. To clear it costs nothing, and its memory is kept
 * for the next use: made for many small parts, one after the other.
 */
template <typename Value>
class IdTable
{
public:
  IdTable() { this->Clear(); }

  void Clear()
  {
    this->Size_ = 0;
    this->Mask_ = 31;
    if (this->Slots_.size() <= this->Mask_)
    {
      this->Slots_.resize(this->Mask_ + 1);
    }
    if (++this->Stamp_ == 0)
    {
      this->Slots_.assign(this->Slots_.size(), Slot{});
      this->Stamp_ = 1;
    }
  }

  std::size_t size() const { return this->Size_; }

  /// The value of an id, or null.
  const Value* Find(Id id) const
  {
    const Slot& slot = this->Slots_[this->Locate(id)];
    return slot.stamp == this->Stamp_ ? &slot.value : nullptr;
  }
  Value* Find(Id id) { return const_cast<Value*>(static_cast<const IdTable*>(this)->Find(id)); }
  bool Contains(Id id) const { return this->Find(id) != nullptr; }

  /// The value of an id, which is put in with a value-initialised one if it is not there.
  Value& operator[](Id id)
  {
    std::size_t place = this->Locate(id);
    if (this->Slots_[place].stamp != this->Stamp_)
    {
      if (2 * ++this->Size_ > this->Mask_)
      {
        this->Grow();
        place = this->Locate(id);
      }
      this->Slots_[place] = { id, this->Stamp_, Value{} };
    }
    return this->Slots_[place].value;
  }

private:
  struct Slot
  {
    Id id = 0;
    std::uint32_t stamp = 0; ///< Empty, unless it is that of the table.
    Value value{};
  };

  std::size_t Locate(Id id) const
  {
    std::size_t place = (static_cast<std::uint32_t>(id) * 2654435769U >> 7) & this->Mask_;
    while (this->Slots_[place].stamp == this->Stamp_ && this->Slots_[place].id != id)
    {
      place = (place + 1) & this->Mask_;
    }
    return place;
  }

  void Grow()
  {
    std::vector<Slot> held;
    held.reserve(this->Size_);
    for (std::size_t i = 0; i <= this->Mask_; ++i)
    {
      if (this->Slots_[i].stamp == this->Stamp_)
      {
        held.push_back(std::move(this->Slots_[i]));
        this->Slots_[i].stamp = 0;
      }
    }
    this->Mask_ = 2 * this->Mask_ + 1;
    if (this->Slots_.size() <= this->Mask_)
    {
      this->Slots_.resize(this->Mask_ + 1);
    }
    for (Slot& slot : held)
    {
      this->Slots_[this->Locate(slot.id)] = std::move(slot);
    }
  }

  std::vector<Slot> Slots_;
  std::size_t Mask_ = 0; ///< Only slots up to this one are in use.
  std::size_t Size_ = 0;
  std::uint32_t Stamp_ = 0;
};

} // namespace ridges

#endif
