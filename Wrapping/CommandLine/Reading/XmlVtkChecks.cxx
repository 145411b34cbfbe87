// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/XmlVtkChecks.h"

#include "Console.h"
#include "Reading/ByteOrder.h"
#include "Reading/TextLines.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <vector>

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
      if (name.substr(0, 1) == "!")
      {
        at = this->EndOfComment(at);
      }
      else if (name == "Piece")
      {
        counts = CountsOf(tag);
      }
      else if (name == "DataArray" || !Attribute(tag, "format").empty())
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

  /// Other things that begin so are not in a mesh.
  std::size_t EndOfComment(std::size_t at) const
  {
    constexpr std::string_view begin = "<!--";
    const std::size_t end = this->Bytes.substr(at, begin.size()) == begin
      ? this->Bytes.find("-->", at + begin.size())
      : std::string_view::npos;
    if (end == std::string_view::npos)
    {
      throw Failure(this->FileName + " has other than elements and comments", "remove that");
    }
    return end;
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
      const std::string_view text = Attribute(tag, name);
      const std::optional<double> count = text.empty() ? 0.0 : ToReal(text);
      if (!count || !(*count >= 0.0 && *count <= most))
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
    // VTK goes by the offset.
    const std::string_view format = Attribute(tag, "format");
    if (format == "appended" || !Attribute(tag, "offset").empty())
    {
      const std::optional<long long> offset = ToInteger(Attribute(tag, "offset"));
      if (this->Appended == std::string_view::npos || !offset || *offset < 0 ||
        static_cast<std::size_t>(*offset) >= this->Bytes.size() - this->Appended)
      {
        this->Fail(": the data of an array are not in the file");
      }
      this->CheckSizes(this->Appended + static_cast<std::size_t>(*offset), this->IsRaw);
    }
    else if (format == "binary")
    {
      this->CheckSizes(afterTag, false);
    }
  }

  /// So many words from the beginning of the data of an array.
  std::vector<double> Words(std::string_view data, bool isRaw, std::size_t count) const
  {
    const std::size_t wordSize = this->HasLongWords ? 8 : 4;
    std::string bytes(std::min(count * wordSize, data.size()), '\0');
    const bool isThere = bytes.size() == count * wordSize &&
      (isRaw ? data.copy(bytes.data(), bytes.size()) == bytes.size()
             : Decode(data, bytes.data(), bytes.size()));
    if (!isThere)
    {
      this->Fail(": the size of an array is missing");
    }
    std::vector<double> words(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      const char* word = bytes.data() + i * wordSize;
      words[i] = this->HasLongWords
        ? static_cast<double>(LoadNumber<std::uint64_t>(word, this->Order))
        : static_cast<double>(LoadNumber<std::uint32_t>(word, this->Order));
    }
    return words;
  }

  [[noreturn]] void FailTooLarge() const
  {
    this->Fail(": an array is larger than the file can hold");
  }

  /// The size of the data is in a word. If they are compressed: the number of blocks, the size of
  /// each before, that of the last if it is smaller, and then the size of each in the file.
  void CheckSizes(std::size_t at, bool isRaw) const
  {
    const std::string_view data = this->Bytes.substr(at);
    if (!this->IsCompressed)
    {
      if (this->Words(data, isRaw, 1)[0] > this->MostBytes())
      {
        this->FailTooLarge();
      }
      return;
    }
    const std::vector<double> head = this->Words(data, isRaw, 3);
    const double blocks = head[0];
    const double size = head[1];
    const double lastSize = head[2];
    if (lastSize > size || (blocks > 0.0 ? !(size > 0.0) : lastSize > 0.0))
    {
      this->Fail(": the sizes of the blocks of an array are invalid");
    }
    const double total = lastSize > 0.0 ? (blocks - 1.0) * size + lastSize : blocks * size;
    if (total > this->MostBytes() || blocks > static_cast<double>(this->Bytes.size()))
    {
      this->FailTooLarge();
    }
    const std::vector<double> words =
      this->Words(data, isRaw, head.size() + static_cast<std::size_t>(blocks));
    if (std::accumulate(words.begin() + 3, words.end(), 0.0) >
      static_cast<double>(this->Bytes.size()))
    {
      this->FailTooLarge();
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
