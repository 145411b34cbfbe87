// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_TracedSegments_h
#define ridges_TracedSegments_h

#include "Foliation/SheetBall.h"

#include <algorithm>
#include <cmath>

namespace ridges
{

/// A step of a line: inside one triangle.
struct TracedSegment
{
  Eigen::Vector3d start;
  Eigen::Vector3d end;
  double curvature; ///< At the end.
  double arc;       ///< Signed length of the line from its seed to the end.
  Id triangle;
  Id line;
  Id below = -1; ///< The segment stored before in the same triangle.
};

/**
 * The lines traced so far, as lists of segments per triangle: what a new line keeps its distance
 * from. Neighbours are looked for over the mesh rather than in space, so that the other side of a
 * thin wall does not count.
 */
class TracedSegments
{
public:
  explicit TracedSegments(const TriangleMesh& mesh)
    : Top_(mesh.NumberOfTriangles(), -1)
    , Ball_(mesh)
  {
  }

  std::size_t Size() const { return this->Segments_.size(); }
  const TracedSegment& operator[](std::size_t i) const { return this->Segments_[i]; }
  const TracedSegment& Last() const { return this->Segments_.back(); }

  void Push(TracedSegment segment)
  {
    segment.below = this->Top_[segment.triangle];
    this->Top_[segment.triangle] = static_cast<Id>(this->Segments_.size());
    this->Segments_.push_back(segment);
  }

  void Pop()
  {
    this->Top_[this->Last().triangle] = this->Last().below;
    this->Segments_.pop_back();
  }

  /// Moves the end of the last segment.
  void SetLastEnd(const Eigen::Vector3d& end, double curvature)
  {
    this->Segments_.back().end = end;
    this->Segments_.back().curvature = curvature;
  }

  /// Whether no segment is nearer to a point of a triangle, on the same sheet, than the radius.
  bool IsFree(const Eigen::Vector3d& point, Id triangle, double radius)
  {
    bool isFree = true;
    const double square = radius * radius;
    this->Ball_.Visit(point, triangle, square,
      [this, &isFree, &point, &square](Id t)
      {
        for (Id s = this->Top_[t]; s >= 0 && isFree; s = this->Segments_[s].below)
        {
          const TracedSegment& segment = this->Segments_[s];
          isFree = !(SquaredDistance(point, segment.start, segment.end) < square);
        }
        return isFree ? square : 0.0;
      });
    return isFree;
  }

  /// The distance from a point of a triangle to the nearest segment that counts(segment), on the
  /// same sheet; the radius if there is none within it.
  template <typename Counts>
  double Distance(const Eigen::Vector3d& point, Id triangle, double radius, const Counts& counts)
  {
    double square = radius * radius;
    this->Ball_.Visit(point, triangle, square,
      [this, &counts, &square, &point](Id t)
      {
        for (Id s = this->Top_[t]; s >= 0; s = this->Segments_[s].below)
        {
          const TracedSegment& segment = this->Segments_[s];
          if (counts(segment))
          {
            square = std::min(square, SquaredDistance(point, segment.start, segment.end));
          }
        }
        return square;
      });
    return std::sqrt(square);
  }

  /// Scratch memory to share.
  SheetBall& Ball() { return this->Ball_; }

private:
  std::vector<TracedSegment> Segments_;
  std::vector<Id> Top_;
  SheetBall Ball_;
};

} // namespace ridges

#endif
