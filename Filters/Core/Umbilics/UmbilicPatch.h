// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_UmbilicPatch_h
#define ridges_UmbilicPatch_h

#include "Mesh/TriangleMesh.h"

namespace ridges
{

/**
 * Grows a patch around a triangle that stays a topological disk (RR-5294, section 8.1): always
 * the triangle next to the patch whose centroid is nearest to the first one's is added, if the
 * patch remains a disk with it, until the nearest is farther than a threshold.
 *
 * Holds scratch memory: use one per thread.
 */
class UmbilicPatch
{
public:
  explicit UmbilicPatch(const TriangleMesh& mesh);

  /**
   * The patch around a triangle, itself first, in the order of growth. The threshold is `size`
   * times the greatest distance of a centroid in the one-ring, the triangles that share a corner
   * with it. Valid until the next call.
   */
  Span<Id> Grow(Id triangle, double size);

  /// The same with a threshold in the unit of the points.
  Span<Id> GrowTo(Id triangle, double threshold);

  /// The greatest distance of a centroid in the one-ring, the unit of size.
  double OneRingGrade(Id triangle) const;

  /// For each triangle of the last patch the least threshold with which it is in the patch: a
  /// growing sequence, so that every beginning of the patch is a patch.
  const std::vector<double>& Thresholds() const { return this->Thresholds_; }

  bool Contains(Id triangle) const { return this->TriangleStamps_[triangle] == this->Stamp_; }

  /// The corners along the border of the last patch, in its orientation, each once.
  std::vector<Id> Contour() const;

private:
  struct Candidate
  {
    double grade;
    Id triangle;
    bool operator<(const Candidate& other) const
    {
      return this->grade != other.grade ? this->grade > other.grade
                                        : this->triangle > other.triangle;
    }
  };

  bool StaysDisk(Id triangle) const;
  void Add(Id triangle);

  const TriangleMesh& Mesh_;
  std::vector<std::uint32_t> TriangleStamps_;
  std::vector<std::uint32_t> PointStamps_;
  std::uint32_t Stamp_ = 0;
  std::vector<Id> Patch_;
  std::vector<double> Thresholds_;
  std::vector<Candidate> Queue_; ///< A heap, the nearest first.
  Eigen::Vector3d Center_;
};

} // namespace ridges

#endif
