// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Buffer_h
#define ridges_Buffer_h

#include "Base/LargeMemory.h"

#include <cstddef>
#include <memory>
#include <type_traits>

namespace ridges
{

/**
 * An array of plain values that are not set to anything before they are written. Large memory is
 * made available where it is first touched: here that is in the threads that fill it.
 */
template <typename T>
class Buffer
{
public:
  Buffer() = default;
  explicit Buffer(std::size_t size)
    : Values_(static_cast<T*>(AllocateLarge(size * sizeof(T))))
    , Size_(size)
  {
  }

  std::size_t size() const { return this->Size_; }
  T* data() { return this->Values_.get(); }
  const T* data() const { return this->Values_.get(); }
  T* begin() { return this->data(); }
  T* end() { return this->data() + this->Size_; }
  const T* begin() const { return this->data(); }
  const T* end() const { return this->data() + this->Size_; }
  T& operator[](std::size_t i) { return this->Values_[i]; }
  const T& operator[](std::size_t i) const { return this->Values_[i]; }

  /// Forgets the values from `size` on; the memory stays.
  void Shorten(std::size_t size) { this->Size_ = size; }

private:
  static_assert(std::is_trivially_copyable_v<T>, "values are neither constructed nor destroyed");

  struct Free
  {
    void operator()(T* values) const { FreeLarge(values); }
  };

  std::unique_ptr<T[], Free> Values_;
  std::size_t Size_ = 0;
};

} // namespace ridges

#endif
