// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_UmbilicPatch_h
#define ridges_UmbilicPatch_h

#include "Mesh/IdTable.h"

namespace ridges
{

/**
 * Grows a patch around a triangle that stays a topological disk (RR-5294, section 8.1): always
 * the triangle next to the patch whose centroid is nearest to the first one's is added, if the
 * patch remains a disk with it, until the nearest is farther than a threshold.
 *
 * Holds scratch memory of the size of a patch: use one per thread.
 */
class UmbilicPatch
{
public:
  explicit UmbilicPatch(const TriangleMesh& mesh)
    : Mesh_(mesh)
  {
  }

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

  /// To grow a patch triangle by triangle: it has this one only.
  void Start(Id triangle);
  /// Adds the next triangle, if there is one within the threshold.
  bool GrowByOne(double threshold);

  /// The patch as it is, in the order of growth.
  Span<Id> Triangles() const
  {
    return { this->Patch_.data(), this->Patch_.data() + this->Patch_.size() };
  }

  /// The least threshold with which the last triangle is in the patch. It grows with the patch, so
  /// that every beginning of a patch is a patch.
  double Threshold() const { return this->Threshold_; }

  bool Contains(Id triangle) const { return this->IsInside_.Contains(triangle); }

  /// The corners along the border of the last patch, in its orientation, each once, from that which
  /// comes first by position.
  std::vector<Id> Contour() const;

private:
  struct Candidate
  {
    double grade;
    Id triangle;
  };

  bool IsFarther(const Candidate& a, const Candidate& b) const;
  bool StaysDisk(Id triangle) const;
  void Add(Id triangle);

  const TriangleMesh& Mesh_;
  IdTable<bool> IsInside_; ///< Of triangles.
  IdTable<bool> IsCorner_; ///< Of points.
  std::vector<Id> Patch_;
  double Threshold_ = 0.0;
  double Reached_ = 0.0;         ///< The greatest distance of a triangle looked at.
  std::vector<Candidate> Queue_; ///< A heap, the nearest first.
  Eigen::Vector3d Center_ = Eigen::Vector3d::Zero();
};

} // namespace ridges

#endif
