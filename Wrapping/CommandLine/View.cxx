// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "View.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace program
{
namespace
{

Vector3 Axis(int i)
{
  Vector3 axis{};
  axis[i] = 1.0;
  return axis;
}

double Dot(const Vector3& a, const Vector3& b)
{
  return vtkMath::Dot(a.data(), b.data());
}

Vector3 UnitCross(const Vector3& a, const Vector3& b)
{
  Vector3 cross{};
  vtkMath::Cross(a.data(), b.data(), cross.data());
  vtkMath::Normalize(cross.data());
  return cross;
}

Vector3 Unit(Vector3 a)
{
  // Scaled first, so that the length neither overflows nor vanishes.
  const double greatest = std::max({ std::abs(a[0]), std::abs(a[1]), std::abs(a[2]) });
  for (double& x : a)
  {
    x /= greatest;
  }
  vtkMath::Normalize(a.data());
  return a;
}

bool AreParallel(const Vector3& a, const Vector3& b)
{
  return std::abs(Dot(a, b)) > 0.999;
}

/// From the front, 25 degrees from the side and 15 from above.
Vector3 DefaultViewDirection(const Vector3& extent, const Vector3& up)
{
  int front = -1;
  for (int i = 0; i < 3; ++i)
  {
    const bool isAside = std::abs(up[i]) < 0.8;
    if (isAside && (front < 0 || extent[i] < extent[front]))
    {
      front = i;
    }
  }
  const double azimuth = vtkMath::RadiansFromDegrees(25.0);
  const double elevation = vtkMath::RadiansFromDegrees(15.0);
  const Vector3 right = UnitCross(up, Axis(front));
  const Vector3 towards = UnitCross(right, up);
  Vector3 direction{};
  for (int i = 0; i < 3; ++i)
  {
    direction[i] =
      std::cos(elevation) * (std::cos(azimuth) * towards[i] + std::sin(azimuth) * right[i]) +
      std::sin(elevation) * up[i];
  }
  return direction;
}

} // namespace

std::array<double, 2> View::Project(const Vector3& point) const
{
  const Vector3 offset{ point[0] - this->center[0], point[1] - this->center[1],
    point[2] - this->center[2] };
  return { Dot(offset, this->right) / this->scale, Dot(offset, this->up) / this->scale };
}

View FindView(const std::vector<Vector3>& points, const std::optional<Vector3>& viewDirection,
  const std::optional<Vector3>& upDirection, double aspect, double margin)
{
  vtkBoundingBox box;
  for (const Vector3& point : points)
  {
    box.AddPoint(point[0], point[1], point[2]);
  }
  Vector3 extent{};
  Vector3 middle{};
  if (box.IsValid())
  {
    box.GetLengths(extent.data());
    box.GetCenter(middle.data());
  }

  View view;
  Vector3 up = upDirection ? Unit(*upDirection) : Axis(extent[2] > extent[1] ? 2 : 1);
  view.back = viewDirection ? Unit(*viewDirection) : DefaultViewDirection(extent, up);
  if (AreParallel(up, view.back))
  {
    // Any other axis will do: at least one is not along the view.
    up = AreParallel(Axis(1), view.back) ? Axis(2) : Axis(1);
  }
  view.right = UnitCross(up, view.back);
  view.up = UnitCross(view.back, view.right);

  // The box of the points in the coordinates of the picture.
  const std::array<const Vector3*, 3> axes{ &view.right, &view.up, &view.back };
  vtkBoundingBox seen;
  for (const Vector3& point : points)
  {
    const Vector3 offset{ point[0] - middle[0], point[1] - middle[1], point[2] - middle[2] };
    seen.AddPoint(Dot(offset, view.right), Dot(offset, view.up), Dot(offset, view.back));
  }
  view.center = middle;
  if (!seen.IsValid() || seen.GetMaxLength() <= 0.0)
  {
    return view;
  }
  Vector3 seenCenter{};
  Vector3 seenExtent{};
  seen.GetCenter(seenCenter.data());
  seen.GetLengths(seenExtent.data());
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      view.center[i] += seenCenter[j] * (*axes[j])[i];
    }
  }
  view.scale = 0.5 * std::max(seenExtent[1], seenExtent[0] / aspect) / (1.0 - 2.0 * margin);
  view.depth = 0.5 * std::max(seenExtent[2], view.scale);
  return view;
}

std::vector<Vector3> PointsOfSurface(vtkPolyData* mesh)
{
  std::vector<bool> isUsed(mesh->GetNumberOfPoints(), false);
  for (vtkCellArray* cells : { mesh->GetPolys(), mesh->GetStrips() })
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    for (cells->InitTraversal(); cells->GetNextCell(size, ids);)
    {
      for (vtkIdType i = 0; i < size; ++i)
      {
        isUsed[ids[i]] = true;
      }
    }
  }
  std::vector<Vector3> points;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Vector3 point{};
    mesh->GetPoint(i, point.data());
    if (isUsed[i] &&
      std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); }))
    {
      points.push_back(point);
    }
  }
  return points;
}

} // namespace program
