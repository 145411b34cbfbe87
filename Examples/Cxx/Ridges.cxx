// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Ridges and umbilics of a mesh: Ridges [mesh.vtp]
// Writes ridges.vtp and umbilics.vtp. Without a mesh it takes the example surface of RR-5294,
// Fig. 25.

#include <vtkJetFitting.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRidgeExampleSource.h>
#include <vtkRidgeExtraction.h>
#include <vtkRidgeSharpnessFilter.h>
#include <vtkUmbilicDetection.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdlib>
#include <iostream>

namespace
{

bool Write(vtkAlgorithmOutput* port, const char* fileName)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(port);
  writer->SetFileName(fileName);
  return writer->Write() != 0;
}

} // namespace

int main(int argc, char* argv[])
{
  vtkNew<vtkRidgeExampleSource> example;
  vtkNew<vtkXMLPolyDataReader> reader;
  vtkNew<vtkJetFitting> jets;
  jets->SetInputConnection(example->GetOutputPort());
  if (argc > 1)
  {
    reader->SetFileName(argv[1]);
    jets->SetInputConnection(reader->GetOutputPort());
  }
  vtkNew<vtkUmbilicDetection> umbilics;
  umbilics->SetInputConnection(jets->GetOutputPort());
  vtkNew<vtkRidgeExtraction> ridges;
  ridges->SetInputConnection(umbilics->GetOutputPort());
  vtkNew<vtkRidgeSharpnessFilter> salient;
  salient->SetMinimumSharpness(10.0);
  salient->SetInputConnection(ridges->GetOutputPort());

  if (!Write(salient->GetOutputPort(), "ridges.vtp") ||
    !Write(umbilics->GetOutputPort(1), "umbilics.vtp"))
  {
    std::cerr << "Cannot write ridges.vtp and umbilics.vtp.\n";
    return EXIT_FAILURE;
  }
  std::cout << jets->GetOutput()->GetNumberOfPoints() << " points, "
            << umbilics->GetOutput(1)->GetNumberOfPoints() << " umbilics, "
            << salient->GetOutput()->GetNumberOfLines() << " of "
            << ridges->GetOutput()->GetNumberOfLines() << " polylines are salient\n";
  return salient->GetOutput()->GetNumberOfLines() > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
