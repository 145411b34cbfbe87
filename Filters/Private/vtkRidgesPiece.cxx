// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesPiece.h"

#include "vtkRidgesMesh.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

vtkRidgesPiece::vtkRidgesPiece(const vtkRidgesMesh& mesh)
{
  const ridges::TriangleMesh& triangles = mesh.GetTriangles();
  this->View.numberOfPoints = triangles.NumberOfPoints();
  this->View.points = this->View.numberOfPoints > 0 ? triangles.Point(0).data() : nullptr;
  this->View.triangles = triangles.Triangles();
  vtkDataArray* ids = mesh.GetPolyData()->GetPointData()->GetGlobalIds();
  if (ids && ids->GetNumberOfTuples() == this->View.numberOfPoints)
  {
    for (ridges::Id p = 0; p < this->View.numberOfPoints; ++p)
    {
      this->GlobalIds.push_back(static_cast<std::int64_t>(ids->GetTuple1(p)));
    }
    this->View.globalIds = this->GlobalIds.data();
  }
}
