// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// Arrays in one piece of memory. That the piece is given back, and nothing is used after that, is
// for a sanitizer to see.

#include "Base/LargeMemory.h"
#include "Base/SharedMemory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <thread>
#include <vector>

namespace
{

using namespace ridges;

// Whether all bytes have a value.
bool IsFilledWith(const void* memory, std::size_t bytes, unsigned char value)
{
  const auto* first = static_cast<const unsigned char*>(memory);
  return std::all_of(first, first + bytes, [=](unsigned char byte) { return byte == value; });
}

struct Arrays
{
  explicit Arrays(const std::vector<std::size_t>& wanted)
    : sizes(wanted)
  {
    std::size_t sum = 0;
    for (const std::size_t size : sizes)
    {
      sum += size;
    }
    SharedMemory memory(sizes.size(), sum);
    for (std::size_t i = 0; i < sizes.size(); ++i)
    {
      this->arrays.push_back(memory.Take(sizes[i]));
      std::fill_n(static_cast<unsigned char*>(arrays[i]), sizes[i], static_cast<unsigned char>(i));
    }
  }

  std::vector<std::size_t> sizes;
  std::vector<void*> arrays;
};

} // namespace

//------------------------------------------------------------------------------
TEST(SharedMemory, KeepsArraysApartAndAlignedUntilTheLastIsFreed)
{
  for (const std::size_t size : { std::size_t(100), LargeMemorySize, 3 * LargeMemorySize })
  {
    const Arrays shared({ size, 0, 1, 64, 63, size + 8, 65 });
    for (const void* array : shared.arrays)
    {
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(array) % 64, 0U);
    }
    for (const std::size_t i : { 3, 0, 6, 1, 5, 2, 4 })
    {
      EXPECT_TRUE(IsFilledWith(shared.arrays[i], shared.sizes[i], static_cast<unsigned char>(i)));
      SharedMemory::Free(shared.arrays[i]);
    }
  }
}

//------------------------------------------------------------------------------
TEST(SharedMemory, IsFreedFromManyThreads)
{
  for (int repetition = 0; repetition < 20; ++repetition)
  {
    const Arrays shared(std::vector<std::size_t>(8, 1000));
    std::vector<std::thread> threads;
    for (void* array : shared.arrays)
    {
      threads.emplace_back([array] { SharedMemory::Free(array); });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  }
}

//------------------------------------------------------------------------------
TEST(SharedMemory, NeedsNoArrays)
{
  const SharedMemory memory(0, 0);
  SharedMemory::Free(nullptr);
}
