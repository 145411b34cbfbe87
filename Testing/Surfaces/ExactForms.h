// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RIDGES_TESTING_EXACT_FORMS_H
#define RIDGES_TESTING_EXACT_FORMS_H

#include "AnalyticSurface.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Core>

namespace ridges
{
namespace testing
{

// A copy of a mesh near a surface that was turned by the rotation, with the exact Monge arrays of
// the surface at its points.
vtkSmartPointer<vtkPolyData> WithExactForms(
  vtkPolyData* mesh, const AnalyticSurface& surface, const Eigen::Matrix3d& rotation);

} // namespace testing
} // namespace ridges

#endif
