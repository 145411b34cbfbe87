// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_CoherenceCheck_h
#define ridges_CoherenceCheck_h

#include "Base/Types.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <variant>
#include <vector>

namespace ridges
{

enum class CheckKind
{
  IndexSum,
  UmbilicsPerTriangle,
  RidgesAtUmbilics,
  TypesAtUmbilics,
  RidgeEnds,
  TurningPoints,
  Intersections,
  Patches,
  RidgesInPatches,
  PatchContours,
  RightAngles,
  DoubleCrossings,
  PointsOnEdges,
  Crossings
};

/// What the ids of offenders number.
enum class OffenderKind
{
  Umbilic,
  Ridge,
  RidgePoint,
  Edge, ///< A pair of points.
  Triangle
};

/// What speaks against coherence, and where.
struct Offender
{
  std::array<Id, 2> ids; ///< The second one of edges only.
  Eigen::Vector3d position;
};

/// @name Numbers
/// What a check has measured, besides its offenders.
///@{
/// Of CheckIndexSum. The sums are over closed parts.
struct IndexSums
{
  Id characteristic = 0;
  double index = 0.0;
  std::size_t closedParts = 0;
  std::size_t parts = 0;
};

/// Of CheckRidgesAtUmbilics and CheckPatchContours: numbers of umbilics, and of ridges or crossings
/// at the first offender.
struct RidgeCounts
{
  std::size_t umbilics = 0;
  int blue = 0;
  int red = 0;
  int expected = 0; ///< Of each colour.
};

/// Of CheckRidgeEnds.
struct EndCounts
{
  std::size_t ridges = 0;
  std::size_t loops = 0;
  std::size_t atUmbilics = 0;
  std::size_t atBorders = 0;
};

/// Of CheckTurningPoints.
struct TurningCounts
{
  std::size_t turningPoints = 0;
  std::size_t ridges = 0; ///< Loops and ridges between umbilics.
};

/// Of CheckRightAngles.
struct Cosines
{
  double expected = 0.0; ///< No less than this.
  double least = 1.0;
};

/// Of CheckCrossings, of blue and red.
struct CrossingCounts
{
  std::array<std::size_t, 2> lost = { 0, 0 };
  std::array<std::size_t, 2> crossed = { 0, 0 };
  std::size_t smallLoops = 0;
};
///@}

/// One check of coherence.
struct CoherenceCheck
{
  CoherenceCheck(CheckKind kindOfCheck, OffenderKind kindOfOffenders)
    : kind(kindOfCheck)
    , offenderKind(kindOfOffenders)
  {
  }

  CheckKind kind;
  OffenderKind offenderKind;
  bool applies = true;
  std::vector<Offender> offenders;

  /// A plain number is that of the patches of CheckPatches, of the ends of CheckTypesAtUmbilics, of
  /// the points of CheckPointsOnEdges, and the most umbilics of CheckUmbilicsPerTriangle.
  std::variant<std::size_t, IndexSums, RidgeCounts, EndCounts, TurningCounts, Cosines,
    CrossingCounts>
    numbers;

  bool Passed() const { return this->offenders.empty(); }
};

} // namespace ridges

#endif
