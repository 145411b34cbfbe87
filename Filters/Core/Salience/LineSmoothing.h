// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_LineSmoothing_h
#define ridges_LineSmoothing_h

#include "Foliation/SheetBall.h"
#include "Ridges/RidgeTrace.h"

#include <vector>

namespace ridges
{

/**
 * Smooths lines within the surface: each vertex is moved to the average of the line around it,
 * taken with a Gaussian of deviation `sigma`, and from there to the nearest point of its sheet of
 * the surface. It lies on no edge then, and keeps what was measured where it was.
 *
 * The ends of an open line stay, near which the Gaussian is narrower, and so do vertices that were
 * on no edge.
 */
class LineSmoother
{
public:
  LineSmoother(const TriangleMesh& mesh, const MongeField& field, double sigma);

  /// A closed line repeats its first vertex at its end.
  void Smooth(bool closed, std::vector<RidgeVertex>& vertices);

private:
  Eigen::Vector3d NearestOnSheet(const Eigen::Vector3d& place, const RidgeVertex& vertex);

  const TriangleMesh& Mesh_;
  const MongeField& Field_;
  double Sigma_;
  SheetBall Ball_;
};

} // namespace ridges

#endif
