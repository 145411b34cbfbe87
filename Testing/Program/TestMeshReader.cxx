// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Console.h"
#include "MeshReader.h"

#include "vtkCellArray.h"
#include "vtkFeatureEdges.h"
#include "vtkNew.h"
#include "vtkOBJWriter.h"
#include "vtkPLYWriter.h"
#include "vtkPolyDataWriter.h"
#include "vtkRidgeExampleSource.h"
#include "vtkSTLWriter.h"
#include "vtkXMLPolyDataWriter.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace
{

vtkSmartPointer<vtkPolyData> Sphere()
{
  vtkNew<vtkRidgeExampleSource> source;
  source->SetSurfaceToEllipsoid();
  source->SetFrequency(4);
  source->Update();
  return source->GetOutput();
}

std::string PathOf(const std::string& name)
{
  return (std::filesystem::path(testing::TempDir()) / name).string();
}

template <typename Writer>
void ExpectReadBack(const std::string& name)
{
  const vtkSmartPointer<vtkPolyData> mesh = Sphere();
  vtkNew<Writer> writer;
  writer->SetFileName(PathOf(name).c_str());
  writer->SetInputData(mesh);
  writer->Write();
  const vtkSmartPointer<vtkPolyData> read = program::ReadMesh(PathOf(name));
  std::filesystem::remove(PathOf(name));
  EXPECT_EQ(read->GetNumberOfPoints(), mesh->GetNumberOfPoints());
  EXPECT_EQ(read->GetNumberOfPolys(), mesh->GetNumberOfPolys());
}

TEST(MeshReader, ReadsByExtensionInAnyCase)
{
  ExpectReadBack<vtkOBJWriter>("mesh.obj");
  ExpectReadBack<vtkPLYWriter>("mesh.ply");
  ExpectReadBack<vtkSTLWriter>("mesh.STL");
  ExpectReadBack<vtkPolyDataWriter>("mesh.Vtk");
  ExpectReadBack<vtkXMLPolyDataWriter>("mesh.vtp");
}

TEST(MeshReader, RejectsOtherFiles)
{
  EXPECT_THROW(program::ReadMesh(PathOf("no-such-file.off")), program::Failure);
  EXPECT_THROW(program::ReadMesh(testing::TempDir()), program::Failure);
}

TEST(MeshReader, MergesPointsAtTheSamePlace)
{
  // Each triangle with corners of its own.
  const vtkSmartPointer<vtkPolyData> mesh = Sphere();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    vtkIdType corners[3];
    for (int j = 0; j < 3; ++j)
    {
      corners[j] = points->InsertNextPoint(mesh->GetPoint(mesh->GetCell(i)->GetPointId(j)));
    }
    triangles->InsertNextCell(3, corners);
  }
  vtkNew<vtkPolyData> soup;
  soup->SetPoints(points);
  soup->SetPolys(triangles);

  program::Mending mending;
  EXPECT_EQ(program::Mend(soup, mending)->GetNumberOfPoints(), 3 * mesh->GetNumberOfPolys());
  mending.merge = true;
  const vtkSmartPointer<vtkPolyData> merged = program::Mend(soup, mending);
  EXPECT_EQ(merged->GetNumberOfPoints(), mesh->GetNumberOfPoints());
  EXPECT_EQ(merged->GetNumberOfPolys(), mesh->GetNumberOfPolys());
}

TEST(MeshReader, OrientsTrianglesOutward)
{
  const vtkSmartPointer<vtkPolyData> mesh = Sphere();
  vtkNew<vtkPolyData> mixed;
  mixed->DeepCopy(mesh);
  for (vtkIdType i = 0; i < mixed->GetNumberOfPolys(); i += 3)
  {
    mixed->ReverseCell(i);
  }
  program::Mending mending;
  mending.orient = true;
  const vtkSmartPointer<vtkPolyData> oriented = program::Mend(mixed, mending);
  ASSERT_EQ(oriented->GetNumberOfPolys(), mesh->GetNumberOfPolys());
  for (vtkIdType i = 0; i < oriented->GetNumberOfPolys(); ++i)
  {
    double a[3];
    double b[3];
    double c[3];
    vtkCell* triangle = oriented->GetCell(i);
    oriented->GetPoint(triangle->GetPointId(0), a);
    oriented->GetPoint(triangle->GetPointId(1), b);
    oriented->GetPoint(triangle->GetPointId(2), c);
    // The origin is inside of the convex surface: outward is a positive volume.
    const double volume = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
      a[2] * (b[0] * c[1] - b[1] * c[0]);
    EXPECT_GT(volume, 0.0) << "triangle " << i;
  }
}

} // namespace
