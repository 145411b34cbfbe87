// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesEvenMesh.h"

#include "Core/Formula/EvenTriangles.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesCompatibility.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace
{

/// The share of the progress at which the contour is made.
constexpr double Contoured = 0.3;

/// Points at which the surface has no Monge form, or bends within an edge.
struct SharpPoints
{
  ridges::Id count = 0;
  ridges::Id first = 0;
};

bool FindSharpPoints(const ridges::EditableMesh& mesh, const ridges::ExactSurface& surface,
  double edgeLength, const ridges::StoppableLoop& loop, SharpPoints& sharp)
{
  std::vector<std::uint8_t> isSharp(mesh.points.size(), 0);
  const auto look = [&mesh, &surface, &isSharp, edgeLength](ridges::Id begin, ridges::Id end)
  {
    for (ridges::Id first = begin; first < end; first += ridges::Lanes::Count)
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
        isSharp[first + lane] = isGood ? 0 : 1;
      }
    }
  };
  if (!loop(static_cast<ridges::Id>(mesh.points.size()), look))
  {
    return false;
  }
  sharp.count = static_cast<ridges::Id>(std::count(isSharp.begin(), isSharp.end(), 1));
  sharp.first =
    static_cast<ridges::Id>(std::find(isSharp.begin(), isSharp.end(), 1) - isSharp.begin());
  return true;
}

} // namespace

bool vtkRidgesEvenMesh::Make(vtkAlgorithm* filter, const ridges::JetFunction& function,
  const ridges::ExactSurface& rough, const ridges::ExactSurface& surface, const double bounds[6],
  double edgeLength)
{
  this->EdgeLength = edgeLength;
  if (!this->contour.Make(filter, function, bounds, edgeLength, Contoured))
  {
    return false;
  }
  ridges::EditableMesh& mesh = this->contour.mesh;
  int loops = 0;
  const auto progressAt = [](int done)
  { return Contoured + (1.0 - Contoured) * done / (ridges::MakeEvenLoops + 1); };
  const auto loop = [filter, &loops, &progressAt](
                      ridges::Id count, const std::function<void(ridges::Id, ridges::Id)>& body)
  {
    const auto run = [&body](vtkIdType begin, vtkIdType end)
    { body(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end)); };
    const double from = progressAt(loops);
    constexpr vtkIdType batch = 1 << 13; // a point of an image takes 50 us
    return vtkRidgesForBatches(filter, count, from, progressAt(++loops), run, batch);
  };
  // Between two loops there are few passes, or many: progress stands still.
  const ridges::Monitor monitor = [filter, &loops, &progressAt](double)
  {
    filter->UpdateProgress(progressAt(loops));
    return !vtkRidgesCompatibility::IsAborted(filter);
  };
  if (!ridges::MakeEven(mesh, rough, surface, edgeLength, loop, monitor))
  {
    return false;
  }
  SharpPoints sharp;
  if (!FindSharpPoints(mesh, surface, edgeLength, loop, sharp))
  {
    return false;
  }
  this->NumberOfSharpPoints = sharp.count;
  this->FirstSharpPoint = sharp.first;
  this->NumberOfBorderEdges = ridges::CountBorderEdges(mesh);
  return true;
}

void vtkRidgesEvenMesh::Store(vtkPolyData* output) const
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(this->contour.mesh.points.size()));
  double* to = coordinates->GetPointer(0);
  for (const Eigen::Vector3d& point : this->contour.mesh.points)
  {
    to = std::copy_n(point.data(), 3, to);
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(
    this->contour.mesh.triangles.size(), 3 * this->contour.mesh.triangles.size());
  for (const ridges::Triangle& corners : this->contour.mesh.triangles)
  {
    triangles->InsertNextCell({ corners[0], corners[1], corners[2] });
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
}

void vtkRidgesEvenMesh::Warn(vtkAlgorithm* filter, const char* whatCuts) const
{
  if (this->NumberOfSharpPoints > 0)
  {
    vtkWarningWithObjectMacro(filter,
      "The surface bends within an edge at "
        << this->NumberOfSharpPoints << " of " << this->contour.mesh.points.size()
        << " points (the first is at "
        << this->contour.mesh.points[this->FirstSharpPoint].transpose()
        << "): a shorter EdgeLength than " << this->EdgeLength
        << " helps, unless it is singular there.");
  }
  if (this->NumberOfBorderEdges > 0)
  {
    vtkWarningWithObjectMacro(filter, << whatCuts << " the surface: the mesh has "
                                      << this->NumberOfBorderEdges << " border edges.");
  }
}
