// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// A picture of umbilics and ridges, compared with the true one.

#ifndef RIDGES_TESTING_RIDGE_COMPARISON_H
#define RIDGES_TESTING_RIDGE_COMPARISON_H

#include "FoundPicture.h"
#include "RidgeCoverage.h"
#include "TruthCache.h"

#include <string>
#include <vector>

namespace ridges
{
namespace testing
{

class RidgeComparison
{
public:
  RidgeComparison(Truth truth, FoundPicture found, double edge);

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
