// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TestMeshes.h"

#include <fstream>

namespace ridges
{
namespace testing
{

//------------------------------------------------------------------------------
Mesh ReadOff(const std::string& path)
{
  std::ifstream file(path);
  std::string keyword;
  std::size_t points = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;
  file >> keyword >> points >> faces >> edges;
  Mesh mesh;
  for (std::size_t i = 0; file && i < points; ++i)
  {
    Eigen::Vector3d point;
    file >> point[0] >> point[1] >> point[2];
    mesh.AddPoint(point);
  }
  for (std::size_t i = 0; file && i < faces; ++i)
  {
    int size = 0;
    std::int32_t a = 0;
    std::int32_t b = 0;
    std::int32_t c = 0;
    file >> size >> a >> b >> c;
    if (size != 3)
    {
      return {};
    }
    mesh.AddTriangle(a, b, c);
  }
  return file ? mesh : Mesh();
}

} // namespace testing
} // namespace ridges
