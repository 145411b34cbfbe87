// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Images whose samples are values of a function, for the filters that take images.

#ifndef ImageSamples_h
#define ImageSamples_h

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace ridges
{
namespace testing
{

/// Sets the scalars of an image to function(x, y, z), in the extent that it has.
template <typename Function>
void Sample(vtkImageData* image, const Function& function)
{
  vtkNew<vtkDoubleArray> scalars;
  const int* extent = image->GetExtent();
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        double x[3];
        image->TransformIndexToPhysicalPoint(i, j, k, x);
        scalars->InsertNextValue(function(x[0], x[1], x[2]));
      }
    }
  }
  image->GetPointData()->SetScalars(scalars);
}

/// x^2/1.96 + y^2 + z^2/0.36 in a frame turned about z.
inline double TurnedEllipsoid(double x, double y, double z)
{
  const double u = 0.8 * x + 0.6 * y;
  const double v = -0.6 * x + 0.8 * y;
  return u * u / 1.96 + v * v + z * z / 0.36;
}

/// Axes as those of the ellipsoid, turned against the coordinates; (i, j, k) becomes the origin of
/// space.
inline void SetOblique(vtkImageData* image, int i, int j, int k)
{
  image->SetDirectionMatrix(0.6, 0.8, 0.0, -0.8, 0.6, 0.0, 0.0, 0.0, 1.0);
  double center[3];
  image->TransformIndexToPhysicalPoint(i, j, k, center);
  image->SetOrigin(-center[0], -center[1], -center[2]);
}

} // namespace testing
} // namespace ridges

#endif
