// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesContour.h"

#include "vtkRidgesBatches.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDoubleArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace
{

/// More samples than memory would hold.
constexpr double MostSamples = 1e9;

/// The grid, and f on it.
struct Samples
{
  std::array<int, 3> dimensions{};
  std::array<double, 3> origin{};
  std::array<double, 3> spacing{};
  std::vector<double> values;

  vtkIdType Stride(int axis) const
  {
    return axis == 0
      ? 1
      : static_cast<vtkIdType>(this->dimensions[0]) * (axis == 1 ? 1 : this->dimensions[1]);
  }

  std::array<int, 3> IndexOf(vtkIdType sample) const
  {
    const vtkIdType row = sample / this->dimensions[0];
    return { static_cast<int>(sample % this->dimensions[0]),
      static_cast<int>(row % this->dimensions[1]), static_cast<int>(row / this->dimensions[1]) };
  }

  std::array<double, 3> PointOf(vtkIdType sample) const
  {
    const std::array<int, 3> index = this->IndexOf(sample);
    std::array<double, 3> point{};
    for (int i = 0; i < 3; ++i)
    {
      point[i] = this->origin[i] + index[i] * this->spacing[i];
    }
    return point;
  }

  /// f, but not so close to 0 that triangles around a point of the grid would have no area: at
  /// least a fiftieth of the greatest difference to a neighbour. Points of the contour are moved
  /// to the surface later.
  double AwayFromZero(vtkIdType sample) const
  {
    constexpr double least = 0.02;
    const double value = this->values[sample];
    const std::array<int, 3> index = this->IndexOf(sample);
    double difference = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType stride = this->Stride(i);
      if (index[i] > 0)
      {
        difference = std::max(difference, std::abs(value - this->values[sample - stride]));
      }
      if (index[i] + 1 < this->dimensions[i])
      {
        difference = std::max(difference, std::abs(value - this->values[sample + stride]));
      }
    }
    return std::copysign(std::max(std::abs(value), least * difference), value);
  }
};

bool Evaluate(vtkAlgorithm* filter, const ridges::JetFunction& function, Samples& samples,
  double from, double to)
{
  constexpr double greatest = 0.1 * std::numeric_limits<double>::max();
  const auto evaluate = [&function, &samples](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType first = begin; first < end; first += ridges::Lanes::Count)
    {
      const int count = static_cast<int>(std::min<vtkIdType>(end - first, ridges::Lanes::Count));
      ridges::LaneVector3 x;
      for (int lane = 0; lane < ridges::Lanes::Count; ++lane)
      {
        const std::array<double, 3> point = samples.PointOf(first + std::min(lane, count - 1));
        for (int i = 0; i < 3; ++i)
        {
          x[i][lane] = point[i];
        }
      }
      const ridges::Lanes f = function.Linear(x).Constant();
      for (int lane = 0; lane < count; ++lane)
      {
        // Infinities are as good as large values; NaN stays.
        const double value = f[lane];
        samples.values[first + lane] = std::isinf(value) ? std::copysign(greatest, value) : value;
      }
    }
  };
  return vtkRidgesForBatches(
    filter, static_cast<vtkIdType>(samples.values.size()), from, to, evaluate);
}

ridges::EditableMesh MeshOf(vtkPolyData* contour)
{
  ridges::EditableMesh mesh;
  mesh.points.resize(static_cast<std::size_t>(contour->GetNumberOfPoints()));
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    contour->GetPoint(static_cast<vtkIdType>(p), mesh.points[p].data());
  }
  const auto cells = vtk::TakeSmartPointer(contour->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCurrentCell(size, corners);
    mesh.triangles.push_back({ static_cast<ridges::Id>(corners[0]),
      static_cast<ridges::Id>(corners[1]), static_cast<ridges::Id>(corners[2]) });
  }
  return mesh;
}

/// Turns the triangles so that f grows outward.
void Orient(ridges::EditableMesh& mesh, const ridges::JetFunction& function)
{
  double sides = 0.0;
  for (const ridges::Triangle& corners : mesh.triangles)
  {
    const Eigen::Vector3d& a = mesh.points[corners[0]];
    const Eigen::Vector3d normal = (mesh.points[corners[1]] - a).cross(mesh.points[corners[2]] - a);
    ridges::LaneVector3 x;
    for (int i = 0; i < 3; ++i)
    {
      x[i] = ridges::Lanes(a[i]);
    }
    const auto f = function.Linear(x);
    const Eigen::Vector3d gradient(
      f.Coefficients()[1][0], f.Coefficients()[2][0], f.Coefficients()[3][0]);
    const double side = normal.dot(gradient);
    sides += side > 0.0 ? 1.0 : side < 0.0 ? -1.0 : 0.0;
  }
  if (sides < 0.0)
  {
    for (ridges::Triangle& corners : mesh.triangles)
    {
      std::swap(corners[1], corners[2]);
    }
  }
}

} // namespace

bool vtkRidgesContour::Make(vtkAlgorithm* filter, const ridges::JetFunction& function,
  const double bounds[6], double edgeLength, double progress)
{
  Samples samples;
  double count = 1.0;
  for (int i = 0; i < 3; ++i)
  {
    const double extent = bounds[2 * i + 1] - bounds[2 * i];
    const double cells = std::max(1.0, std::ceil(extent / edgeLength));
    count *= cells + 1.0;
    samples.origin[i] = bounds[2 * i];
    samples.spacing[i] = extent / cells;
    samples.dimensions[i] = count <= MostSamples ? static_cast<int>(cells) + 1 : 0;
  }
  std::ostringstream text;
  if (!(count <= MostSamples))
  {
    text << "EdgeLength " << edgeLength << " is too short for " << this->box
         << ": the grid would have " << count << " points";
    this->error = text.str();
    return false;
  }
  samples.values.resize(static_cast<std::size_t>(count));
  const auto progressAt = [this, progress](double share)
  { return this->from + share * (progress - this->from); };
  if (!Evaluate(filter, function, samples, this->from, progressAt(0.8)))
  {
    return false;
  }
  const auto nan = std::find_if(
    samples.values.begin(), samples.values.end(), [](double value) { return std::isnan(value); });
  if (nan != samples.values.end())
  {
    this->hasNaN = true;
    this->firstNaN = samples.PointOf(nan - samples.values.begin());
    return false;
  }
  const auto [least, greatest] = std::minmax_element(samples.values.begin(), samples.values.end());
  if (*least >= 0.0 || *greatest < 0.0)
  {
    text << "The surface is empty: within " << this->box << " " << this->what << " from " << *least
         << " to " << *greatest;
    this->error = text.str();
    return false;
  }

  vtkNew<vtkDoubleArray> scalars;
  scalars->SetNumberOfTuples(static_cast<vtkIdType>(samples.values.size()));
  const auto copy = [&samples, &scalars](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType sample = begin; sample < end; ++sample)
    {
      scalars->SetValue(sample, samples.AwayFromZero(sample));
    }
  };
  if (!vtkRidgesForBatches(
        filter, scalars->GetNumberOfTuples(), progressAt(0.8), progressAt(0.9), copy))
  {
    return false;
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(samples.dimensions.data());
  image->SetOrigin(samples.origin.data());
  image->SetSpacing(samples.spacing.data());
  image->GetPointData()->SetScalars(scalars);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  this->mesh = MeshOf(contour->GetOutput());
  Orient(this->mesh, function);
  return true;
}
