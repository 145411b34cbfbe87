// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_JetBatchFan_h
#define ridges_JetBatchFan_h

#include "Fit/Batch/JetBatch.h"
#include "Mesh/OrderedRings.h"

#include <algorithm>

namespace ridges
{

/// Says on which side the normal is of a lane whose points are those of whole rings, if
/// `wholeRings`.
inline void FillFan(const TriangleMesh& mesh, const OrderedRings& rings, Id vertex, int lane,
  int lanes, JetBatch& batch, bool wholeRings = true)
{
  Eigen::Vector3d side = Eigen::Vector3d::Zero();
  int triangles = 0;
  int closedTriangles = 0;
  if (wholeRings && rings.IsRegular(vertex))
  {
    const bool open = rings.OnBorder(vertex);
    triangles = rings.Around(vertex).size() - (open ? 1 : 0);
    closedTriangles = open ? 0 : triangles;
  }
  else
  {
    side = mesh.PointNormal(vertex);
  }
  batch.triangles = std::max(batch.triangles, triangles);
  batch.fans[lane] = triangles;
  batch.closedFans[lane] = closedTriangles;
  for (int i = 0; i < 3; ++i)
  {
    batch.side[i * lanes + lane] = side[i];
  }
}

} // namespace ridges

#endif
