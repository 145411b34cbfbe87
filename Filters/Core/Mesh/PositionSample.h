// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PositionSample_h
#define ridges_PositionSample_h

#include "Base/Ranks.h"
#include "Mesh/TriangleMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ridges
{

/// A point that was drawn, on one of several ranks.
struct DrawnPoint
{
  std::uint64_t hash;
  std::array<double, 3> x;
  std::int32_t rank;
  Id id; ///< On that rank.
};

/// About as many points as wanted, or all of a smaller mesh, in an order: both depend on
/// coordinates only. Points that coincide are left out, as nothing distinguishes them.
std::vector<Id> PositionSample(const TriangleMesh& mesh, double wanted);

/// The same of a mesh of which each rank draws from its first `count` points, that no other has.
/// All ranks get the whole sample.
std::vector<DrawnPoint> PositionSample(
  const TriangleMesh& mesh, Id count, double wanted, Ranks& ranks);

/// The points of a sample that are on this rank, in its order.
std::vector<Id> DrawnOn(int rank, const std::vector<DrawnPoint>& sample);

} // namespace ridges

#endif
