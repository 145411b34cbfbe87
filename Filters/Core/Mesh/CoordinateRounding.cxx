// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CoordinateRounding.h"

#include <limits>

namespace ridges
{

double CoordinateRounding(const TriangleMesh& mesh)
{
  if (mesh.Part())
  {
    return mesh.Part()->coordinateRounding;
  }
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    for (const double x : mesh.Point(p))
    {
      if (static_cast<double>(static_cast<float>(x)) != x)
      {
        return 0.5 * std::numeric_limits<double>::epsilon();
      }
    }
  }
  return 0.5 * static_cast<double>(std::numeric_limits<float>::epsilon());
}

} // namespace ridges
