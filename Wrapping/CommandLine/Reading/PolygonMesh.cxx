// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/PolygonMesh.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>

namespace program
{

void PolygonMesh::EndFace()
{
  const std::size_t begin = this->faceEnds.empty() ? 0 : this->faceEnds.back();
  if (this->corners.size() - begin < 3)
  {
    this->corners.resize(begin);
    return;
  }
  this->faceEnds.push_back(this->corners.size());
}

void PolygonMesh::AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
{
  this->corners.insert(this->corners.end(), { a, b, c });
  this->EndFace();
}

void PolygonMesh::AddStrip(const std::vector<vtkIdType>& strip)
{
  for (std::size_t i = 2; i < strip.size(); ++i)
  {
    const bool isOdd = i % 2 != 0;
    this->AddTriangle(strip[i - 2], strip[isOdd ? i : i - 1], strip[isOdd ? i - 1 : i]);
  }
}

vtkSmartPointer<vtkPolyData> PolygonMesh::ToPolyData() const
{
  vtkNew<vtkPoints> vtkpoints;
  vtkpoints->SetDataTypeToDouble();
  vtkpoints->SetNumberOfPoints(static_cast<vtkIdType>(this->points.size()));
  for (std::size_t i = 0; i < this->points.size(); ++i)
  {
    vtkpoints->SetPoint(static_cast<vtkIdType>(i), this->points[i].data());
  }
  vtkNew<vtkTypeInt64Array> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(this->faceEnds.size()) + 1);
  offsets->SetValue(0, 0);
  for (std::size_t i = 0; i < this->faceEnds.size(); ++i)
  {
    offsets->SetValue(static_cast<vtkIdType>(i) + 1, static_cast<vtkTypeInt64>(this->faceEnds[i]));
  }
  vtkNew<vtkTypeInt64Array> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(this->corners.size()));
  std::copy(this->corners.begin(), this->corners.end(), connectivity->GetPointer(0));
  vtkNew<vtkCellArray> faces;
  faces->SetData(offsets, connectivity);

  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(vtkpoints);
  mesh->SetPolys(faces);
  return mesh;
}

} // namespace program
