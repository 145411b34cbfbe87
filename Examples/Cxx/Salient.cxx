// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The feature lines of a mesh, as a scan would have them: writes lines.vtp.
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRidgeExampleSource.h>
#include <vtkSalientRidges.h>
#include <vtkXMLPolyDataWriter.h>

#include <iostream>

int main()
{
  vtkNew<vtkRidgeExampleSource> mesh;
  vtkNew<vtkSalientRidges> lines;
  lines->SetInputConnection(mesh->GetOutputPort());
  lines->SetFoldAngle(15.0);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName("lines.vtp");
  writer->SetInputConnection(lines->GetOutputPort());
  const bool written = writer->Write() == 1;
  std::cout << lines->GetOutput()->GetNumberOfLines() << " lines\n";
  return written ? 0 : 1;
}
