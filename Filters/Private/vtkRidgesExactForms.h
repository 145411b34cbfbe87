// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesExactForms_h
#define vtkRidgesExactForms_h

#include "Core/Base/Types.h"
#include "Core/Fit/JetErrors.h"
#include "Core/Formula/ExactSurface.h"
#include "vtkRidgesCompatibility.h"

#include "vtkType.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END
class vtkRidgesMesh;

/**
 * Moves the points of a mesh to a surface and gives them its exact Monge forms: what the filters
 * have in common that know their surface. Private to the module.
 */
class vtkRidgesExactForms
{
public:
  explicit vtkRidgesExactForms(const ridges::ExactSurface& surface)
    : Surface(surface)
  {
  }

  /// Of each point, if the surface is parametric.
  std::vector<std::array<double, 2>> parameters;

  /// Bits of FitStatus at a place, besides that there is no form. May be empty.
  std::function<int(const Eigen::Vector3d&)> statusAt;

  /// Standard errors of a form, where f = 0 is so steep; not known if it is empty.
  std::function<ridges::JetErrors(const ridges::MongeForm&, double steepness)> errorsOf;

  /// Called with all places when these are on the surface, three coordinates each. May be empty.
  std::function<void(ridges::Span<double>)> located;

  /// Where in a formula a value is not finite at x, y, z or u, v. May be empty.
  std::function<std::string(const double*)> placeOfFault;

  /**
   * Computes, and stores the mesh with its arrays in `output`. One error of the filter if no point
   * has a form, one warning about those that have none. Returns what RequestData is to return.
   */
  int Run(vtkAlgorithm* filter, const vtkRidgesMesh& mesh, vtkPolyData* output);

private:
  const ridges::ExactSurface& Surface;
};

#endif
