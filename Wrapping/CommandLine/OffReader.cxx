// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OffReader.h"

#include "Console.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <vector>

namespace program
{
namespace
{

bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// Walks over the lines that say something, and over the words of such a line.
class Lines
{
public:
  Lines(const std::string& text, std::string fileName)
    : Next(text.c_str())
    , TextEnd(text.c_str() + text.size())
    , FileName(std::move(fileName))
  {
  }

  /// Goes to the next line that is neither empty nor a comment. False at the end of the text.
  bool NextLine()
  {
    while (this->Next < this->TextEnd)
    {
      ++this->Number;
      this->At = this->Next;
      const char* lineEnd = std::find(this->Next, this->TextEnd, '\n');
      this->Next = lineEnd == this->TextEnd ? lineEnd : lineEnd + 1;
      this->End = std::find(this->At, lineEnd, '#');
      if (!this->AtLineEnd())
      {
        return true;
      }
    }
    return false;
  }

  bool AtLineEnd()
  {
    while (this->At < this->End && IsBlank(*this->At))
    {
      ++this->At;
    }
    return this->At == this->End;
  }

  std::string PeekWord()
  {
    return this->AtLineEnd() ? std::string()
                             : std::string(this->At, std::find_if(this->At, this->End, IsBlank));
  }

  void SkipWord() { this->At += this->PeekWord().size(); }

  std::optional<double> Real()
  {
    return this->Take<double>([](const char* at, char** end) { return std::strtod(at, end); });
  }

  std::optional<long long> Integer()
  {
    return this->Take<long long>(
      [](const char* at, char** end) { return std::strtoll(at, end, 10); });
  }

  [[noreturn]] void Fail(const std::string& what, const std::string& whatToDo) const
  {
    throw Failure(
      this->FileName + ", line " + std::to_string(this->Number) + ": " + what, whatToDo);
  }

private:
  // A number has to be a whole word, and strto* may not run on into the next line.
  template <typename T, typename Parser>
  std::optional<T> Take(Parser parse)
  {
    if (this->AtLineEnd())
    {
      return std::nullopt;
    }
    char* end = nullptr;
    const T value = parse(this->At, &end);
    if (end == this->At || end > this->End || (end < this->End && !IsBlank(*end)))
    {
      return std::nullopt;
    }
    this->At = end;
    return value;
  }

  const char* Next;
  const char* TextEnd;
  const char* At = nullptr;
  const char* End = nullptr;
  long long Number = 0;
  std::string FileName;
};

/// Reads [ST][C][N][4][n]OFF, if it is there, and goes to the counts.
void ReadHeader(Lines& lines)
{
  if (!lines.NextLine())
  {
    lines.Fail("the file is empty", "give a mesh");
  }
  std::string keyword = lines.PeekWord();
  if (keyword.find_first_not_of("0123456789") == std::string::npos)
  {
    return; // The keyword may be missing.
  }
  std::transform(keyword.begin(), keyword.end(), keyword.begin(),
    [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const bool isOff = keyword.size() >= 3 && keyword.compare(keyword.size() - 3, 3, "OFF") == 0 &&
    keyword.find_first_not_of("STCN4OF") == std::string::npos;
  if (!isOff)
  {
    lines.Fail("this is not an OFF file, it does not begin with OFF", "give a mesh in OFF format");
  }
  if (keyword.find('4') != std::string::npos || lines.PeekWord().find('n') == 0)
  {
    lines.Fail("points in other than three dimensions are not read", "convert the mesh to OFF");
  }
  lines.SkipWord();
  if (lines.PeekWord() == "BINARY")
  {
    lines.Fail("binary OFF is not read", "convert the mesh to ASCII OFF or PLY");
  }
  if (lines.AtLineEnd() && !lines.NextLine())
  {
    lines.Fail("the file ends after its header", "give a complete file");
  }
}

long long ReadCount(Lines& lines, const char* of, std::size_t fileSize)
{
  const std::optional<long long> count = lines.Integer();
  if (!count || *count < 0)
  {
    lines.Fail(std::string("the number of ") + of + " was expected here",
      "write the numbers of vertices, faces and edges");
  }
  // A vertex or face takes at least two characters, so that memory for lies is never asked for.
  if (static_cast<unsigned long long>(*count) > fileSize)
  {
    lines.Fail(std::to_string(*count) + " " + of + " do not fit in a file of " +
        std::to_string(fileSize) + " bytes",
      "give a complete file");
  }
  return *count;
}

void NextItem(Lines& lines, const char* kind, long long done, long long count)
{
  if (!lines.NextLine())
  {
    lines.Fail(
      "the file ends after " + std::to_string(done) + " of " + std::to_string(count) + " " + kind,
      "give a complete file");
  }
}

void ReadFace(Lines& lines, long long vertexCount, std::vector<vtkIdType>& corners)
{
  const std::optional<long long> size = lines.Integer();
  if (!size || *size < 0)
  {
    lines.Fail("a face has to begin with its number of corners", "correct the line");
  }
  corners.clear();
  for (long long i = 0; i < *size; ++i)
  {
    const std::optional<long long> corner = lines.Integer();
    if (!corner)
    {
      lines.Fail("a face of " + std::to_string(*size) + " corners needs as many vertex numbers",
        "correct the line");
    }
    if (*corner < 0 || *corner >= vertexCount)
    {
      lines.Fail("there is no vertex " + std::to_string(*corner) + ", they are numbered 0 to " +
          std::to_string(vertexCount - 1),
        "correct the line");
    }
    corners.push_back(static_cast<vtkIdType>(*corner));
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> ParseOff(const std::string& text, const std::string& fileName)
{
  Lines lines(text, fileName);
  ReadHeader(lines);
  const long long vertexCount = ReadCount(lines, "vertices", text.size());
  if (lines.AtLineEnd())
  {
    lines.NextLine();
  }
  const long long faceCount = ReadCount(lines, "faces", text.size());

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->Allocate(static_cast<vtkIdType>(vertexCount));
  for (long long i = 0; i < vertexCount; ++i)
  {
    NextItem(lines, "vertices", i, vertexCount);
    const std::optional<double> x = lines.Real();
    const std::optional<double> y = lines.Real();
    const std::optional<double> z = lines.Real();
    if (!x || !y || !z)
    {
      lines.Fail("a vertex needs three numbers", "correct the line");
    }
    points->InsertNextPoint(*x, *y, *z);
  }

  vtkNew<vtkCellArray> faces;
  std::vector<vtkIdType> corners;
  for (long long i = 0; i < faceCount; ++i)
  {
    NextItem(lines, "faces", i, faceCount);
    ReadFace(lines, vertexCount, corners);
    if (corners.size() >= 3)
    {
      faces->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
    }
  }

  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(faces);
  return mesh;
}

vtkSmartPointer<vtkPolyData> ReadOff(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
  {
    throw Failure(fileName + " cannot be opened", "check its name and permissions");
  }
  const std::string text{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  if (file.bad())
  {
    throw Failure(fileName + " cannot be read to its end", "check the disk");
  }
  return ParseOff(text, fileName);
}

} // namespace program
