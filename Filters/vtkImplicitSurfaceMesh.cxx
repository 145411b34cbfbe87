// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImplicitSurfaceMesh.h"

#include "Core/Formula/EvenTriangles.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesContour.h"
#include "vtkRidgesFormulaSurface.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace names = vtkRidgesArrayNames;

vtkStandardNewMacro(vtkImplicitSurfaceMesh);

vtkImplicitSurfaceMesh::vtkImplicitSurfaceMesh()
  : Formula("1 - exp(-0.7*((x/0.15)^2 + (y/0.25)^2 + (z/0.35)^2 - 1))"
            " - exp(-0.7*(((x-0.25)/0.1)^2 + ((y-0.1)/0.2)^2 + ((z-0.1)/0.3)^2 - 1))")
{
  this->SetNumberOfInputPorts(0);
}

vtkImplicitSurfaceMesh::~vtkImplicitSurfaceMesh() = default;

namespace
{

/// The share of the progress at which the contour is made.
constexpr double Contoured = 0.3;

void Store(const ridges::EditableMesh& mesh, const std::string& formula, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(mesh.points.size()));
  double* to = coordinates->GetPointer(0);
  for (const Eigen::Vector3d& point : mesh.points)
  {
    to = std::copy_n(point.data(), 3, to);
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(mesh.triangles.size(), 3 * mesh.triangles.size());
  for (const ridges::Triangle& corners : mesh.triangles)
  {
    triangles->InsertNextCell({ corners[0], corners[1], corners[2] });
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  vtkNew<vtkStringArray> text;
  text->SetName(names::Formula);
  text->InsertNextValue(formula);
  output->GetFieldData()->AddArray(text);
}

/// Points at which the surface has no Monge form, or bends within an edge.
struct SharpPoints
{
  ridges::Id count = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
};

SharpPoints FindSharpPoints(
  const ridges::EditableMesh& mesh, const ridges::ExactSurface& surface, double edgeLength)
{
  SharpPoints sharp;
  const auto end = static_cast<ridges::Id>(mesh.points.size());
  for (ridges::Id first = 0; first < end; first += ridges::Lanes::Count)
  {
    ridges::SurfacePoints points;
    points.count = std::min(end - first, static_cast<ridges::Id>(ridges::Lanes::Count));
    std::copy_n(mesh.points.begin() + first, points.count, points.position.begin());
    surface.Locate(points);
    surface.Differentiate(points);
    for (int lane = 0; lane < points.count; ++lane)
    {
      const ridges::MongeForm& form = points.form[lane];
      const bool isGood = points.fault[lane] == ridges::ExactFault::None &&
        std::max(std::abs(form.k1), std::abs(form.k2)) * edgeLength <= 1.0;
      if (!isGood && sharp.count++ == 0)
      {
        sharp.first = mesh.points[first + lane];
      }
    }
  }
  return sharp;
}

} // namespace

int vtkImplicitSurfaceMesh::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  double squares = 0.0;
  bool isBox = true;
  for (int i = 0; i < 3; ++i)
  {
    const double extent = this->Bounds[2 * i + 1] - this->Bounds[2 * i];
    isBox = isBox && extent > 0.0;
    squares += extent * extent;
  }
  constexpr double share = 0.01;
  const double edgeLength = this->EdgeLength == 0.0 ? share * std::sqrt(squares) : this->EdgeLength;
  if (!isBox || !std::isfinite(squares) || !std::isfinite(edgeLength))
  {
    vtkErrorMacro("Bounds are " << this->Bounds[0] << ", " << this->Bounds[1] << ", "
                                << this->Bounds[2] << ", " << this->Bounds[3] << ", "
                                << this->Bounds[4] << ", " << this->Bounds[5]
                                << " and EdgeLength is " << this->EdgeLength
                                << ": a box that is not empty and a number are needed.");
    return 0;
  }
  vtkRidgesFormulaSurface surface;
  const std::string fault = surface.SetImplicit(this->Formula);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }

  vtkRidgesContour contour;
  if (!contour.Make(this, surface.GetFunction(), this->Bounds, edgeLength, Contoured))
  {
    if (contour.hasNaN)
    {
      const std::array<double, 3>& at = contour.firstNaN;
      vtkErrorMacro("Formula: f is not a number at " << at[0] << ", " << at[1] << ", " << at[2]
                                                     << ", because of what is at "
                                                     << surface.PlaceOfFault(at.data()) << ".");
      return 0;
    }
    if (!contour.error.empty())
    {
      vtkErrorMacro(<< contour.error << ".");
      return 0;
    }
    return 1; // aborted
  }
  ridges::EditableMesh& mesh = contour.mesh;
  int loops = 0;
  const auto loop = [this, &loops](
                      ridges::Id count, const std::function<void(ridges::Id, ridges::Id)>& body)
  {
    const auto progressAt = [](int done)
    { return Contoured + (1.0 - Contoured) * done / ridges::MakeEvenLoops; };
    const auto run = [&body](vtkIdType begin, vtkIdType end)
    { body(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end)); };
    const double from = progressAt(loops);
    return vtkRidgesForBatches(this, count, from, progressAt(++loops), run);
  };
  if (!ridges::MakeEven(mesh, surface.Get(), edgeLength, loop))
  {
    return 1; // aborted
  }
  const SharpPoints sharp = FindSharpPoints(mesh, surface.Get(), edgeLength);
  const ridges::Id border = ridges::CountBorderEdges(mesh);
  if (sharp.count > 0)
  {
    vtkWarningMacro("The surface bends within an edge at "
      << sharp.count << " of " << mesh.points.size() << " points (the first is at "
      << sharp.first.transpose() << "): a shorter EdgeLength than " << edgeLength
      << " helps, unless it is singular there.");
  }
  if (border > 0)
  {
    vtkWarningMacro("The Bounds cut the surface: the mesh has " << border << " border edges.");
  }
  Store(mesh, this->Formula, vtkPolyData::GetData(outputVector));
  return 1;
}

void vtkImplicitSurfaceMesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Formula: " << this->Formula << "\n";
  os << indent << "Bounds:";
  for (const double bound : this->Bounds)
  {
    os << " " << bound;
  }
  os << "\n" << indent << "EdgeLength: " << this->EdgeLength << "\n";
}
