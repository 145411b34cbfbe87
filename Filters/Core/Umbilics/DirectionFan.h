// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_DirectionFan_h
#define ridges_DirectionFan_h

#include "Mesh/TriangleFan.h"
#include "Monge/MongeField.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace ridges
{

/// d1 at a corner of a triangle, by angles of the fan around the point there.
struct CornerDirection
{
  double corner = 0.0; ///< The angle of the triangle at the corner, as stretched for the fan.
  double angle = 0.0;  ///< Of d1, from the first edge of the triangle at the corner.
};

/**
 * Angles around points. In a closed fan the angles of the triangles are stretched to sum to a full
 * turn, whatever their shapes; where all of them are 0 they are made equal.
 *
 * The directions of the edges are then known twice, by these angles and by their projection on the
 * tangent plane: the angle of d1 is that at which both agree best.
 */
class DirectionFans
{
public:
  class Memory;

  /// Looks at the points with very many triangles at once, as their triangles would all ask again.
  DirectionFans(const TriangleMesh& mesh, const MongeField& field);

  /// The same to the last digit whatever the memory holds.
  CornerDirection At(FanCorner corner, Memory& memory) const;

private:
  /// An edge from the point in the middle of a fan.
  struct Spoke
  {
    Id end = 0;
    Eigen::Vector3d direction = Eigen::Vector3d::Zero(); ///< Unit, or zero.
    double length = 0.0;                                 ///< As a part of the longest.
    double alpha = 0.0; ///< Angle from the first spoke, as the triangles have it.
  };

  void LookAround(Id point, Memory& memory, std::vector<CornerDirection>& all) const;
  FanExtent GatherFromFirst(FanCorner corner, std::vector<FanCorner>& fan) const;
  void GatherSpokes(const std::vector<FanCorner>& fan, Id size, std::vector<Spoke>& spokes) const;
  static void MeasureAngles(std::vector<Spoke>& spokes, FanExtent extent);
  double SideOf(Id point, const std::vector<Spoke>& spokes, Id size) const;
  bool IsFirst(Id p, Id q) const;
  double AngleOfD1(Id point, const std::vector<Spoke>& spokes, FanExtent extent) const;

  const TriangleMesh& Mesh_;
  MongeField Field_;
  std::unordered_map<Id, std::vector<CornerDirection>> Large_; ///< As TrianglesAround.
};

/// The fans looked at last, as all triangles of one ask for it: of one mesh, and for one thread.
class DirectionFans::Memory
{
public:
  Memory() = default;
  /// Remembers so many at most, a power of two.
  explicit Memory(std::size_t size)
    : Slots_(size)
  {
  }

private:
  friend class DirectionFans;
  struct Slot
  {
    Id point = -1;
    std::vector<CornerDirection> at; ///< As TrianglesAround.
  };

  std::vector<Slot> Slots_ = std::vector<Slot>(2048);
  // Of the fan being looked at.
  std::vector<FanCorner> Fan_;
  std::vector<Spoke> Spokes_;
  std::vector<std::uint8_t> IsDone_;
};

} // namespace ridges

#endif
