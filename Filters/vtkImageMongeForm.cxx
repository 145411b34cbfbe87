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
#include "vtkRidgesMakeArray.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesRangeLoop.h"
#include "vtkRidgesRequest.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace names = vtkRidgesArrayNames;

vtkStandardNewMacro(vtkImageMongeForm);

vtkImageMongeForm::vtkImageMongeForm()
{
  this->SetNumberOfInputPorts(2);
}

namespace
{

/// Geometry of the samples; their values are set apart.
ridges::ImageGrid GridOf(vtkImageData* image)
{
  ridges::ImageGrid grid;
  const int* extent = image->GetExtent();
  double first[3];
  // Of the first sample of the extent, which need not be 0, 0, 0.
  image->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], first);
  grid.origin = Eigen::Map<const Eigen::Vector3d>(first);
  for (int i = 0; i < 3; ++i)
  {
    grid.size[i] = extent[2 * i + 1] - extent[2 * i] + 1;
    grid.spacing[i] = image->GetSpacing()[i];
    for (int j = 0; j < 3; ++j)
    {
      grid.axes(i, j) = image->GetDirectionMatrix()->GetElement(i, j);
    }
  }
  return grid;
}

/// What is wrong with an image; empty if nothing is.
std::string FaultOf(vtkImageData* image, const ridges::ImageGrid& grid)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    return "the image has no scalars at its points";
  }
  if (!(grid.spacing.minCoeff() > 0.0) || !grid.spacing.allFinite())
  {
    return "the spacing of the image is not positive";
  }
  constexpr double roundOff = 1e-6;
  if (!((grid.axes.transpose() * grid.axes).isIdentity(roundOff)))
  {
    return "the direction matrix of the image is not orthonormal";
  }
  constexpr int least = 5;
  if (*std::min_element(grid.size.begin(), grid.size.end()) < least)
  {
    return "the image has fewer than five samples along an axis";
  }
  return {};
}

std::vector<double> ValuesOf(vtkDataArray* scalars)
{
  std::vector<double> values(static_cast<std::size_t>(scalars->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = scalars->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return values;
}

} // namespace

int vtkImageMongeForm::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

int vtkImageMongeForm::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // All of the image, whatever a filter behind may need of it.
  vtkInformation* image = inputVector[1]->GetInformationObject(0);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (image && image->Has(Pipeline::WHOLE_EXTENT()))
  {
    int extent[6];
    image->Get(Pipeline::WHOLE_EXTENT(), extent);
    image->Set(Pipeline::UPDATE_EXTENT(), extent, 6);
  }
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

int vtkImageMongeForm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  vtkImageData* image = vtkImageData::GetData(inputVector[1]);
  if (!input ||
    !vtkRidgesAreNumbers(this, { { "Sigma", this->Sigma }, { "IsoValue", this->IsoValue } }))
  {
    return 0;
  }
  ridges::ImageGrid grid = image ? GridOf(image) : ridges::ImageGrid();
  const std::string fault = image ? FaultOf(image, grid) : "there is no image";
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
  const std::vector<double> values = ValuesOf(image->GetPointData()->GetScalars());
  grid.values = values.data();
  constexpr double samples = 1.5;
  const double sigma = this->Sigma > 0.0 ? this->Sigma : samples * grid.spacing.maxCoeff();
  const ridges::SmoothedImage smoothed(grid, sigma, vtkRidgesAbortableLoop(this, 0.0, 0.1));
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
  forms.errorsAt = [&function, &noise, share, sigma](
                     const Eigen::Vector3d& x, const ridges::MongeForm& form)
  { return ridges::ErrorsOfDisplacement(form, noise * share / function.SteepnessAt(x), sigma); };
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!forms.Run(this, mesh, output))
  {
    return 0;
  }
  if (output->GetPoints())
  {
    auto array = vtkRidgesMakeArray<vtkDoubleArray>(names::ImageNoise);
    array->InsertNextValue(noise);
    vtkRidgesOwnFieldData(output)->AddArray(array);
  }
  return 1;
}

void vtkImageMongeForm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "IsoValue: " << this->IsoValue << "\n";
}
