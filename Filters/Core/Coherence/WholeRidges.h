// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_WholeRidges_h
#define ridges_WholeRidges_h

#include "Coherence/RidgePicture.h"

namespace ridges
{

/// Points of a ridge one after another. A loop repeats its first point at its end.
struct RidgeChain
{
  std::vector<Id> points;
  std::vector<RidgeType> types; ///< One per piece between two points.
  bool closed = false;
};

/// The polylines of one ridge put together again: in one chain, if they are what they should be.
struct WholeRidge
{
  Id id;
  Color color;
  bool isOfOneColor = true;
  bool saysClosed = false; ///< By the flags of its polylines, all of which agree.
  bool saysOpen = false;
  std::vector<RidgeChain> chains = {};
};

/// The ridges in the order of their ids. A polyline goes on where the one before it ends; umbilics
/// end chains.
std::vector<WholeRidge> FindWholeRidges(const RidgePicture& picture);

/// What a piece of a ridge passes through: from `from` to `to`, one of which may be an umbilic, in
/// a triangle. Turning points between are passed over.
struct RidgePiece
{
  Id triangle; ///< -1: no usable triangle has both ends.
  Id from;     ///< A point of the picture.
  Id to;
};

/// The pieces of a chain, in its order.
std::vector<RidgePiece> PiecesOf(const RidgePicture& picture, const RidgeChain& chain);

} // namespace ridges

#endif
