// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/LegacyVtkReader.h"

#include "Reading/ByteOrder.h"
#include "Reading/TextLines.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>

namespace program
{
namespace
{

struct NumberType
{
  const char* name;
  std::size_t size; ///< In bytes, of a binary file.
  double (*load)(const char* bytes);
};

template <typename T>
double Load(const char* bytes)
{
  return static_cast<double>(LoadNumber<T>(bytes, ByteOrder::BigEndian));
}

/// Bits have a size of 0, as eight of them share a byte. Ids are written in 32 bits.
constexpr NumberType NumberTypes[] = {
  { "bit", 0, nullptr },
  { "char", 1, Load<std::int8_t> },
  { "signed_char", 1, Load<std::int8_t> },
  { "unsigned_char", 1, Load<std::uint8_t> },
  { "short", 2, Load<std::int16_t> },
  { "unsigned_short", 2, Load<std::uint16_t> },
  { "int", 4, Load<std::int32_t> },
  { "unsigned_int", 4, Load<std::uint32_t> },
  { "vtkidtype", 4, Load<std::int32_t> },
  { "long", 8, Load<std::int64_t> },
  { "unsigned_long", 8, Load<std::uint64_t> },
  { "vtktypeint64", 8, Load<std::int64_t> },
  { "vtktypeuint64", 8, Load<std::uint64_t> },
  { "float", 4, Load<float> },
  { "double", 8, Load<double> },
};

constexpr const NumberType& UnsignedChar = NumberTypes[3];
constexpr const NumberType& Int = NumberTypes[6];
constexpr const NumberType& Float = NumberTypes[13];

std::string Lower(std::string_view word)
{
  std::string text(word);
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

class LegacyVtk
{
public:
  LegacyVtk(std::string_view bytes, const std::string& fileName)
    : Lines(bytes, fileName, '\0')
  {
  }

  PolygonMesh Parse()
  {
    this->ReadFirstLine();
    while (this->Lines.NextLine() && this->ReadSection(Lower(this->Lines.Word())))
    {
    }
    this->CheckCorners();
    return std::move(this->Mesh);
  }

private:
  void ReadFirstLine()
  {
    // # vtk DataFile Version 5.1
    const bool isVtk =
      this->Lines.NextLine() && this->Lines.Word() == "#" && this->Lines.Word() == "vtk";
    this->Lines.Word();
    this->Lines.Word();
    const std::optional<double> version = this->Lines.Real();
    if (!isVtk || !version)
    {
      this->Lines.Fail("this is not a file in VTK's legacy format, it does not begin with "
                       "# vtk DataFile Version",
        "give a mesh in that format");
    }
    this->HasOffsets = *version >= 5.0;
  }

  /// False at a section after which no more can be understood.
  bool ReadSection(const std::string& keyword)
  {
    if (keyword == "ascii" || keyword == "binary")
    {
      this->IsBinary = keyword == "binary";
      this->HasTitle = true;
    }
    else if (!this->HasTitle)
    {
      this->HasTitle = true; // whatever it is
    }
    else if (keyword == "dataset")
    {
      this->CheckDataset();
    }
    else if (keyword == "points")
    {
      this->ReadPoints();
    }
    else if (keyword == "vertices" || keyword == "lines" || keyword == "polygons" ||
      keyword == "triangle_strips")
    {
      this->ReadCells(keyword);
    }
    else if (keyword == "metadata")
    {
      this->Lines.SkipToEmptyLine();
    }
    else if (keyword == "point_data" || keyword == "cell_data")
    {
      this->AttributeCount = this->ReadCount();
    }
    else if (keyword == "field")
    {
      return this->ReadField();
    }
    else
    {
      return this->ReadAttribute(keyword);
    }
    return true;
  }

  void CheckDataset()
  {
    const std::string type = Lower(this->Lines.Word());
    if (type != "polydata")
    {
      this->Lines.Fail("the dataset is of type " + Quoted(type), "give one of type POLYDATA");
    }
  }

  std::size_t ReadCount()
  {
    const std::optional<long long> count = this->Lines.Integer();
    if (!count || *count < 0)
    {
      this->Lines.Fail("a count is missing", "correct the line");
    }
    return static_cast<std::size_t>(*count);
  }

  /// Null for arrays of other things than numbers.
  const NumberType* ReadType()
  {
    const std::string word = Lower(this->Lines.Word());
    const auto found = std::find_if(std::begin(NumberTypes), std::end(NumberTypes),
      [&word](const NumberType& type) { return word == type.name; });
    if (found != std::end(NumberTypes))
    {
      return found;
    }
    if (word != "string" && word != "utf8_string" && word != "variant")
    {
      this->Lines.Fail(Quoted(word) + " is not a type of VTK's legacy format", "correct the line");
    }
    return nullptr;
  }

  [[noreturn]] void FailIncomplete(std::size_t count)
  {
    this->Lines.Fail("the file ends before the " + std::to_string(count) + " numbers announced",
      "give a complete file");
  }

  /// Goes past `count` numbers after this line, and hands each to `use`.
  template <typename Use>
  void ForNumbers(std::size_t count, const NumberType& type, const Use& use)
  {
    if (count > 8 * this->Lines.CharactersLeft())
    {
      this->FailIncomplete(count);
    }
    if (this->IsBinary)
    {
      const std::size_t size = type.size > 0 ? count * type.size : (count + 7) / 8;
      const char* bytes = this->Lines.Bytes(size);
      if (!bytes)
      {
        this->FailIncomplete(count);
      }
      for (std::size_t i = 0; type.load && i < count; ++i)
      {
        use(type.load(bytes + i * type.size));
      }
      return;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!this->Lines.NextWord())
      {
        this->FailIncomplete(count);
      }
      const std::optional<double> number = this->Lines.Real();
      if (!number)
      {
        this->Lines.Fail(Quoted(this->Lines.PeekWord()) + " is not a number", "correct the line");
      }
      use(*number);
    }
  }

  void SkipNumbers(std::size_t tuples, std::size_t components, const NumberType& type)
  {
    const std::size_t most = 8 * this->Lines.CharactersLeft();
    if (components > 0 && tuples > most / components)
    {
      this->FailIncomplete(tuples);
    }
    this->ForNumbers(tuples * components, type, [](double) {});
  }

  void ReadPoints()
  {
    const std::size_t count = this->ReadCount();
    const NumberType* type = this->ReadType();
    if (!type || count > this->Lines.CharactersLeft() / 3)
    {
      this->FailIncomplete(3 * count);
    }
    this->Mesh.isSinglePrecision = std::string(type->name) == "float";
    this->Mesh.points.assign(count, {});
    double* next = count > 0 ? this->Mesh.points.front().data() : nullptr;
    this->ForNumbers(3 * count, *type, [&next](double x) { *next++ = x; });
  }

  std::vector<vtkIdType> ReadIds(std::size_t count, const NumberType& type)
  {
    std::vector<vtkIdType> ids;
    ids.reserve(std::min(count, this->Lines.CharactersLeft()));
    this->ForNumbers(count, type,
      [this, &ids](double id)
      {
        if (!(std::abs(id) < 9e15) || id != std::floor(id))
        {
          this->Lines.Fail("a cell has a corner that is not a number of a point", "correct it");
        }
        ids.push_back(static_cast<vtkIdType>(id));
      });
    return ids;
  }

  std::vector<vtkIdType> ReadIdArray(const char* name, std::size_t count)
  {
    if (!this->Lines.NextLine() || Lower(this->Lines.Word()) != name)
    {
      this->Lines.Fail(std::string(name) + " of cells are missing", "give a complete file");
    }
    const NumberType* type = this->ReadType();
    if (!type)
    {
      this->FailIncomplete(count);
    }
    return this->ReadIds(count, *type);
  }

  void ReadCells(const std::string& keyword)
  {
    const std::size_t count = this->ReadCount();
    const std::size_t size = this->ReadCount();
    if (this->HasOffsets)
    {
      if (count > 0)
      {
        const std::vector<vtkIdType> offsets = this->ReadIdArray("offsets", count);
        this->AddCells(keyword, offsets, this->ReadIdArray("connectivity", size));
      }
      return;
    }
    // The number of corners in front of those of each cell. As offsets and corners:
    const std::vector<vtkIdType> mixed = this->ReadIds(size, Int);
    std::vector<vtkIdType> offsets{ 0 };
    std::vector<vtkIdType> corners;
    for (std::size_t at = 0; at < mixed.size();)
    {
      const auto left = static_cast<vtkIdType>(mixed.size() - at) - 1;
      if (mixed[at] < 0 || mixed[at] > left)
      {
        this->Lines.Fail("a cell has more corners than its list", "correct the file");
      }
      const auto first = mixed.begin() + static_cast<std::ptrdiff_t>(at) + 1;
      corners.insert(corners.end(), first, first + mixed[at]);
      offsets.push_back(static_cast<vtkIdType>(corners.size()));
      at += static_cast<std::size_t>(mixed[at]) + 1;
    }
    if (offsets.size() != count + 1)
    {
      this->Lines.Fail(
        CountOf(offsets.size() - 1, count, "cells fill their list"), "correct the file");
    }
    this->AddCells(keyword, offsets, corners);
  }

  void AddCells(const std::string& keyword, const std::vector<vtkIdType>& offsets,
    const std::vector<vtkIdType>& corners)
  {
    const auto size = static_cast<vtkIdType>(corners.size());
    if (offsets.front() != 0 || offsets.back() != size ||
      !std::is_sorted(offsets.begin(), offsets.end()))
    {
      this->Lines.Fail("offsets and corners of cells do not fit together", "correct the file");
    }
    for (std::size_t i = 0; i + 1 < offsets.size(); ++i)
    {
      const auto first = corners.begin() + offsets[i];
      const auto last = corners.begin() + offsets[i + 1];
      if (keyword == "polygons")
      {
        this->Mesh.corners.insert(this->Mesh.corners.end(), first, last);
        this->Mesh.EndFace();
      }
      else if (keyword == "triangle_strips")
      {
        this->Mesh.AddStrip({ first, last });
      }
    }
  }

  void CheckCorners()
  {
    const auto count = static_cast<vtkIdType>(this->Mesh.points.size());
    for (const vtkIdType corner : this->Mesh.corners)
    {
      if (corner < 0 || corner >= count)
      {
        this->Lines.Fail("a polygon has the corner " + std::to_string(corner) + ", but there are " +
            std::to_string(count) + " points",
          "correct the file");
      }
    }
  }

  bool ReadField()
  {
    this->Lines.Word(); // its name
    const std::size_t arrays = this->ReadCount();
    for (std::size_t i = 0; i < arrays; ++i)
    {
      if (!this->Lines.NextLine())
      {
        this->Lines.Fail("the file ends within a field", "give a complete file");
      }
      if (Lower(this->Lines.Word()) == "metadata") // of the array before
      {
        this->Lines.SkipToEmptyLine();
        --i;
        continue;
      }
      const std::size_t components = this->ReadCount();
      const std::size_t tuples = this->ReadCount();
      const NumberType* type = this->ReadType();
      if (!type)
      {
        return this->EndAtStrings();
      }
      this->SkipNumbers(tuples, components, *type);
    }
    return true;
  }

  bool EndAtStrings()
  {
    if (this->Mesh.NumberOfFaces() == 0)
    {
      this->Lines.Fail("arrays of strings before the polygons are not supported", "remove them");
    }
    return false;
  }

  /// One of the attributes of points or cells: a name, a type, and what else its keyword asks for.
  bool ReadAttribute(const std::string& keyword)
  {
    const std::pair<const char*, std::size_t> components[] = { { "scalars", 1 }, { "vectors", 3 },
      { "normals", 3 }, { "tensors", 9 }, { "tensors6", 6 }, { "global_ids", 1 },
      { "pedigree_ids", 1 }, { "edge_flags", 1 }, { "texture_coordinates", 0 } };
    this->Lines.Word(); // its name
    if (keyword == "lookup_table" || keyword == "color_scalars")
    {
      const std::size_t count = this->ReadCount();
      const bool isTable = keyword == "lookup_table";
      const NumberType& type = this->IsBinary ? UnsignedChar : Float;
      this->SkipNumbers(isTable ? count : this->AttributeCount, isTable ? 4 : count, type);
      return true;
    }
    const auto found = std::find_if(std::begin(components), std::end(components),
      [&keyword](const auto& entry) { return keyword == entry.first; });
    if (found == std::end(components))
    {
      this->Lines.Fail(
        Quoted(keyword) + " is not a section of VTK's legacy format", "correct the file");
    }
    std::size_t count = found->second == 0 ? this->ReadCount() : found->second;
    const NumberType* type = this->ReadType();
    if (!type)
    {
      return this->EndAtStrings();
    }
    if (keyword == "scalars")
    {
      count = this->Lines.AtLineEnd() ? 1 : this->ReadCount();
      this->Lines.NextLine(); // LOOKUP_TABLE and its name
      this->Lines.SkipLine();
    }
    this->SkipNumbers(this->AttributeCount, count, *type);
    return true;
  }

  TextLines Lines;
  PolygonMesh Mesh;
  std::size_t AttributeCount = 0;
  bool HasTitle = false;
  bool HasOffsets = false; ///< Since version 5: cells as offsets and connectivity.
  bool IsBinary = false;
};

} // namespace

PolygonMesh ParseLegacyVtk(std::string_view bytes, const std::string& fileName)
{
  return LegacyVtk(bytes, fileName).Parse();
}

} // namespace program
