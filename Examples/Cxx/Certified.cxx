// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The ridges of an ellipsoid, with a proof that they are all: writes certified.vtp.
#include <vtkCertifiedRidges.h>
#include <vtkImplicitSurfaceMesh.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkVariant.h>
#include <vtkXMLPolyDataWriter.h>

#include <iostream>

int main()
{
  vtkNew<vtkImplicitSurfaceMesh> mesh;
  mesh->SetFormula("x^2 + y^2/0.64 + z^2/0.36 - 1");
  mesh->SetBounds(-1.1, 1.1, -0.9, 0.9, -0.7, 0.7);
  mesh->SetEdgeLength(0.1);
  vtkNew<vtkCertifiedRidges> ridges; // takes the formula from the mesh
  ridges->SetInputConnection(mesh->GetOutputPort());
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName("certified.vtp");
  writer->SetInputConnection(ridges->GetOutputPort());
  const bool written = writer->Write() == 1;
  auto* table = vtkTable::SafeDownCast(ridges->GetOutputDataObject(vtkCertifiedRidges::TABLE));
  bool isProved = true;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    std::cout << table->GetValueByName(row, "Check").ToString() << ": "
              << table->GetValueByName(row, "Verdict").ToString() << "\n";
    isProved = isProved && table->GetValueByName(row, "Passed").ToInt() == 1;
  }
  std::cout << ridges->GetOutput()->GetNumberOfLines() << " lines\n";
  return written && isProved ? 0 : 1;
}
