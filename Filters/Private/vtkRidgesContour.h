// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesContour_h
#define vtkRidgesContour_h

#include "Core/Formula/EdgeOperations.h"
#include "Core/Formula/JetFunction.h"
#include "vtkRidgesCompatibility.h"

#include <array>
#include <string>

/**
 * A first mesh of a surface f = 0 in a box, by VTK's contouring of f on a grid. Private to the
 * module.
 */
class vtkRidgesContour
{
public:
  /// False if the user aborted, or if something is wrong: then there is an error, or a NaN.
  bool Make(vtkAlgorithm* filter, const ridges::JetFunction& function, const double bounds[6],
    double edgeLength, double progress);

  double from = 0.0;              ///< Progress of the filter before.
  const char* box = "the Bounds"; ///< In errors: where f is known,
  const char* what = "f is";      ///< and what it is.
  ridges::EditableMesh mesh;
  std::string error;
  std::array<double, 3> firstNaN{}; ///< Where f is not a number.
  bool hasNaN = false;
};

#endif
