// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/SalientSelection.h"

#include <algorithm>
#include <cstdint>

namespace ridges
{
namespace
{

/// One ridge, as pieces [i, i + 1) that are kept or not. Piece numbers of a loop go around.
class Ridgeline
{
public:
  Ridgeline(const RidgeTrace& trace, const RidgeFolds& folds, const SalientRule& rule)
    : Trace_(trace)
    , Folds_(folds)
    , Rule_(rule)
    , Count_(static_cast<Id>(trace.types.size()))
    , Kept_(trace.types.size(), 0)
  {
    for (Id i = 0; i < this->Count_; ++i)
    {
      const bool isMeant = rule.crestOnly ? trace.IsCrest(i) : IsElliptic(trace.types[i]);
      this->Kept_[i] =
        isMeant && folds[i].angle >= rule.weakAngle && folds[i + 1].angle >= rule.weakAngle;
    }
  }

  void AppendLines(Id ridge, std::vector<SalientLine>& lines)
  {
    const auto first =
      static_cast<Id>(std::find(this->Kept_.begin(), this->Kept_.end(), 1) - this->Kept_.begin());
    if (first == this->Count_)
    {
      return;
    }
    Id start = first;
    if (this->Trace_.closed)
    {
      start = this->FindLineAfterGap(first);
      if (start == first + this->Count_ && this->GapBefore(start) <= this->Rule_.longestGap)
      {
        this->Append(ridge, 0, this->Count_, true, lines);
        return;
      }
    }
    Id begin = start; // of the line that is being put together
    Id end = start + 1;
    const Id stop = this->Trace_.closed ? start + this->Count_ : this->Count_;
    double gap = 0.0;
    for (Id i = start + 1; i < stop; ++i)
    {
      if (!this->IsKept(i))
      {
        gap += this->Length(i);
        continue;
      }
      if (gap > this->Rule_.longestGap)
      {
        this->Append(ridge, begin, end, false, lines);
        begin = i;
      }
      end = i + 1;
      gap = 0.0;
    }
    this->Append(ridge, begin, end, false, lines);
  }

private:
  bool IsKept(Id i) const { return this->Kept_[i % this->Count_] != 0; }
  Id VertexAt(Id i) const { return this->Trace_.closed ? i % this->Count_ : i; }
  double Length(Id i) const
  {
    const Id piece = i % this->Count_;
    return (
      this->Trace_.vertices[piece + 1].point.position - this->Trace_.vertices[piece].point.position)
      .norm();
  }

  /// The length of the pieces that are not kept before this one of a loop.
  double GapBefore(Id i) const
  {
    double gap = 0.0;
    for (Id before = i + this->Count_ - 1; !this->IsKept(before); --before)
    {
      gap += this->Length(before);
    }
    return gap;
  }

  /// The first kept piece of a loop, after `first`, before which there is a gap too long to bridge;
  /// if there is none, `first` a turn later.
  Id FindLineAfterGap(Id first) const
  {
    for (Id i = first + 1; i < first + this->Count_; ++i)
    {
      if (this->IsKept(i) && this->GapBefore(i) > this->Rule_.longestGap)
      {
        return i;
      }
    }
    return first + this->Count_;
  }

  void Append(Id ridge, Id begin, Id end, bool closed, std::vector<SalientLine>& lines) const
  {
    SalientLine line;
    line.ridge = ridge;
    line.closed = closed;
    double length = 0.0;
    double sure = 0.0;
    for (Id i = begin; i < end; ++i)
    {
      const Fold& a = this->Folds_[this->VertexAt(i)];
      const Fold& b = this->Folds_[this->VertexAt(i + 1)];
      const double piece = this->Length(i);
      line.vertices.push_back(this->VertexAt(i));
      line.mass += 0.5 * piece * (a.angle + b.angle);
      line.angle = std::max({ line.angle, a.angle, b.angle });
      length += piece;
      const bool isSure = IsElliptic(this->Trace_.types[i % this->Count_]) &&
        std::min(a.height, b.height) > this->Rule_.floor;
      sure += isSure ? piece : 0.0;
    }
    line.vertices.push_back(this->VertexAt(end));
    line.confidence = length > 0.0 ? sure / length : 0.0;
    if (line.angle >= this->Rule_.angle && line.mass >= this->Rule_.leastMass)
    {
      lines.push_back(std::move(line));
    }
  }

  const RidgeTrace& Trace_;
  const RidgeFolds& Folds_;
  const SalientRule& Rule_;
  Id Count_;
  std::vector<std::uint8_t> Kept_;
};

} // namespace

std::vector<SalientLine> SelectSalient(const std::vector<RidgeTrace>& ridges,
  const std::vector<RidgeFolds>& folds, const SalientRule& rule)
{
  std::vector<SalientLine> lines;
  for (std::size_t i = 0; i < ridges.size(); ++i)
  {
    Ridgeline(ridges[i], folds[i], rule).AppendLines(static_cast<Id>(i), lines);
  }
  return lines;
}

} // namespace ridges
