// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesImage_h
#define vtkRidgesImage_h

#include "Core/Base/Types.h"
#include "Core/Formula/ImageFunction.h"
#include "vtkRidgesCompatibility.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkInformation;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * The samples of an image that a filter was given. Private to the module.
 */
class vtkRidgesImage
{
public:
  /// What is wrong with the image; empty if nothing is.
  std::string Set(vtkImageData* image);

  const ridges::ImageGrid& GetGrid() const { return this->Grid; }

  /// The standard deviation of the smoothing that is meant: 0 is that of the mesh, if it says one,
  /// else what the noise of the image needs around a value, at least 1.5 times the greatest
  /// spacing.
  double SigmaOf(
    double property, double isoValue, vtkPolyData* mesh, const ridges::RangeLoop& loop) const;

  /// Asks for all of an image, whatever a filter behind may need of it.
  static void RequestWhole(vtkInformation* image);

private:
  ridges::ImageGrid Grid;
  std::vector<double> Values;
};

#endif
