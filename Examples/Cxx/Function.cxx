// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Exact ridges of a surface given by a function in C++, which may compute its derivatives as it
// likes: writes function.vtp. Here it is x^4 + y^4 + z^4 + x y / 10 = 1.
#include <vtkImplicitMongeForm.h>
#include <vtkImplicitSurfaceMesh.h>
#include <vtkJetFunction.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkRidgeExtraction.h>
#include <vtkUmbilicDetection.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cmath>
#include <iostream>

class Quartic : public vtkJetFunction
{
public:
  static Quartic* New();
  vtkTypeMacro(Quartic, vtkJetFunction);

  // Each coefficient is a derivative divided by factorials: those of x^4 are binomials.
  void EvaluateJet(const double x[3], int order, double* coefficients) override
  {
    std::fill_n(coefficients, NumberOfCoefficients(order), 0.0);
    const double binomials[] = { 1.0, 4.0, 6.0, 4.0, 1.0 };
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int k = 0; k <= order; ++k)
      {
        const int index = Index(axis == 0 ? k : 0, axis == 1 ? k : 0, axis == 2 ? k : 0);
        coefficients[index] += binomials[k] * std::pow(x[axis], 4 - k);
      }
    }
    coefficients[0] += 0.1 * x[0] * x[1] - 1.0;
    coefficients[Index(1, 0, 0)] += 0.1 * x[1];
    coefficients[Index(0, 1, 0)] += 0.1 * x[0];
    if (order > 1)
    {
      coefficients[Index(1, 1, 0)] += 0.1;
    }
  }
};
vtkStandardNewMacro(Quartic);

int main()
{
  vtkNew<vtkImplicitSurfaceMesh> mesh; // Any mesh near the surface will do.
  mesh->SetFormula("x^4 + y^4 + z^4 + 0.1*x*y - 1");
  mesh->SetBounds(-1.3, 1.3, -1.3, 1.3, -1.3, 1.3);
  mesh->SetEdgeLength(0.04);
  vtkNew<Quartic> function;
  vtkNew<vtkImplicitMongeForm> exact;
  exact->SetJetFunction(function);
  exact->SetInputConnection(mesh->GetOutputPort());
  vtkNew<vtkUmbilicDetection> umbilics;
  umbilics->SetInputConnection(exact->GetOutputPort());
  vtkNew<vtkRidgeExtraction> ridges;
  ridges->SetInputConnection(umbilics->GetOutputPort());
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName("function.vtp");
  writer->SetInputConnection(ridges->GetOutputPort());
  if (writer->Write() != 1)
  {
    return 1;
  }
  std::cout << umbilics->GetOutput(1)->GetNumberOfPoints() << " umbilics\n"
            << ridges->GetOutput()->GetNumberOfLines() << " lines\n";
  return ridges->GetOutput()->GetNumberOfLines() > 0 ? 0 : 1;
}
