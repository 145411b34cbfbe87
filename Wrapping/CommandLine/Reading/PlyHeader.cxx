// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/PlyHeader.h"

#include <algorithm>

namespace program
{
namespace
{

PlyFormat ReadFormat(TextLines& lines)
{
  const std::string_view format = lines.Word();
  if (format == "ascii")
  {
    return PlyFormat::Ascii;
  }
  if (format == "binary_little_endian")
  {
    return PlyFormat::LittleEndian;
  }
  if (format == "binary_big_endian")
  {
    return PlyFormat::BigEndian;
  }
  lines.Fail(Quoted(format) + " is not a format of PLY",
    "write ascii, binary_little_endian or binary_big_endian");
}

PlyType ReadType(TextLines& lines)
{
  const std::pair<const char*, PlyType> names[] = {
    { "char", PlyType::Int8 },
    { "int8", PlyType::Int8 },
    { "uchar", PlyType::UInt8 },
    { "uint8", PlyType::UInt8 },
    { "short", PlyType::Int16 },
    { "int16", PlyType::Int16 },
    { "ushort", PlyType::UInt16 },
    { "uint16", PlyType::UInt16 },
    { "int", PlyType::Int32 },
    { "int32", PlyType::Int32 },
    { "uint", PlyType::UInt32 },
    { "uint32", PlyType::UInt32 },
    { "int64", PlyType::Int64 },
    { "uint64", PlyType::UInt64 },
    { "float", PlyType::Float32 },
    { "float32", PlyType::Float32 },
    { "double", PlyType::Float64 },
    { "float64", PlyType::Float64 },
  };
  const std::string_view word = lines.Word();
  for (const auto& [name, type] : names)
  {
    if (word == name)
    {
      return type;
    }
  }
  lines.Fail(Quoted(word) + " is not a type of PLY", "write one such as int, uchar or double");
}

PlyElement ReadElement(TextLines& lines)
{
  PlyElement element;
  element.name = std::string(lines.Word());
  const std::optional<long long> count = lines.Integer();
  if (element.name.empty() || !count || *count < 0)
  {
    lines.Fail("an element needs a name and a count", "correct the line");
  }
  element.count = static_cast<std::size_t>(*count);
  return element;
}

PlyProperty ReadProperty(TextLines& lines)
{
  PlyProperty property;
  property.isList = lines.PeekWord() == "list";
  if (property.isList)
  {
    lines.Word();
    property.countType = ReadType(lines);
  }
  property.type = ReadType(lines);
  property.name = std::string(lines.Word());
  if (property.name.empty())
  {
    lines.Fail("a property needs a name", "correct the line");
  }
  return property;
}

} // namespace

std::size_t SizeOf(PlyType type)
{
  switch (type)
  {
    case PlyType::Int8:
    case PlyType::UInt8:
      return 1;
    case PlyType::Int16:
    case PlyType::UInt16:
      return 2;
    case PlyType::Int32:
    case PlyType::UInt32:
    case PlyType::Float32:
      return 4;
    case PlyType::Int64:
    case PlyType::UInt64:
    case PlyType::Float64:
      break;
  }
  return 8;
}

int PlyElement::Find(const char* property) const
{
  const auto found = std::find_if(this->properties.begin(), this->properties.end(),
    [property](const PlyProperty& candidate) { return candidate.name == property; });
  return found == this->properties.end() ? -1 : static_cast<int>(found - this->properties.begin());
}

PlyHeader ReadPlyHeader(TextLines& lines)
{
  if (!lines.NextLine() || lines.Word() != "ply")
  {
    lines.Fail("this is not a PLY file, it does not begin with ply", "give a mesh in PLY format");
  }
  PlyHeader header;
  bool hasFormat = false;
  while (lines.NextLine())
  {
    const std::string_view keyword = lines.Word();
    if (keyword == "format")
    {
      header.format = ReadFormat(lines);
      hasFormat = true;
    }
    else if (keyword == "element")
    {
      header.elements.push_back(ReadElement(lines));
    }
    else if (keyword == "property" && !header.elements.empty())
    {
      header.elements.back().properties.push_back(ReadProperty(lines));
    }
    else if (keyword == "end_header")
    {
      if (!hasFormat)
      {
        lines.Fail("the header names no format", "add a line such as: format ascii 1.0");
      }
      return header;
    }
    else if (keyword != "comment" && keyword != "obj_info")
    {
      lines.Fail(Quoted(keyword) + " is not a statement of a PLY header", "correct the line");
    }
  }
  lines.Fail("the header does not end with end_header", "give a complete file");
}

} // namespace program
