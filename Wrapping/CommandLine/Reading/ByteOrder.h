// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ByteOrder_h
#define ByteOrder_h

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace program
{

enum class ByteOrder
{
  LittleEndian,
  BigEndian
};

/// The number that is stored at `bytes`, in a byte order that need not be the processor's.
template <typename T>
T LoadNumber(const char* bytes, ByteOrder order)
{
  unsigned char reversed[sizeof(T)];
  std::memcpy(reversed, bytes, sizeof(T));
  const std::uint16_t one = 1;
  unsigned char low = 0;
  std::memcpy(&low, &one, 1);
  if ((order == ByteOrder::LittleEndian) != (low == 1))
  {
    for (std::size_t i = 0; i < sizeof(T); ++i)
    {
      std::memcpy(reversed + i, bytes + sizeof(T) - 1 - i, 1);
    }
  }
  T value;
  std::memcpy(&value, reversed, sizeof(T));
  return value;
}

} // namespace program

#endif
