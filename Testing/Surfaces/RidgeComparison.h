// SPDX-License-Identifier: BSD-3-Clause
// A picture of umbilics and ridges, compared with the true one.

#ifndef RIDGES_TESTING_RIDGE_COMPARISON_H
#define RIDGES_TESTING_RIDGE_COMPARISON_H

#include "SegmentGrid.h"
#include "TruthCache.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace ridges
{
namespace testing
{

struct FoundUmbilic
{
  Eigen::Vector3d position;
  double index;
  int ridgeCount;
};

struct FoundLine
{
  int type = 0; // 0 to 4, as the array RidgeType
  std::vector<Eigen::Vector3d> points;
};

struct FoundEnd
{
  static constexpr int OnEdge = -2;  // not at an umbilic, as on a border
  static constexpr int Nowhere = -1; // in a singular triangle without an umbilic

  Eigen::Vector3d position;
  int umbilic; // number of the one found, or one of the above
};

struct FoundRidge
{
  std::vector<FoundLine> lines;
  std::vector<FoundEnd> ends; // none for a loop
  bool IsMaximum() const;
};

struct FoundPicture
{
  std::vector<FoundUmbilic> umbilics;
  std::vector<FoundRidge> ridges;
};

class RidgeComparison
{
public:
  RidgeComparison(Truth truth, FoundPicture found, double edge);

  void PrintTables(int eulerCharacteristic) const;
  void PrintLine(int eulerCharacteristic) const;

private:
  // Of a colour: how far lines are from those they should lie on.
  struct Coverage
  {
    double mean = 0.0;
    double percentile95 = 0.0;
    double greatest = 0.0; // at most Reach
    Eigen::Vector3d farthest = Eigen::Vector3d::Zero();
    double off = 0.0;       // length farther than an edge
    double wrongType = 0.0; // length within an edge, of another type, not by a turning point
  };
  struct Sample
  {
    double distance;
    double length;
  };

  void MatchUmbilics();
  void MatchRidges();
  void MeasureFound();
  void MeasureTrue();
  static Coverage Summarize(std::vector<Sample> samples);
  bool TypeIsRight(int type, const SegmentGrid::Hit& hit) const;
  std::vector<int> TrueEndsOf(const FoundRidge& ridge) const;
  int EndsAt(int foundUmbilic, bool maximum) const;
  std::string NameOfEnds(const std::vector<int>& ends) const;

  static constexpr double Reach = 6.0; // in edges

  Truth True;
  FoundPicture Found;
  double Edge;
  std::vector<int> FoundOfTrue; // umbilics, -1 for none
  std::vector<int> TrueOfFound;
  std::vector<int> RidgeOfFound;     // the true ridge that most of it lies on, -1 if spurious
  std::vector<double> MissingOfTrue; // length of each true ridge that is not found
  std::array<Coverage, 2> FoundCoverage, TrueCoverage; // by colour: blue, red
  std::vector<std::string> RidgeFaults;
  int WholeRidges = 0;
  int SpuriousRidges = 0;
  int MissingRidges = 0;
};

} // namespace testing
} // namespace ridges

#endif
