// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What is found by going from triangle to triangle on a mesh in pieces. All ranks have to call
// these.

#ifndef ridges_PieceWalks_h
#define ridges_PieceWalks_h

#include "Mesh/EnclosingSphere.h"
#include "Shares/PieceSeams.h"

namespace ridges
{

/// Raises levels by one from each point to its neighbours, up to `highest`: those of points to
/// start from are given, others are higher. Where this rank's triangles do not reach, those at
/// `highest` may be higher than they are on others.
void SpreadLevels(Ranks& ranks, const TriangleMesh& piece, const PieceSeams& seams,
  std::uint8_t highest, std::vector<std::uint8_t>& levels);

/// BorderStrip of the whole mesh for the points of the piece. Empty on all ranks if no point is on
/// the border.
std::vector<std::uint8_t> BorderStripOfPiece(Ranks& ranks, const TriangleMesh& piece,
  const PieceSeams& seams, const std::vector<std::uint8_t>& onBorder, const double* radii);

/// The radius of the smallest sphere around all triangles.
double EnclosingRadiusOfPieces(Ranks& ranks, const TriangleMesh& piece);

} // namespace ridges

#endif
