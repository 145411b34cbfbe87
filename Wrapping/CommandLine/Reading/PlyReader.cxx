// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/PlyReader.h"

#include "Console.h"
#include "Reading/ByteOrder.h"
#include "Reading/PlyHeader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace program
{
namespace
{

/// Where an error is: the element that is read.
struct Place
{
  std::string fileName;
  const PlyElement* element = nullptr;
  std::size_t index = 0;

  [[noreturn]] void Fail(const std::string& what, const char* whatToDo = "correct the file") const
  {
    throw Failure(this->fileName + ", " + Quoted(this->element->name) + " " +
        std::to_string(this->index) + ": " + what,
      whatToDo);
  }

  [[noreturn]] void FailAtEnd() const
  {
    throw Failure(this->fileName + ": the file ends after " +
        CountOf(this->index, this->element->count, "elements ") + Quoted(this->element->name),
      "give a complete file");
  }
};

/// The numbers of an ASCII file. An element begins on a line of its own.
class AsciiNumbers
{
public:
  AsciiNumbers(TextLines& lines, const Place& place)
    : Lines(lines)
    , At(place)
  {
  }

  void BeginElement()
  {
    if (!this->Lines.NextLine())
    {
      this->At.FailAtEnd();
    }
  }

  double Next(PlyType)
  {
    // Long lists may go on in the next line.
    if (!this->Lines.NextWord())
    {
      this->At.FailAtEnd();
    }
    const std::optional<double> number = this->Lines.Real();
    if (!number)
    {
      this->Lines.Fail(Quoted(this->Lines.PeekWord()) + " is not a number", "correct the line");
    }
    return *number;
  }

  void Skip(PlyType type, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Next(type);
    }
  }

  std::size_t MostNumbersLeft(PlyType) const { return this->Lines.CharactersLeft(); }

  bool AtEnd() const { return !this->Lines.NextLine(); }

private:
  TextLines& Lines;
  const Place& At;
};

/// The numbers of a binary file.
class BinaryNumbers
{
public:
  BinaryNumbers(const char* begin, std::size_t size, ByteOrder order, const Place& place)
    : Begin(begin)
    , End(begin + size)
    , Order(order)
    , At(place)
  {
  }

  void BeginElement() {}

  double Next(PlyType type)
  {
    switch (type)
    {
      case PlyType::Int8:
        return this->Take<std::int8_t>();
      case PlyType::UInt8:
        return this->Take<std::uint8_t>();
      case PlyType::Int16:
        return this->Take<std::int16_t>();
      case PlyType::UInt16:
        return this->Take<std::uint16_t>();
      case PlyType::Int32:
        return this->Take<std::int32_t>();
      case PlyType::UInt32:
        return this->Take<std::uint32_t>();
      case PlyType::Int64:
        return static_cast<double>(this->Take<std::int64_t>());
      case PlyType::UInt64:
        return static_cast<double>(this->Take<std::uint64_t>());
      case PlyType::Float32:
        return this->Take<float>();
      case PlyType::Float64:
        break;
    }
    return this->Take<double>();
  }

  void Skip(PlyType type, std::size_t count)
  {
    if (count > this->MostNumbersLeft(type))
    {
      this->At.FailAtEnd();
    }
    this->Begin += count * SizeOf(type);
  }

  std::size_t MostNumbersLeft(PlyType type) const
  {
    return static_cast<std::size_t>(this->End - this->Begin) / SizeOf(type);
  }

  /// But for a line end or a padding.
  bool AtEnd() const
  {
    const auto isBlank = [](char c) { return c == '\0' || c == '\n' || c == '\r' || c == ' '; };
    return std::all_of(this->Begin, this->End, isBlank);
  }

private:
  template <typename T>
  T Take()
  {
    if (static_cast<std::size_t>(this->End - this->Begin) < sizeof(T))
    {
      this->At.FailAtEnd();
    }
    const T value = LoadNumber<T>(this->Begin, this->Order);
    this->Begin += sizeof(T);
    return value;
  }

  const char* Begin;
  const char* End;
  ByteOrder Order;
  const Place& At;
};

template <typename Numbers>
class PlyBody
{
public:
  PlyBody(const PlyHeader& header, Numbers& numbers, Place& place, PolygonMesh& mesh)
    : Header(header)
    , Source(numbers)
    , At(place)
    , Mesh(mesh)
  {
    for (const PlyElement& element : header.elements)
    {
      this->NumberOfVertices +=
        element.name == "vertex" ? static_cast<vtkIdType>(element.count) : 0;
    }
  }

  void Read()
  {
    for (const PlyElement& element : this->Header.elements)
    {
      this->At.element = &element;
      this->At.index = 0;
      if (element.name == "vertex")
      {
        this->ReadVertices(element);
      }
      else if (element.name == "face")
      {
        this->ReadFaces(element);
      }
      else if (element.name == "tristrips")
      {
        this->ReadStrips(element);
      }
      else
      {
        this->ForEach(element, [this, &element] { this->ReadElement(element, -1); });
      }
    }
    if (!this->Source.AtEnd())
    {
      throw Failure(this->At.fileName +
          ": the file goes on after the elements that its header "
          "announces",
        "correct the counts in the header");
    }
  }

private:
  /// Not more than there are bytes left: a false count cannot make us allocate.
  std::size_t MostElements(const PlyElement& element) const
  {
    return std::min(element.count, this->Source.MostNumbersLeft(PlyType::UInt8));
  }

  template <typename Body>
  void ForEach(const PlyElement& element, const Body& body)
  {
    const std::size_t count = element.properties.empty() ? 0 : element.count;
    for (; this->At.index < count; ++this->At.index)
    {
      this->Source.BeginElement();
      body();
    }
  }

  /// The numbers of one element: Scalars has those of each property that is no list, List those of
  /// the property named, and other lists are skipped.
  void ReadElement(const PlyElement& element, int list)
  {
    this->Scalars.resize(element.properties.size());
    this->List.clear();
    for (std::size_t i = 0; i < element.properties.size(); ++i)
    {
      const PlyProperty& property = element.properties[i];
      if (!property.isList)
      {
        this->Scalars[i] = this->Source.Next(property.type);
        continue;
      }
      const std::size_t count = this->ReadListSize(property);
      if (static_cast<int>(i) != list)
      {
        this->Source.Skip(property.type, count);
        continue;
      }
      for (std::size_t k = 0; k < count; ++k)
      {
        this->List.push_back(this->ReadVertexNumber(property.type));
      }
    }
  }

  std::size_t ReadListSize(const PlyProperty& property)
  {
    const double count = this->Source.Next(property.countType);
    if (!(count >= 0.0) || count != std::floor(count))
    {
      this->At.Fail("a list has an invalid size");
    }
    if (count > static_cast<double>(this->Source.MostNumbersLeft(property.type)))
    {
      this->At.FailAtEnd();
    }
    return static_cast<std::size_t>(count);
  }

  /// Not a number stands for itself in the comparison, which fails.
  vtkIdType ReadVertexNumber(PlyType type)
  {
    const double number = this->Source.Next(type);
    if (!(std::abs(number) < 9e15) || number != std::floor(number))
    {
      this->At.Fail("a corner is not the number of a vertex");
    }
    return static_cast<vtkIdType>(number);
  }

  void ReadVertices(const PlyElement& element)
  {
    const int place[3] = { element.Find("x"), element.Find("y"), element.Find("z") };
    for (const int i : place)
    {
      if (i < 0 || element.properties[i].isList)
      {
        throw Failure(this->At.fileName + ": the vertices lack x, y or z", "give a mesh in space");
      }
      this->Mesh.isSinglePrecision |= element.properties[i].type == PlyType::Float32;
    }
    this->Mesh.points.reserve(this->Mesh.points.size() + this->MostElements(element));
    this->ForEach(element,
      [this, &element, &place]
      {
        this->ReadElement(element, -1);
        this->Mesh.points.push_back(
          { this->Scalars[place[0]], this->Scalars[place[1]], this->Scalars[place[2]] });
      });
  }

  int FindCorners(const PlyElement& element) const
  {
    const int plural = element.Find("vertex_indices");
    const int list = plural >= 0 ? plural : element.Find("vertex_index");
    if (element.count > 0 && (list < 0 || !element.properties[list].isList))
    {
      throw Failure(this->At.fileName + ": the elements " + Quoted(element.name) +
          " lack the list vertex_indices",
        "give a mesh with faces");
    }
    return list;
  }

  void ReadFaces(const PlyElement& element)
  {
    const int list = this->FindCorners(element);
    this->Mesh.faceEnds.reserve(this->MostElements(element));
    this->ForEach(element,
      [this, &element, list]
      {
        this->ReadElement(element, list);
        for (const vtkIdType corner : this->List)
        {
          this->CheckVertex(corner);
        }
        this->Mesh.corners.insert(this->Mesh.corners.end(), this->List.begin(), this->List.end());
        this->Mesh.EndFace();
      });
  }

  void ReadStrips(const PlyElement& element)
  {
    const int list = this->FindCorners(element);
    constexpr vtkIdType unsignedEnd = std::numeric_limits<std::uint32_t>::max();
    std::vector<vtkIdType> strip;
    this->ForEach(element,
      [this, &element, &strip, list]
      {
        this->ReadElement(element, list);
        this->List.push_back(-1);
        for (const vtkIdType corner : this->List)
        {
          if (corner == -1 || corner == unsignedEnd)
          {
            this->Mesh.AddStrip(strip);
            strip.clear();
            continue;
          }
          this->CheckVertex(corner);
          strip.push_back(corner);
        }
      });
  }

  void CheckVertex(vtkIdType vertex) const
  {
    if (vertex < 0 || vertex >= this->NumberOfVertices)
    {
      this->At.Fail("there is no vertex " + std::to_string(vertex) + ", they are numbered 0 to " +
        std::to_string(this->NumberOfVertices - 1));
    }
  }

  const PlyHeader& Header;
  Numbers& Source;
  Place& At;
  PolygonMesh& Mesh;
  vtkIdType NumberOfVertices = 0; ///< Also of those that come after the faces.
  std::vector<double> Scalars;
  std::vector<vtkIdType> List;
};

template <typename Numbers>
void ReadBody(const PlyHeader& header, Numbers numbers, Place& place, PolygonMesh& mesh)
{
  PlyBody<Numbers>(header, numbers, place, mesh).Read();
}

} // namespace

PolygonMesh ParsePly(std::string_view bytes, const std::string& fileName)
{
  TextLines lines(bytes, fileName, '\0');
  const PlyHeader header = ReadPlyHeader(lines);
  Place place{ fileName };
  PolygonMesh mesh;
  if (header.format == PlyFormat::Ascii)
  {
    ReadBody(header, AsciiNumbers(lines, place), place, mesh);
  }
  else
  {
    const std::size_t size = lines.BytesLeft();
    const char* begin = lines.Bytes(size);
    const ByteOrder order =
      header.format == PlyFormat::BigEndian ? ByteOrder::BigEndian : ByteOrder::LittleEndian;
    ReadBody(header, BinaryNumbers(begin, size, order, place), place, mesh);
  }
  return mesh;
}

} // namespace program
