// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The output of the filters as a picture.

#ifndef RIDGES_TESTING_FILTER_PICTURE_H
#define RIDGES_TESTING_FILTER_PICTURE_H

#include "FoundPicture.h"

#include "vtkPolyData.h"

namespace ridges
{
namespace testing
{

// What the filters have found, turned back by the rotation that the mesh was turned by.
FoundPicture PictureOf(vtkPolyData* umbilics, vtkPolyData* ridges,
  const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity());

} // namespace testing
} // namespace ridges

#endif
