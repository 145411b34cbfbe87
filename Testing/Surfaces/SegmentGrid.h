// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RIDGES_TESTING_SEGMENT_GRID_H
#define RIDGES_TESTING_SEGMENT_GRID_H

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace ridges
{
namespace testing
{

// Segments by the cells of a grid, to find the nearest to a point.
class SegmentGrid
{
public:
  // Nothing farther away than reach is found.
  explicit SegmentGrid(double reach)
    : Reach(reach)
  {
  }

  void Add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, int line, int segment);

  struct Hit
  {
    double distance = std::numeric_limits<double>::infinity();
    double parameter = 0.0; // fraction of the way from a to b
    int line = -1;
    int segment = -1;
  };
  Hit Nearest(const Eigen::Vector3d& point) const;

private:
  struct Entry
  {
    Eigen::Vector3d a, b;
    int line;
    int segment;
  };
  using Index = Eigen::Matrix<std::int64_t, 3, 1>;
  Index CellOf(const Eigen::Vector3d& point) const;
  static std::int64_t KeyOf(const Index& cell);

  double Reach;
  std::vector<Entry> Entries;
  std::unordered_map<std::int64_t, std::vector<int>> Cells; // of the size of the reach
};

} // namespace testing
} // namespace ridges

#endif
