// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgeExampleSource.h"

#include "Core/Formula/ExampleSurface.h"
#include "vtkRidgesBatches.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <functional>

vtkStandardNewMacro(vtkRidgeExampleSource);

vtkRidgeExampleSource::vtkRidgeExampleSource()
{
  this->SetNumberOfInputPorts(0);
}

int vtkRidgeExampleSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const bool positive = std::all_of(std::begin(this->SemiAxes), std::end(this->SemiAxes),
    [](double axis) { return axis > 0.0 && std::isfinite(axis); });
  if (this->Surface == ELLIPSOID && !positive)
  {
    vtkErrorMacro("SemiAxes are " << this->SemiAxes[0] << ", " << this->SemiAxes[1] << ", "
                                  << this->SemiAxes[2] << ": all three have to be positive.");
    return 0;
  }
  int loops = 0;
  const auto loop = [this, &loops](
                      ridges::Id count, const std::function<void(ridges::Id, ridges::Id)>& body)
  {
    const auto share = [](int done)
    { return static_cast<double>(done) / ridges::MeshSurfaceLoops; };
    const auto run = [&body](vtkIdType begin, vtkIdType end)
    { body(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end)); };
    const double from = share(loops);
    return vtkRidgesForBatches(this, count, from, share(++loops), run);
  };
  const ridges::PointsAndTriangles mesh = this->Surface == ELLIPSOID
    ? ridges::MeshEllipsoid(Eigen::Map<const Eigen::Vector3d>(this->SemiAxes), this->Frequency)
    : ridges::MeshSurface(ridges::BlendSurface(), this->Frequency, loop);
  if (mesh.points.cols() == 0)
  {
    return 1; // aborted
  }

  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(mesh.points.cols());
  std::copy_n(mesh.points.data(), mesh.points.size(), coordinates->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(mesh.triangles.size(), 3 * mesh.triangles.size());
  for (const ridges::Triangle& corners : mesh.triangles)
  {
    triangles->InsertNextCell({ corners[0], corners[1], corners[2] });
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->SetPoints(points);
  output->SetPolys(triangles);
  return 1;
}

void vtkRidgeExampleSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << (this->Surface == ELLIPSOID ? "Ellipsoid" : "Blend") << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "SemiAxes: " << this->SemiAxes[0] << " " << this->SemiAxes[1] << " "
     << this->SemiAxes[2] << "\n";
}
