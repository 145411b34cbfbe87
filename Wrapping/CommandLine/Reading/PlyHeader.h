// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PlyHeader_h
#define PlyHeader_h

#include "Reading/TextLines.h"

#include <cstddef>
#include <string>
#include <vector>

namespace program
{

enum class PlyFormat
{
  Ascii,
  LittleEndian,
  BigEndian
};

enum class PlyType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float32,
  Float64
};

std::size_t SizeOf(PlyType type);

struct PlyProperty
{
  std::string name;
  PlyType type;
  bool isList = false;
  PlyType countType = PlyType::UInt8; ///< Of lists.
};

struct PlyElement
{
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  /// The place of a property among the others, or -1.
  int Find(const char* property) const;
};

struct PlyHeader
{
  PlyFormat format = PlyFormat::Ascii;
  std::vector<PlyElement> elements;
};

/// Reads the header of a PLY file and stays at its last line. Throws Failure if it is invalid.
PlyHeader ReadPlyHeader(TextLines& lines);

} // namespace program

#endif
