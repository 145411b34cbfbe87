// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Trail_h
#define ridges_Trail_h

#include "Ridges/RidgeTrace.h"

#include <algorithm>
#include <vector>

namespace ridges
{

/// The points of a line and the pieces between them. A closed line, which repeats its first vertex
/// at its end, goes around, and has that point once.
class Trail
{
public:
  Trail(const std::vector<RidgeVertex>& vertices, bool closed)
    : Closed_(closed)
    , Pieces_(std::max(Id(0), static_cast<Id>(vertices.size()) - 1))
    , Lengths_(this->Pieces_)
  {
    for (Id i = 0; i < this->Pieces_; ++i)
    {
      this->Lengths_[i] = (vertices[i + 1].point.position - vertices[i].point.position).norm();
    }
  }

  Id NumberOfPoints() const { return this->Closed_ ? this->Pieces_ : this->Pieces_ + 1; }

  /// The piece before or behind a point; negative where there is none.
  Id PieceBefore(Id point) const
  {
    return point > 0 ? point - 1 : (this->Closed_ ? this->Pieces_ - 1 : -1);
  }
  Id PieceBehind(Id point) const { return point < this->Pieces_ ? point : -1; }
  Id Piece(Id point, bool forward) const
  {
    return forward ? this->PieceBehind(point) : this->PieceBefore(point);
  }
  Id Next(Id point, bool forward) const
  {
    const Id count = this->NumberOfPoints();
    return forward ? (point + 1) % count : (point + count - 1) % count;
  }

  /// Of a piece; 0 where there is none.
  double LengthOf(Id piece) const { return piece < 0 ? 0.0 : this->Lengths_[piece]; }

  /// What a point stands for.
  double LengthAt(Id point) const
  {
    return 0.5 *
      (this->LengthOf(this->PieceBefore(point)) + this->LengthOf(this->PieceBehind(point)));
  }

private:
  bool Closed_;
  Id Pieces_;
  std::vector<double> Lengths_;
};

} // namespace ridges

#endif
