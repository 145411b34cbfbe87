// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_LostCrossings_h
#define ridges_LostCrossings_h

#include "Coherence/WholeRidges.h"

namespace ridges
{

/// How often ridges of a colour pass each edge.
std::vector<int> CountPassages(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges, Color color);

/// Edges outside patches and regions of cancelled umbilics that the acute rule crosses, but no
/// ridge of the picture.
struct LostCrossings
{
  std::size_t crossed = 0; ///< By the acute rule.
  std::vector<Id> edges;
  /// Loops within the limits of SmallLoops, or as small parts of loops between regions, which the
  /// search for ridges leaves out if they are insignificant: not among `edges`.
  std::size_t smallLoops = 0;
};

LostCrossings FindLostCrossings(
  const RidgePicture& picture, const std::vector<WholeRidge>& ridges, Color color);

} // namespace ridges

#endif
