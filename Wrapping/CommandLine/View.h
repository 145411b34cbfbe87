// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef View_h
#define View_h

#include "vtkPolyData.h"

#include <array>
#include <optional>
#include <vector>

namespace program
{

using Vector3 = std::array<double, 3>;

/**
 * A parallel view of a surface that fills the picture. right, up and back (towards the viewer) are
 * orthonormal; a point is projected to ((p - center) right, (p - center) up) / scale, which is
 * within the picture's half width and half height, in half heights.
 */
struct View
{
  Vector3 right{};
  Vector3 up{};
  Vector3 back{};
  Vector3 center{};
  double scale = 1.0; ///< Length that half the height of the picture shows.
  double depth = 1.0; ///< Half the extent along back.

  std::array<double, 2> Project(const Vector3& point) const;
};

/**
 * Unless told otherwise, y or z is up, whichever the surface extends more along, and the viewer
 * looks along the other axis of least extent, but somewhat from the side and from above.
 * The aspect is the picture's width over its height, the margin a fraction of both.
 */
View FindView(const std::vector<Vector3>& points, const std::optional<Vector3>& viewDirection,
  const std::optional<Vector3>& upDirection, double aspect, double margin);

/// The points that polygons and strips use, as far as they are finite.
std::vector<Vector3> PointsOfSurface(vtkPolyData* mesh);

} // namespace program

#endif
