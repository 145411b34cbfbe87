// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_RidgePicture_h
#define ridges_RidgePicture_h

#include "Mesh/TriangleMesh.h"
#include "Monge/MongeField.h"
#include "Ridges/RidgeType.h"

#include <array>
#include <vector>

namespace ridges
{

/// An umbilic as it was put out.
struct PictureUmbilic
{
  Id id;
  Id triangle = -1; ///< -1: none of the mesh.
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  int ridgeCount = 0;
  double index = 0.0;
};

/// A point of a ridge as it was put out: on an edge, at an umbilic, or a turning point between.
struct PicturePoint
{
  static constexpr Id None = -1;
  static constexpr Id NoEdge = -2; ///< What was put out is no edge of the mesh.

  Id edge = None;
  double parameter = 0.0; ///< From the edge's smaller point id.
  Id umbilic = None;      ///< The id of it.
  bool turning = false;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();

  /// At an umbilic, or at a singular triangle that is not marked as one.
  bool IsUmbilic() const { return this->umbilic >= 0 || (this->edge == None && !this->turning); }
};

/// A polyline of one type.
struct PictureLine
{
  RidgeType type;
  Id ridge; ///< Of which it is a part.
  bool closed;
  std::vector<Id> points;
};

/**
 * The picture of ridges and umbilics on a mesh, by what filters put out and not by how they found
 * it: what the checks of coherence look at. The mesh has all its triangles, usable or not.
 */
struct RidgePicture
{
  const TriangleMesh* mesh = nullptr;
  MongeField field;
  std::vector<std::uint8_t> isUsable;        ///< Per triangle: whether ridges may run in it.
  std::vector<Id> patchOf;                   ///< Per triangle: id of the umbilic, -1 outside.
  std::vector<std::uint8_t> isInMaximumZone; ///< Per triangle: in a zone of k1; may be empty.
  std::vector<std::uint8_t> isInMinimumZone; ///< The same of k2.
  std::vector<Id> cancelledIn;               ///< Per triangle: region of cancelled umbilics, or -1.
  std::vector<PictureUmbilic> umbilics;
  std::vector<PicturePoint> points;
  std::vector<PictureLine> lines;

  /// The patch or region of cancelled umbilics a triangle is in, inside which ridges are drawn by
  /// other rules than the acute one: a number for each, or -1.
  std::int64_t RegionOf(Id triangle) const
  {
    const std::int64_t patch = this->patchOf[triangle];
    const std::int64_t cancelled = this->cancelledIn[triangle];
    return patch >= 0 ? 2 * patch : (cancelled >= 0 ? 2 * cancelled + 1 : -1);
  }

  /// Whether a triangle is in a zone of a colour, where ridges were left out.
  bool IsInZone(Color color, Id triangle) const
  {
    const std::vector<std::uint8_t>& zone =
      color == Color::Blue ? this->isInMaximumZone : this->isInMinimumZone;
    return triangle >= 0 && !zone.empty() && zone[triangle] != 0;
  }

  /// Number of usable triangles at an edge; other than 2 it is a border to ridges.
  int UsableSides(Id edge) const;
  bool IsBorder(Id edge) const { return this->UsableSides(edge) != 2; }

  /// Whether the acute rule alone decides on an edge: it is usable, and outside or on the border of
  /// regions.
  bool IsOutside(Id edge) const;

  /// The umbilic of an id, or null.
  const PictureUmbilic* UmbilicOf(Id id) const;
};

/// Whether so many ridges of each colour are as many as the umbilic has; in a zone it may have lost
/// them all.
bool HasItsRidges(
  const RidgePicture& picture, const PictureUmbilic& umbilic, const std::array<int, 2>& counts);

/// The edge between two points, or PicturePoint::NoEdge.
Id FindEdge(const TriangleMesh& mesh, Id p, Id q);

/// The triangles at an edge, also where there are more than two.
std::vector<Id> TrianglesAt(const TriangleMesh& mesh, Id edge);

} // namespace ridges

#endif
