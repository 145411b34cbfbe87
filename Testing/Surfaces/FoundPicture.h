// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// A picture of umbilics and ridges, as the filters have found it.

#ifndef RIDGES_TESTING_FOUND_PICTURE_H
#define RIDGES_TESTING_FOUND_PICTURE_H

#include <Eigen/Core>

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

double LengthOf(const std::vector<Eigen::Vector3d>& points);
double LengthOf(const FoundRidge& ridge);

} // namespace testing
} // namespace ridges

#endif
