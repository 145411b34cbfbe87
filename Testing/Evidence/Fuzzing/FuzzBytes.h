// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RIDGES_FUZZ_BYTES_H
#define RIDGES_FUZZ_BYTES_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

// The bytes of the fuzzer as numbers; zeros, when they are used up.
class FuzzBytes
{
public:
  FuzzBytes(const std::uint8_t* data, std::size_t size)
    : Data(data)
    , Left(size)
  {
  }

  bool IsEmpty() const { return this->Left == 0; }

  std::uint8_t Byte()
  {
    if (this->Left == 0)
    {
      return 0;
    }
    --this->Left;
    return *this->Data++;
  }

  int Below(int limit) { return this->Byte() % limit; }
  bool Flag() { return (this->Byte() & 1) != 0; }

  // Mostly of order 1; now and then anything.
  double Number()
  {
    const int kind = this->Byte();
    if (kind < 224)
    {
      return (this->Byte() - 127.5) / 64 + (kind - 112) / 16384.0;
    }
    constexpr double special[] = { 0.0, -0.0, 1.0, -1.0, 1e300, -1e300, 1e154, 1e-154, 1e-300,
      5e-324, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
      std::numeric_limits<double>::quiet_NaN(), 1e10, 1e-10 };
    if (kind < 239)
    {
      return special[kind - 224];
    }
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i)
    {
      bits = bits << 8 | this->Byte();
    }
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

  std::string Text(int length)
  {
    std::string text;
    for (int i = 0; i<length&& this->Left> 0; ++i)
    {
      text += static_cast<char>(this->Byte());
    }
    return text;
  }

private:
  const std::uint8_t* Data;
  std::size_t Left;
};

#endif
