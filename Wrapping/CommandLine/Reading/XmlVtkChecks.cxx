// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/XmlVtkChecks.h"

#include "Console.h"
#include "Reading/ByteOrder.h"
#include "Reading/TextLines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>

namespace program
{
namespace
{

constexpr std::string_view Blanks = " \t\r\n";

/// The greatest factor by which zlib can compress.
constexpr double MostCompression = 1100.0;

/// The value of an attribute in a tag, or nothing.
std::string_view Attribute(std::string_view tag, std::string_view name)
{
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1))
  {
    const std::size_t equals = tag.find_first_not_of(Blanks, at + name.size());
    const std::size_t quote =
      equals == std::string_view::npos ? equals : tag.find_first_not_of(Blanks, equals + 1);
    if (at > 0 && Blanks.find(tag[at - 1]) != std::string_view::npos &&
      quote != std::string_view::npos && tag[equals] == '=')
    {
      const std::string_view value = tag.substr(quote + 1);
      return value.substr(0, value.find(tag[quote]));
    }
  }
  return {};
}

/// Decodes the beginning of a text in base 64, as many bytes as are asked for. Blanks may be before
/// it, but not inside: VTK would take them for digits. False if it cannot.
bool Decode(std::string_view text, char* bytes, std::size_t size)
{
  constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::uint32_t bits = 0;
  std::size_t bitCount = 0;
  std::size_t count = 0;
  const std::size_t begin = std::min(text.find_first_not_of(Blanks), text.size());
  for (std::size_t i = begin; i < text.size() && count < size; ++i)
  {
    const std::size_t digit = digits.find(text[i]);
    if (digit == std::string_view::npos)
    {
      return false;
    }
    bits = (bits << 6U) | static_cast<std::uint32_t>(digit);
    bitCount += 6;
    if (bitCount >= 8)
    {
      bitCount -= 8;
      bytes[count++] = static_cast<char>((bits >> bitCount) & 0xffU);
    }
  }
  return count == size;
}

/// Of a piece.
struct Counts
{
  double points = 0.0;
  double cells = 0.0;
};

Counts CountsOf(std::string_view piece)
{
  const auto count = [piece](std::string_view name)
  { return ToReal(Attribute(piece, name)).value_or(0.0); };
  return { count("NumberOfPoints"),
    count("NumberOfVerts") + count("NumberOfLines") + count("NumberOfStrips") +
      count("NumberOfPolys") };
}

/// Elements whose arrays are not as long as there are points or cells. Others, such as keys of an
/// array, may be anywhere, and say nothing of the arrays that follow.
bool IsOfOtherArrays(std::string_view name)
{
  constexpr std::string_view names[] = { "FieldData", "Verts", "Lines", "Strips", "Polys" };
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

class XmlVtkChecker
{
public:
  XmlVtkChecker(std::string_view bytes, const std::string& fileName)
    : Bytes(bytes)
    , FileName(fileName)
  {
    this->CheckEnds();
  }

  void Check() const
  {
    this->CheckCounts();
    Counts counts;
    double tuples = 0.0; // of arrays in the element at hand; 0 where it does not say
    const std::size_t end = std::min(this->Appended, this->Bytes.size());
    for (std::size_t at = this->Bytes.find('<'); at < end; at = this->Bytes.find('<', at + 1))
    {
      const std::string_view tag = this->TagAt(at);
      const std::string_view name = tag.substr(1, tag.find_first_of(" \t\r\n/", 1) - 1);
      if (name == "Piece")
      {
        counts = CountsOf(tag);
      }
      else if (name == "DataArray")
      {
        this->CheckLength(tag, tuples);
        this->CheckArray(tag, at + tag.size() + 1);
      }
      else if (name == "Points" || name == "PointData")
      {
        tuples = counts.points;
      }
      else if (name == "CellData")
      {
        tuples = counts.cells;
      }
      else if (IsOfOtherArrays(name))
      {
        tuples = 0.0;
      }
    }
  }

  double MostBytes() const
  {
    return (this->IsCompressed ? MostCompression : 1.0) * static_cast<double>(this->Bytes.size());
  }

private:
  [[noreturn]] void Fail(const std::string& what) const
  {
    throw Failure(this->FileName + what, "give a complete file");
  }

  std::string_view TagAt(std::size_t at) const
  {
    return this->Bytes.substr(at, this->Bytes.find('>', at) - at);
  }

  void CheckEnds()
  {
    const std::size_t begin = this->Bytes.find("<VTKFile");
    if (begin == std::string_view::npos)
    {
      throw Failure(
        this->FileName + " is not a file in VTK's XML format, it has no element VTKFile",
        "give a mesh in that format");
    }
    constexpr std::string_view end = "</VTKFile>";
    const std::size_t size = this->Bytes.find_last_not_of(Blanks) + 1;
    if (size < end.size() || this->Bytes.substr(size - end.size(), end.size()) != end)
    {
      this->Fail(" does not end with </VTKFile>");
    }
    const std::string_view tag = this->TagAt(begin);
    this->IsCompressed = !Attribute(tag, "compressor").empty();
    this->HasLongWords = Attribute(tag, "header_type") == "UInt64";
    this->Order =
      Attribute(tag, "byte_order") == "BigEndian" ? ByteOrder::BigEndian : ByteOrder::LittleEndian;
    const std::size_t appended = this->Bytes.find("<AppendedData");
    if (appended != std::string_view::npos)
    {
      this->IsRaw = Attribute(this->TagAt(appended), "encoding") == "raw";
      const std::size_t tagEnd = this->Bytes.find('>', appended);
      const std::size_t mark = this->Bytes.find_first_not_of(Blanks, tagEnd + 1);
      if (tagEnd == std::string_view::npos || mark == std::string_view::npos ||
        this->Bytes[mark] != '_')
      {
        this->Fail(": its appended data do not begin with _");
      }
      this->Appended = mark + 1;
    }
  }

  /// The smallest array of a count has four bytes for each if it is compressed, else a digit.
  void CheckCounts() const
  {
    constexpr std::string_view attribute = " NumberOf";
    const double most = this->MostBytes() / (this->IsCompressed ? 4.0 : 1.0);
    for (std::size_t at = this->Bytes.find(attribute); at != std::string_view::npos;
         at = this->Bytes.find(attribute, at + 1))
    {
      const std::string_view tag = this->TagAt(at);
      const std::string_view name = tag.substr(1, tag.find('=') - 1);
      const std::optional<double> count = ToReal(Attribute(tag, name));
      if (count && !(*count >= 0.0 && *count <= most))
      {
        this->Fail(": " + Quoted(name) + " is more than the file can hold");
      }
    }
  }

  /// A value has a byte at least, before it is compressed.
  void CheckLength(std::string_view tag, double tuples) const
  {
    const double components = ToReal(Attribute(tag, "NumberOfComponents")).value_or(1.0);
    const double own = ToReal(Attribute(tag, "NumberOfTuples")).value_or(0.0);
    if (components * std::max(tuples, own) > this->MostBytes())
    {
      this->Fail(": an array is larger than the file can hold");
    }
  }

  void CheckArray(std::string_view tag, std::size_t afterTag) const
  {
    const std::string_view format = Attribute(tag, "format");
    if (format == "binary")
    {
      this->CheckSizes(afterTag, false);
    }
    else if (format == "appended")
    {
      const std::optional<long long> offset = ToInteger(Attribute(tag, "offset"));
      if (this->Appended == std::string_view::npos || !offset || *offset < 0 ||
        static_cast<std::size_t>(*offset) >= this->Bytes.size() - this->Appended)
      {
        this->Fail(": the data of an array are not in the file");
      }
      this->CheckSizes(this->Appended + static_cast<std::size_t>(*offset), this->IsRaw);
    }
  }

  /// The size of the data of an array or, if they are compressed, the number and sizes of blocks,
  /// are in one word or three.
  void CheckSizes(std::size_t at, bool isRaw) const
  {
    constexpr std::size_t words = 3;
    constexpr std::size_t longWord = 8;
    std::array<char, words * longWord> header{};
    const std::string_view data = this->Bytes.substr(at);
    const std::size_t size = (this->IsCompressed ? words : 1) * (this->HasLongWords ? 8 : 4);
    if (isRaw && data.size() >= size)
    {
      data.copy(header.data(), size);
    }
    else if (isRaw || !Decode(data, header.data(), size))
    {
      this->Fail(": the size of an array is missing");
    }
    const auto word = [this, &header](std::size_t i)
    {
      return this->HasLongWords
        ? static_cast<double>(LoadNumber<std::uint64_t>(header.data() + 8 * i, this->Order))
        : static_cast<double>(LoadNumber<std::uint32_t>(header.data() + 4 * i, this->Order));
    };
    const double total = this->IsCompressed ? word(0) * word(1) + word(2) : word(0);
    const bool hasTooManyBlocks =
      this->IsCompressed && word(0) > static_cast<double>(this->Bytes.size());
    if (total > this->MostBytes() || hasTooManyBlocks)
    {
      this->Fail(": an array is larger than the file can hold");
    }
  }

  std::string_view Bytes;
  const std::string& FileName;
  ByteOrder Order = ByteOrder::LittleEndian;
  bool IsCompressed = false;
  bool HasLongWords = false;
  bool IsRaw = false;
  std::size_t Appended = std::string_view::npos; ///< Where appended data begin.
};

} // namespace

double CheckXmlVtk(std::string_view bytes, const std::string& fileName)
{
  const XmlVtkChecker checker(bytes, fileName);
  checker.Check();
  return checker.MostBytes();
}

} // namespace program
