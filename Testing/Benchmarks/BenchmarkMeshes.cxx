// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMeshes.h"

#include "vtkRidgeExampleSource.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <fstream>

namespace benchmarks
{

vtkSmartPointer<vtkPolyData> EllipsoidMesh(int frequency)
{
  vtkNew<vtkRidgeExampleSource> source;
  source->SetSurfaceToEllipsoid();
  source->SetFrequency(frequency);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> ReadOff(const std::string& path)
{
  std::ifstream file(path);
  std::string keyword;
  vtkIdType pointCount = 0;
  vtkIdType faceCount = 0;
  vtkIdType edgeCount = 0;
  file >> keyword >> pointCount >> faceCount >> edgeCount;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; file && i < pointCount; ++i)
  {
    double point[3];
    file >> point[0] >> point[1] >> point[2];
    points->InsertNextPoint(point);
  }
  vtkNew<vtkCellArray> polys;
  for (vtkIdType i = 0; file && i < faceCount; ++i)
  {
    int size = 0;
    vtkIdType corners[3];
    file >> size >> corners[0] >> corners[1] >> corners[2];
    polys->InsertNextCell(3, corners);
  }
  if (!file)
  {
    return nullptr;
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

} // namespace benchmarks
