// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImageSurfaceMesh.h"

#include "Core/Formula/ExactSurface.h"
#include "Core/Formula/InterpolatedImage.h"
#include "Core/Formula/SmoothedImage.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesEvenMesh.h"
#include "vtkRidgesFieldData.h"
#include "vtkRidgesImage.h"
#include "vtkRidgesRangeLoop.h"
#include "vtkRidgesRequest.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkImageSurfaceMesh);

namespace
{

/// Turns the triangles so that they enclose a positive volume with the center of the points.
void FaceOutward(ridges::EditableMesh& mesh)
{
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : mesh.points)
  {
    center += point / static_cast<double>(mesh.points.size());
  }
  double volume = 0.0;
  for (const ridges::Triangle& corners : mesh.triangles)
  {
    const auto at = [&mesh, &center, &corners](int i) -> Eigen::Vector3d
    { return mesh.points[corners[i]] - center; };
    volume += at(0).cross(at(1)).dot(at(2));
  }
  for (ridges::Triangle& corners : mesh.triangles)
  {
    if (volume < 0.0)
    {
      std::swap(corners[1], corners[2]);
    }
  }
}

} // namespace

int vtkImageSurfaceMesh::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkImageSurfaceMesh::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkRidgesImage::RequestWhole(inputVector[0]->GetInformationObject(0));
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

// In the axes of the image, where it fills a box.
int vtkImageSurfaceMesh::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!vtkRidgesAreNumbers(this,
        { { "Sigma", this->Sigma }, { "IsoValue", this->IsoValue },
          { "EdgeLength", this->EdgeLength } }))
  {
    return 0;
  }
  vtkRidgesImage image;
  const std::string fault = image.Set(vtkImageData::GetData(inputVector[0]));
  if (!fault.empty())
  {
    vtkErrorMacro("The input cannot be used: " << fault << ".");
    return 0;
  }
  ridges::ImageGrid grid = image.GetGrid();
  const Eigen::Matrix3d axes = grid.axes;
  const Eigen::Vector3d origin = grid.origin;
  grid.axes.setIdentity();
  grid.origin.setZero();
  constexpr double share = 0.75;
  constexpr double marginByDeviation = 1.5;
  constexpr double smoothedAt = 0.1;
  const auto loop = vtkRidgesAbortableLoop(this, 0.0, smoothedAt);
  const double sigma = image.SigmaOf(this->Sigma, this->IsoValue, nullptr, loop);
  const double edgeLength = this->EdgeLength > 0.0 ? this->EdgeLength : share * sigma;
  double bounds[6] = {};
  for (int i = 0; i < 3; ++i)
  {
    const double extent = (grid.size[i] - 1) * grid.spacing[i];
    const double margin = std::min(marginByDeviation * sigma, 0.25 * extent);
    bounds[2 * i] = margin;
    bounds[2 * i + 1] = extent - margin;
  }

  const ridges::SmoothedImage smoothed(grid, sigma, loop);
  const ridges::SmoothedImage wholly(smoothed.Grid(), sigma, loop, 0.0);
  if (vtkRidgesCompatibility::IsAborted(this))
  {
    return 1;
  }
  const ridges::ImageFunction function(smoothed.Grid(), sigma, this->IsoValue);
  const ridges::ImplicitExactSurface surface(function);
  const ridges::InterpolatedImage rough(wholly.Grid(), this->IsoValue);
  const ridges::ImplicitExactSurface roughSurface(rough);
  vtkRidgesEvenMesh mesh;
  mesh.contour.from = smoothedAt;
  mesh.contour.box = "the image";
  mesh.contour.what = "the smoothed values, less IsoValue, are";
  if (!mesh.Make(this, rough, roughSurface, surface, bounds, edgeLength))
  {
    if (mesh.contour.hasNaN)
    {
      const std::array<double, 3>& at = mesh.contour.firstNaN;
      const Eigen::Vector3d place = origin + axes * Eigen::Vector3d(at[0], at[1], at[2]);
      vtkErrorMacro("The image has values that are not finite, near " << place.transpose() << ".");
      return 0;
    }
    if (!mesh.contour.error.empty())
    {
      vtkErrorMacro(<< mesh.contour.error << ".");
      return 0;
    }
    return 1; // aborted
  }
  for (Eigen::Vector3d& point : mesh.GetMesh().points)
  {
    point = origin + axes * point;
  }
  FaceOutward(mesh.GetMesh());
  mesh.Warn(this, "The image ends before");
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  mesh.Store(output);
  vtkRidgesAddFieldValue<vtkDoubleArray>(
    vtkRidgesOwnFieldData(output), vtkRidgesArrayNames::ImageSigma, sigma);
  return 1;
}

void vtkImageSurfaceMesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsoValue: " << this->IsoValue << "\n";
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "EdgeLength: " << this->EdgeLength << "\n";
}
