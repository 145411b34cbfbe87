// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"
#include "Reading/LegacyVtkReader.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataWriter.h"
#include "vtkStripper.h"

#include <gtest/gtest.h>

namespace
{

using Ids = std::vector<vtkIdType>;
using program::PolygonMesh;

const std::string Head = "# vtk DataFile Version 4.2\ntitle\nASCII\nDATASET POLYDATA\n";
const std::string Points = "POINTS 4 float\n0 0 0 1 0 0 0 1 0\n1 1 0\n";
const std::string Polygons = "POLYGONS 2 8\n3 0 1 2\n3 2 1 3\n";

PolygonMesh Parse(const std::string& text)
{
  return program::ParseLegacyVtk(text, "m.vtk");
}

std::string ReasonOf(const std::string& text)
{
  return FailureOf(text, "m.vtk");
}

/// With arrays of points and cells, and with strips if asked for.
std::string WriteByVtk(bool isBinary, bool isVersion4, bool hasStrips)
{
  vtkNew<vtkPolyData> data;
  data->DeepCopy(Ellipsoid(2).ToPolyData());
  if (hasStrips)
  {
    vtkNew<vtkStripper> stripper;
    stripper->SetInputData(data);
    stripper->Update();
    data->DeepCopy(stripper->GetOutput());
  }
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("a vector");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(data->GetNumberOfPoints());
  vectors->Fill(0.5);
  data->GetPointData()->SetVectors(vectors);
  vtkNew<vtkIntArray> scalars;
  scalars->SetName("scalars");
  scalars->SetNumberOfValues(data->GetNumberOfPoints());
  scalars->Fill(7);
  data->GetPointData()->SetScalars(scalars);
  vtkNew<vtkIntArray> other;
  other->SetName("other");
  other->SetNumberOfValues(data->GetNumberOfCells());
  other->Fill(10); // a line end
  data->GetCellData()->AddArray(other);
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetFileType(isBinary ? VTK_BINARY : VTK_ASCII);
  if (isVersion4)
  {
    writer->SetFileVersion(vtkPolyDataWriter::VTK_LEGACY_READER_VERSION_4_2);
  }
  writer->WriteToOutputStringOn();
  writer->Write();
  return { writer->GetOutputString(), static_cast<std::size_t>(writer->GetOutputStringLength()) };
}

TEST(LegacyVtkReader, ReadsWhatVtkWrites)
{
  for (int variant = 0; variant < 8; ++variant)
  {
    SCOPED_TRACE(variant);
    const bool hasStrips = (variant & 4) != 0;
    const std::string bytes = WriteByVtk((variant & 1) != 0, (variant & 2) != 0, hasStrips);
    EXPECT_EQ(ReasonOf(bytes), "none");
    EXPECT_EQ(Parse(bytes).NumberOfFaces(), 80U);
    // Also where only arrays are cut.
    EXPECT_NE(ReasonOf(bytes.substr(0, bytes.size() - 20)).find("ends"), std::string::npos)
      << ReasonOf(bytes.substr(0, bytes.size() - 20));
  }
}

TEST(LegacyVtkReader, KeepsTheOrientationOfStrips)
{
  EXPECT_EQ(
    Parse(Head + Points + "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\n").corners, (Ids{ 0, 1, 2, 1, 3, 2 }));
}

TEST(LegacyVtkReader, ReadsAnEmptyTitleAndFieldsBeforeThePoints)
{
  const std::string text = "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nFIELD FieldData "
                           "1\nTime 1 1 double\n0.5\n" +
    Points + "VERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\n" + Polygons;
  EXPECT_EQ(Parse(text).corners, (Ids{ 0, 1, 2, 2, 1, 3 }));
}

TEST(LegacyVtkReader, ReadsEveryKindOfAttribute)
{
  const std::string attributes =
    "POINT_DATA 4\nSCALARS s unsigned_char 2\nLOOKUP_TABLE t\n1 2 3 4 5 6 7 8\nLOOKUP_TABLE t 1\n"
    "0 0 0 1\nCOLOR_SCALARS c 1\n0 0 0 0\nNORMALS n float\n0 0 1 0 0 1 0 0 1 0 0 1\n"
    "TEXTURE_COORDINATES u 2 float\n0 0 0 0 0 0 0 0\nMETADATA\nCOMPONENT_NAMES\nNORMALS\nn\n\n"
    "CELL_DATA 2\nTENSORS t double\n1 0 0 0 1 0 0 0 1\n1 0 0 0 1 0 0 0 1\nGLOBAL_IDS g vtkIdType\n"
    "0 1\nFIELD f 2\na 1 2 bit\n0 1\nb 0 2 int\n\n";
  EXPECT_EQ(ReasonOf(Head + Points + Polygons + attributes), "none");
}

TEST(LegacyVtkReader, RejectsInvalidFiles)
{
  const std::string version5 = "# vtk DataFile Version 5.1\ntitle\nASCII\nDATASET POLYDATA\n";
  const std::pair<std::string, const char*> invalid[] = {
    { "# vtk\n", "line 1: this is not a file in VTK's legacy format" },
    { "# vtk DataFile Version 4.2\ntitle\nASCII\nDATASET STRUCTURED_GRID\n",
      "line 4: the dataset is of type 'structured_grid'" },
    { Head + "POINTS 4 real\n", "line 5: 'real' is not a type" },
    { Head + "POINTS 4 float\n0 0 0 1\n", "the file ends before the 12 numbers announced" },
    { Head + "POINTS 99999999999 float\n0 0 0 1\n",
      "the file ends before the 299999999997 numbers" },
    { Head + "POINTS 4 float\n0 0 zero\n0 0 0 0 0 0 0 0 0\n", "'zero' is not a number" },
    { Head + Points + "POLYGONS 2 8\n3 0 1 2\n9 2 1 3\n", "a cell has more corners than its list" },
    { Head + Points + "POLYGONS 3 8\n3 0 1 2\n3 2 1 3\n", "2 of 3 cells fill their list" },
    { Head + Points + "POLYGONS 2 9\n3 0 1 2\n3 2 1 3\n", "the file ends before the 9 numbers" },
    { Head + Points + "POLYGONS 2 8\n3 0 1 2\n3 2 1 4\n", "a polygon has the corner 4" },
    { Head + Points + "POLYGONS 2 8\n3 0 1 2\n3 2 1 -1\n", "a polygon has the corner -1" },
    { Head + Points + "POLYGONS 2 8\n3 0 1 2\n3 2 1 .5\n", "not a number of a point" },
    { Head + Points + Polygons + "MYSTERY 1\n", "'mystery' is not a section" },
    { Head + Points + Polygons + "CELL_DATA 2\nVECTORS v float\n0 0 0\n", "ends before the 6" },
    { version5 + Points +
        "POLYGONS 3 6\nOFFSETS vtktypeint64\n0 3 7\nCONNECTIVITY vtktypeint64\n"
        "0 1 2 2 1 3\n",
      "offsets and corners of cells do not fit together" },
    { version5 + Points +
        "POLYGONS 3 6\nOFFSETS vtktypeint64\n0 9 6\nCONNECTIVITY vtktypeint64\n"
        "0 1 2 2 1 3\n",
      "offsets and corners of cells do not fit together" },
    { version5 + Points + "POLYGONS 3 6\n3 0 1 2\n", "offsets of cells are missing" },
  };
  for (const auto& [text, expected] : invalid)
  {
    EXPECT_NE(ReasonOf(text).find(expected), std::string::npos)
      << text << "fails with: " << ReasonOf(text);
  }
}

} // namespace
