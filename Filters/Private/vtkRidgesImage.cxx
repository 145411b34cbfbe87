// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesImage.h"

#include "Core/Fit/ImageScale.h"
#include "vtkRidgesArrayNames.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

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

std::string vtkRidgesImage::Set(vtkImageData* image)
{
  if (!image)
  {
    return "there is no image";
  }
  this->Grid = GridOf(image);
  const std::string fault = FaultOf(image, this->Grid);
  if (fault.empty())
  {
    this->Values = ValuesOf(image->GetPointData()->GetScalars());
    this->Grid.values = this->Values.data();
  }
  return fault;
}

double vtkRidgesImage::SigmaOf(
  double property, double isoValue, vtkPolyData* mesh, const ridges::RangeLoop& loop) const
{
  if (property > 0.0)
  {
    return property;
  }
  vtkDataArray* array =
    mesh ? mesh->GetFieldData()->GetArray(vtkRidgesArrayNames::ImageSigma) : nullptr;
  if (array && array->GetNumberOfValues() == 1 && array->GetComponent(0, 0) > 0.0)
  {
    return array->GetComponent(0, 0);
  }
  constexpr double samples = 1.5;
  return ridges::ChooseImageScale(
    this->Grid, isoValue, samples * this->Grid.spacing.maxCoeff(), loop);
}

void vtkRidgesImage::RequestWhole(vtkInformation* image)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (image && image->Has(Pipeline::WHOLE_EXTENT()))
  {
    int extent[6];
    image->Get(Pipeline::WHOLE_EXTENT(), extent);
    image->Set(Pipeline::UPDATE_EXTENT(), extent, 6);
  }
}
