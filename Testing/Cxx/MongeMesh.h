// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// A mesh with Monge arrays as ridges see it, found again without the library's help.

#ifndef MongeMesh_h
#define MongeMesh_h

#include "vtkPolyData.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace ridges
{
namespace testing
{

using EdgeKey = std::pair<vtkIdType, vtkIdType>; ///< The smaller id first.

EdgeKey KeyOf(vtkIdType p, vtkIdType q);

/// The usable triangles, the acute rule on them, and the regions that are marked on them: the
/// patches of the umbilics, and behind them those where umbilics have cancelled each other.
class MongeMesh
{
public:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  struct Region
  {
    std::vector<std::size_t> triangles;
    std::size_t umbilic = None; ///< The triangle of the umbilic.
    int ridgeCount = 0;
  };

  explicit MongeMesh(vtkPolyData* mesh);

  bool Crosses(const EdgeKey& edge, bool maximum) const;
  bool IsSingular(std::size_t triangle) const;
  bool Contains(std::size_t triangle, const Eigen::Vector3d& x) const;
  EdgeKey SideOf(std::size_t triangle, int side) const;

  /// The triangles with all of these edges.
  std::vector<std::size_t> TrianglesWith(const std::vector<EdgeKey>& edges) const;

  /// The region that has the triangles on both sides of an edge, or None.
  std::size_t RegionAround(const EdgeKey& edge) const;

  /// Whether the triangles make a disk.
  bool IsDisk(const Region& region) const;

  /// Edges of the region, crossed by the colour, that lead out of it.
  std::size_t CountContourCrossings(std::size_t region, bool maximum) const;

  std::vector<std::array<vtkIdType, 3>> triangles;
  std::vector<std::size_t> regionOf; ///< By triangle, None outside.
  std::map<EdgeKey, std::vector<std::size_t>> sides;
  std::vector<Region> regions; ///< The first belong to the umbilics, by their ids.

private:
  void FetchPoints();
  void FetchRegions(const std::vector<vtkIdType>& cells);
  int AcuteSign(const EdgeKey& edge) const;

  vtkPolyData* Mesh_;
  std::vector<bool> IsUsable_;
  std::vector<Eigen::Vector3d> Directions_;
  std::vector<std::array<double, 2>> Extremalities_; ///< b0 and b3.
};

} // namespace testing
} // namespace ridges

#endif
