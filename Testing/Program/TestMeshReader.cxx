// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Console.h"
#include "MeshFiles.h"
#include "Reading/MeshReader.h"

#include "vtkBase64Utilities.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLPolyDataWriter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>

using program::PolygonMesh;

namespace
{

std::string FailureOfReading(const std::string& path)
{
  try
  {
    program::ReadMesh(path);
  }
  catch (const program::Failure& failure)
  {
    return failure.what();
  }
  return "none";
}

TEST(MeshReader, ReadsEveryFormat)
{
  const PolygonMesh mesh = Ellipsoid(4);
  for (const MeshBytes& file : WriteInAllFormats(mesh))
  {
    SCOPED_TRACE(file.name);
    const PolygonMesh read = program::ParseMesh(file.bytes, file.name).mesh;
    // In STL each triangle has points of its own.
    const bool isStl = file.name.find(".stl") != std::string::npos;
    const PolygonMesh& expected = isStl ? Soup(mesh) : mesh;
    EXPECT_EQ(read.corners, expected.corners);
    EXPECT_EQ(read.faceEnds, expected.faceEnds);
    ASSERT_EQ(read.points.size(), expected.points.size());
    // Legacy files of VTK have 11 digits, and binary STL has single precision.
    const double tolerance = file.name == "binary.stl" ? 1e-7
      : file.name.find("ascii") == 0                   ? 1e-10
                                                       : 0.0;
    for (std::size_t i = 0; i < expected.points.size(); ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        EXPECT_LE(std::abs(read.points[i][j] - expected.points[i][j]), tolerance) << "point " << i;
      }
    }
    EXPECT_EQ(read.isSinglePrecision, file.name == "binary.stl");
  }
}

TEST(MeshReader, GoesByTheExtensionInAnyCase)
{
  const std::string path = ScratchPath("Mesh.Off");
  std::ofstream(path) << "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(program::ReadMesh(path).mesh.NumberOfFaces(), 1U);
  std::filesystem::remove(path);
}

TEST(MeshReader, NamesTheReasonWhyAFileCannotBeRead)
{
  EXPECT_EQ(FailureOfReading(ScratchPath("none.off")),
    ScratchPath("none.off") + " does not exist : check the path");
  EXPECT_NE(FailureOfReading(testing::TempDir()).find("is a directory"), std::string::npos);
  for (const char* extension : { "off", "obj", "ply", "stl", "vtk", "vtp" })
  {
    const std::string path = ScratchPath(std::string("empty.") + extension);
    std::ofstream(path).close();
    EXPECT_EQ(FailureOfReading(path), path + " is empty : give a mesh");
    std::filesystem::remove(path);
  }
}

TEST(MeshReader, NamesTheReasonForTextAndForBytesThatAreNoMesh)
{
  const std::string bytes("\x7f\x45LF\x01\0\0\0\0\xff\x80 some bytes\n that are no mesh\n", 40);
  const std::pair<const char*, const char*> expected[] = { { "m.off", "not an OFF file" },
    { "m.ply", "not a PLY file" }, { "m.stl", "not an STL file" },
    { "m.vtk", "not a file in VTK's legacy format" }, { "m.vtp", "not a file in VTK's XML format" },
    { "m.txt", "unknown extension" } };
  for (const auto& [name, reason] : expected)
  {
    EXPECT_NE(FailureOf(bytes, name).find(reason), std::string::npos) << FailureOf(bytes, name);
    EXPECT_NE(FailureOf("a letter\nto a friend\n", name).find(reason), std::string::npos)
      << FailureOf("a letter\nto a friend\n", name);
  }
  EXPECT_NE(FailureOf(bytes, "m.obj").find("zero bytes"), std::string::npos);
  EXPECT_NE(FailureOf("a letter\nto a friend\n", "m.obj").find("no points"), std::string::npos);
  EXPECT_NE(
    FailureOf("OFF 3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "m.off").find("no triangles"), std::string::npos);
}

TEST(MeshReader, AcceptsAByteOrderMarkAndEitherLineEndInTextFormats)
{
  const PolygonMesh mesh = Ellipsoid(2);
  for (const MeshBytes& file : WriteInAllFormats(mesh))
  {
    const bool isText =
      file.name == "mesh.off" || file.name == "mesh.obj" || file.name.find("ascii") == 0;
    if (!isText || file.name == "ascii.vtp")
    {
      continue;
    }
    SCOPED_TRACE(file.name);
    std::string returns = file.bytes;
    std::string both;
    for (char& c : returns)
    {
      both += c == '\n' ? "\r\n" : std::string(1, c);
      c = c == '\n' ? '\r' : c;
    }
    for (const std::string& variant : { "\xef\xbb\xbf" + file.bytes, both, returns })
    {
      EXPECT_EQ(FailureOf(variant, file.name), "none");
      EXPECT_EQ(program::ParseMesh(variant, file.name).mesh.NumberOfFaces(), mesh.NumberOfFaces());
    }
  }
}

TEST(MeshReader, DoesNotMakeRoomForComponentsThatTheFileCannotHold)
{
  int files = 0;
  for (const MeshBytes& file : WriteInAllFormats(Ellipsoid(2)))
  {
    std::string bytes = file.bytes;
    const std::string good = "NumberOfComponents=\"3\"";
    const std::size_t at = bytes.find(good);
    if (file.name.find(".vtp") != std::string::npos && at != std::string::npos)
    {
      EXPECT_EQ(FailureOf(bytes, file.name), "none");
      // Not more than the file can hold, but so if there are as many for each point.
      const bool isCompressed = bytes.find("compressor=") != std::string::npos;
      const std::size_t most = (isCompressed ? 275 : 1) * bytes.size();
      bytes.replace(at, good.size(), "NumberOfComponents=\"" + std::to_string(most - 9) + "\"");
      EXPECT_NE(FailureOf(bytes, file.name).find("an array is larger than the file can hold"),
        std::string::npos)
        << file.name;
      ++files;
    }
  }
  EXPECT_GE(files, 2);
}

// VTK writes keys into its arrays: those that follow are still of points.
TEST(MeshReader, ChecksArraysBehindOneWithKeys)
{
  for (const MeshBytes& file : WriteInAllFormats(Ellipsoid(2)))
  {
    if (file.name == "ascii.vtp")
    {
      std::string bytes = file.bytes;
      const std::size_t at = bytes.find("<Points>") + 8;
      ASSERT_GE(at, 8u);
      const std::string key = "<InformationKey name=\"k\"></InformationKey>";
      bytes.insert(at,
        "<DataArray type=\"Int8\" Name=\"a\" format=\"ascii\">" + key +
          "</DataArray><DataArray type=\"Int8\" Name=\"b\" format=\"ascii\" NumberOfComponents=\"" +
          std::to_string(bytes.size() - 9) + "\"></DataArray>");
      EXPECT_NE(FailureOf(bytes, file.name).find("an array is larger than the file can hold"),
        std::string::npos);
    }
  }
}

// Else VTK takes whatever stands there for numbers of blocks, and makes room for them.
TEST(MeshReader, NeedsTheMarkBeforeAppendedData)
{
  int files = 0;
  for (const MeshBytes& file : WriteInAllFormats(Ellipsoid(2)))
  {
    const std::size_t appended = file.bytes.find("<AppendedData");
    if (file.name.find(".vtp") != std::string::npos && appended != std::string::npos)
    {
      ++files;
      std::string bytes = file.bytes;
      const std::size_t mark = bytes.find('_', appended);
      bytes.erase(mark, 1);
      bytes.insert(mark + 60, "_"); // in the middle of the data
      EXPECT_NE(FailureOf(bytes, file.name).find("do not begin with _"), std::string::npos)
        << file.name;
      if (file.bytes.find("encoding=\"base64\"", appended) != std::string::npos)
      {
        bytes = file.bytes;
        bytes.insert(mark + 6, " ");
        EXPECT_NE(
          FailureOf(bytes, file.name).find("size of an array is missing"), std::string::npos)
          << file.name;
      }
    }
  }
  EXPECT_EQ(files, 2);
}

TEST(MeshReader, DoesNotMakeRoomForCornersThatTheFileCannotHold)
{
  for (const MeshBytes& file : WriteInAllFormats(Ellipsoid(2)))
  {
    if (file.name == "ascii.vtp")
    {
      std::string bytes = file.bytes;
      const std::size_t last = bytes.rfind("240");
      ASSERT_NE(last, std::string::npos);
      bytes.replace(last, 3, "1744830704");
      EXPECT_NE(
        FailureOf(bytes, file.name).find("more corners than the file can hold"), std::string::npos);
    }
  }
}

/// A compressed file with other sizes of the blocks of its first array: their number, that of each
/// before, that of the last, and that of the first in the file.
std::string WithSizesOfBlocks(const std::string& file, const std::array<std::uint32_t, 4>& sizes)
{
  std::string words;
  for (const std::uint32_t size : sizes)
  {
    for (unsigned int bit = 0; bit < 32; bit += 8)
    {
      words += static_cast<char>((size >> bit) & 0xffU);
    }
  }
  std::string digits(24, '\0');
  vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(words.data()),
    static_cast<unsigned long>(words.size()), reinterpret_cast<unsigned char*>(digits.data()));
  std::string bytes = file;
  return bytes.replace(bytes.find('_', bytes.find("<AppendedData")) + 1, digits.size(), digits);
}

TEST(MeshReader, DoesNotMakeRoomForBlocksThatTheFileCannotHold)
{
  int files = 0;
  for (const MeshBytes& file : WriteInAllFormats(Ellipsoid(2)))
  {
    if (file.name != "appended.vtp")
    {
      continue;
    }
    ++files;
    const auto failure = [&file](const std::array<std::uint32_t, 4>& sizes)
    { return FailureOf(WithSizesOfBlocks(file.bytes, sizes), file.name); };
    const auto size = static_cast<std::uint32_t>(file.bytes.size());
    const std::string tooLarge = "an array is larger than the file can hold";
    EXPECT_NE(failure({ 1, 32768, 1008, size + 1 }).find(tooLarge), std::string::npos);
    EXPECT_NE(failure({ 1, 32768, 1008, 4000000000U }).find(tooLarge), std::string::npos);
    EXPECT_NE(failure({ 2, 4000000000U, 1008, 500 }).find(tooLarge), std::string::npos);
    EXPECT_NE(failure({ size + 1, 1, 0, 500 }).find(tooLarge), std::string::npos);
    const std::string invalid = "the sizes of the blocks of an array are invalid";
    EXPECT_NE(failure({ 1, 1000, 1008, 500 }).find(invalid), std::string::npos);
    EXPECT_NE(failure({ 1, 0, 0, 500 }).find(invalid), std::string::npos);
    EXPECT_NE(failure({ 0, 32768, 1008, 500 }).find(invalid), std::string::npos);
    EXPECT_NE(
      failure({ size / 2, 1, 0, 0 }).find("the size of an array is missing"), std::string::npos);
    // One block may be announced larger than it is, as all are made of one size but the last.
    EXPECT_EQ(failure({ 1, 4000000000U, 1008, 500 }).find(tooLarge), std::string::npos);
  }
  EXPECT_EQ(files, 1);
}

// VTK takes any element among arrays for one, and appended data by their offset.
TEST(MeshReader, ChecksArraysInWhateverWayTheyAreWritten)
{
  for (const MeshBytes& file : WriteInAllFormats(Ellipsoid(2)))
  {
    const auto expect = [&file](const std::string& good, const std::string& bad, const char* reason)
    {
      std::string bytes = file.bytes;
      const std::size_t at = bytes.find(good);
      ASSERT_NE(at, std::string::npos) << file.name << ": " << good;
      bytes.replace(at, good.size(), bad);
      EXPECT_NE(FailureOf(bytes, file.name).find(reason), std::string::npos)
        << file.name << ": " << FailureOf(bytes, file.name);
    };
    if (file.name == "appended.vtp")
    {
      expect("format=\"appended\"", "format=\"ascii\" offset=\"99999999\"", "not in the file");
    }
    if (file.name == "ascii.vtp")
    {
      expect("<PointData", "<!DOCTYPE a><PointData", "other than elements and comments");
      expect("<PointData", "<!-- <PointData", "other than elements and comments");
      expect("NumberOfPoints=\"42\"", "NumberOfPoints=\"&#52;2\"", "more than the file can hold");
      const std::string some = std::to_string(file.bytes.size() / 20);
      expect("<Points>",
        "<Points><!-- <FieldData> --><Any type=\"Int8\" format=\"ascii\" NumberOfComponents=\"" +
          some + "\"/>",
        "an array is larger than the file can hold");
    }
  }
}

TEST(MeshReader, LeavesOutGhostCells)
{
  vtkNew<vtkPolyData> data;
  data->DeepCopy(Ellipsoid(2).ToPolyData());
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(data->GetNumberOfCells());
  ghosts->FillValue(0);
  ghosts->SetValue(3, vtkDataSetAttributes::DUPLICATECELL);
  ghosts->SetValue(5, vtkDataSetAttributes::HIDDENCELL);
  data->GetCellData()->AddArray(ghosts);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->WriteToOutputStringOn();
  writer->Write();
  EXPECT_EQ(program::ParseMesh(writer->GetOutputString(), "m.vtp").mesh.NumberOfFaces(),
    Ellipsoid(2).NumberOfFaces() - 2);
}

} // namespace
