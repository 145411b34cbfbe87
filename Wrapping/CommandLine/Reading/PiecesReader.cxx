// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/PiecesReader.h"

#include "Console.h"
#include "Reading/FileBytes.h"
#include "Reading/XmlVtkReader.h"

#include "vtkAppendPolyData.h"
#include "vtkNew.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

#include <filesystem>

namespace program
{

namespace fs = std::filesystem;

namespace
{

/// VTK warns of files without points, which ranks that have none write.
bool IsEmpty(const std::string& bytes)
{
  const auto piece = bytes.find("<Piece");
  return piece != std::string::npos && bytes.find("<Piece", piece + 1) == std::string::npos &&
    bytes.substr(piece, bytes.find('>', piece) - piece).find(" NumberOfPoints=\"0\"") !=
    std::string::npos;
}

} // namespace

bool IsOfPieces(const std::string& fileName)
{
  return ExtensionOf(fileName) == ".pvtp";
}

std::vector<std::string> PiecesOf(const std::string& fileName)
{
  const auto root =
    vtk::TakeSmartPointer(vtkXMLUtilities::ReadElementFromString(ReadBytes(fileName).c_str()));
  vtkXMLDataElement* data = root ? root->FindNestedElementWithName("PPolyData") : nullptr;
  if (!data)
  {
    throw Failure(fileName + " is not a .pvtp of VTK", "correct the file");
  }
  std::vector<std::string> pieces;
  for (int i = 0; i < data->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* piece = data->GetNestedElement(i);
    const char* source = piece->GetAttribute("Source");
    if (std::string(piece->GetName()) == "Piece" && source)
    {
      pieces.push_back((fs::path(fileName).parent_path() / source).string());
    }
  }
  if (pieces.empty())
  {
    throw Failure(fileName + " names no pieces", "give the mesh of a surface");
  }
  return pieces;
}

vtkSmartPointer<vtkPolyData> ReadPieces(const std::string& fileName, int rank, int ranks)
{
  const std::vector<std::string> pieces = PiecesOf(fileName);
  const auto firstOf = [&pieces, ranks](int i)
  { return pieces.size() * static_cast<std::size_t>(i) / static_cast<std::size_t>(ranks); };
  vtkNew<vtkAppendPolyData> append;
  for (std::size_t i = firstOf(rank); i < firstOf(rank + 1); ++i)
  {
    const std::string bytes = ReadBytes(pieces[i]);
    if (!IsEmpty(bytes))
    {
      append->AddInputData(ParseXmlVtk(bytes, pieces[i]));
    }
  }
  if (append->GetNumberOfInputConnections(0) == 0)
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  append->Update();
  return append->GetOutput();
}

} // namespace program
