// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImageMongeForm.h"

#include "Core/Fit/FieldErrors.h"
#include "Core/Fit/JetFit.h"
#include "Core/Formula/ImageFunction.h"
#include "Core/Formula/ImageNoise.h"
#include "Core/Formula/SmoothedImage.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesExactForms.h"
#include "vtkRidgesFieldData.h"
#include "vtkRidgesImage.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesRangeLoop.h"
#include "vtkRidgesRequest.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <string>

namespace names = vtkRidgesArrayNames;

vtkStandardNewMacro(vtkImageMongeForm);

vtkImageMongeForm::vtkImageMongeForm()
{
  this->SetNumberOfInputPorts(2);
}

int vtkImageMongeForm::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

int vtkImageMongeForm::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkRidgesImage::RequestWhole(inputVector[1]->GetInformationObject(0));
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

int vtkImageMongeForm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  if (!input ||
    !vtkRidgesAreNumbers(this, { { "Sigma", this->Sigma }, { "IsoValue", this->IsoValue } }))
  {
    return 0;
  }
  vtkRidgesImage image;
  const std::string fault = image.Set(vtkImageData::GetData(inputVector[1]));
  if (!fault.empty())
  {
    vtkErrorMacro("Input 1 cannot be used: " << fault << ".");
    return 0;
  }
  vtkRidgesMesh mesh;
  const std::string faults = mesh.Build(input);
  if (!faults.empty())
  {
    vtkErrorMacro("The mesh cannot be used: " << faults << ".");
    return 0;
  }
  const ridges::ImageGrid& grid = image.GetGrid();
  const auto loop = vtkRidgesAbortableLoop(this, 0.0, 0.1);
  const double sigma = image.SigmaOf(this->Sigma, this->IsoValue, input, loop);
  const ridges::SmoothedImage smoothed(grid, sigma, loop);
  if (vtkRidgesCompatibility::IsAborted(this))
  {
    return 1;
  }
  const ridges::ImageFunction function(smoothed.Grid(), sigma, this->IsoValue);
  const ridges::ImplicitExactSurface surface(function);
  vtkRidgesExactForms forms(surface);
  forms.statusAt = [&function](const Eigen::Vector3d& x)
  { return function.IsAtBorder(x) ? ridges::FitBoundary : 0; };
  double noise = 0.0;
  forms.located = [&noise, &grid](ridges::Span<double> places)
  { noise = ridges::EstimateImageNoise(grid, places); };
  const double share = ridges::SmoothedNoise(grid, sigma);
  forms.errorsOf = [&noise, share, sigma](const ridges::MongeForm& form, double steepness)
  { return ridges::ErrorsOfDisplacement(form, noise * share / steepness, sigma); };
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!forms.Run(this, mesh, output))
  {
    return 0;
  }
  if (output->GetPoints())
  {
    vtkFieldData* field = vtkRidgesOwnFieldData(output);
    vtkRidgesAddFieldValue<vtkDoubleArray>(field, names::ImageNoise, noise);
    vtkRidgesAddFieldValue<vtkDoubleArray>(field, names::ImageSigma, sigma);
  }
  return 1;
}

void vtkImageMongeForm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "IsoValue: " << this->IsoValue << "\n";
}
