// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// A picture of umbilics and ridges, compared with the true one.

#ifndef RIDGES_TESTING_RIDGE_COMPARISON_H
#define RIDGES_TESTING_RIDGE_COMPARISON_H

#include "FoundPicture.h"
#include "RidgeCoverage.h"
#include "TruthCache.h"

#include <array>
#include <string>
#include <vector>

namespace ridges
{
namespace testing
{

// How much of a picture is right.
struct RidgeScore
{
  int umbilics = 0;         // true ones
  int rightUmbilics = 0;    // found with their index and ridge count
  int joinedUmbilics = 0;   // where as many ridges of each colour end as are to
  int spuriousUmbilics = 0; // found, but not there
  double indexSum = 0.0;    // of those found
  double farthest = 0.0;    // umbilic from its true place, in edges
  int ridges = 0;           // true ones
  int wholeRidges = 0;      // found in one piece, between the same umbilics
  int missingRidges = 0;    // more than half of which is not found
  int spuriousRidges = 0;   // found, but not there
  int looseEnds = 0;        // of those found, at no umbilic
  int arcs = 0;             // true ones: parts of ridges of one type
  int typedLines = 0;       // found
  double wrongType = 0.0;   // share of the length found
};

class RidgeComparison
{
public:
  RidgeComparison(Truth truth, FoundPicture found, double edge);

  RidgeScore Score() const;
  const std::array<Coverage, 2>& FoundToTrue() const { return this->OfFound.colors; }
  // Ridges that are not whole or not there, a line each.
  const std::vector<std::string>& Faults() const { return this->RidgeFaults; }

  void PrintTables(int eulerCharacteristic) const;
  void PrintLine(int eulerCharacteristic) const;

private:
  void MatchUmbilics();
  void MatchRidges();
  std::vector<int> TrueEndsOf(const FoundRidge& ridge) const;
  int EndsAt(int foundUmbilic, bool maximum) const;
  std::string NameOfEnds(const std::vector<int>& ends) const;

  Truth True;
  FoundPicture Found;
  double Edge;
  std::vector<int> FoundOfTrue; // umbilics, -1 for none
  std::vector<int> TrueOfFound;
  FoundCoverage OfFound;
  TrueCoverage OfTrue;
  std::vector<std::string> RidgeFaults;
  int WholeRidges = 0;
  int SpuriousRidges = 0;
  int MissingRidges = 0;
};

} // namespace testing
} // namespace ridges

#endif
