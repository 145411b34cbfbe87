// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_DirectionFan_h
#define ridges_DirectionFan_h

#include "Mesh/TriangleFan.h"
#include "Monge/MongeField.h"

#include <unordered_map>
#include <vector>

namespace ridges
{

/// d1 at a corner of a triangle, by angles of the fan around the point there.
struct CornerDirection
{
  double corner = 0.0; ///< The angle of the triangle at the corner, as stretched for the fan.
  double angle = 0.0;  ///< Of d1, from the first edge of the triangle at the corner.
};

/**
 * Angles around points. In a closed fan the angles of the triangles are stretched to sum to a full
 * turn, whatever their shapes; where all of them are 0 they are made equal.
 *
 * The directions of the edges are then known twice, by these angles and by their projection on the
 * tangent plane: the angle of d1 is that at which both agree best.
 */
class DirectionFans
{
public:
  /// Looks at the points with very many triangles at once, as their triangles would all ask again.
  DirectionFans(const TriangleMesh& mesh, const MongeField& field);

  CornerDirection At(FanCorner corner) const;

private:
  std::vector<CornerDirection> AtAllTriangles(Id point) const;

  const TriangleMesh& Mesh_;
  MongeField Field_;
  std::unordered_map<Id, std::vector<CornerDirection>> Large_; ///< As TrianglesAround.
};

} // namespace ridges

#endif
