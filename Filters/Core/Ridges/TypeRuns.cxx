// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/TypeRuns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace ridges
{
namespace
{

double LengthOf(const RidgeTrace& trace, std::size_t piece)
{
  return (trace.vertices[piece + 1].point.position - trace.vertices[piece].point.position).norm();
}

/// The mean of P on a piece, positive if it speaks for the piece's type.
double EvidenceOf(const RidgeTrace& trace, std::size_t piece)
{
  const double sum = trace.vertices[piece].point.P + trace.vertices[piece + 1].point.P;
  return IsElliptic(trace.types[piece]) ? -0.5 * sum : 0.5 * sum;
}

/// What speaks for the type of a piece or a run, and what that is to be compared with.
struct Weight
{
  double evidence = 0.0;
  double length = 0.0;
  double squaredError = 0.0;
  double scale = 0.0;

  void Add(const Weight& other, double sign)
  {
    this->evidence += sign * other.evidence;
    this->length += other.length;
    this->squaredError += other.squaredError;
    this->scale += other.scale;
  }

  /// Integrals along the run. Fits whose centres are within one radius err alike, others
  /// differently: over longer runs errors average out.
  double Error() const
  {
    return this->length > 0.0
      ? std::sqrt(this->squaredError * std::min(this->length, this->scale / this->length))
      : 0.0;
  }
};

/// The runs of one type in a ridge: a list, from which those of the least weight are taken out.
class WeightedRuns
{
public:
  enum class Kind
  {
    Lengths, ///< That count alone, and add up over runs of any type.
    Signed   ///< Against errors; a run of the other type counts against a run.
  };

  /// Weights of the pieces.
  WeightedRuns(RidgeTrace& trace, const std::vector<Weight>& weights, Kind kind);

  /// Gives runs of less than this, or than this times their error, the type of the one before, the
  /// least first.
  void Absorb(double least);

private:
  struct Run
  {
    std::size_t first; ///< Piece of the ridge.
    std::size_t count; ///< Pieces from there on, over the end of a loop to its start.
    Weight weight;
    std::size_t previous;
    std::size_t next;
    bool isLeft = true;
  };
  using Entry = std::pair<double, std::size_t>; ///< Significance and run.

  double SignificanceOf(std::size_t run) const
  {
    const Weight& weight = this->Runs_[run].weight;
    if (this->Kind_ == Kind::Lengths)
    {
      return weight.evidence;
    }
    const double error = weight.Error();
    return error > 0.0 ? weight.evidence / error : std::numeric_limits<double>::infinity();
  }
  bool HasTwoNeighbors(std::size_t run) const
  {
    return this->Trace_.closed ? this->Runs_[run].next != run
                               : run > 0 && this->Runs_[run].next < this->Runs_.size();
  }
  void Push(std::size_t run, double least);
  void Unite(std::size_t run, std::size_t with, double sign);

  RidgeTrace& Trace_;
  Kind Kind_;
  std::vector<Run> Runs_;
  std::vector<Entry> Queue_; ///< A heap, the least first.
};

WeightedRuns::WeightedRuns(RidgeTrace& trace, const std::vector<Weight>& weights, Kind kind)
  : Trace_(trace)
  , Kind_(kind)
{
  for (std::size_t i = 0; i < trace.types.size(); ++i)
  {
    if (i == 0 || trace.types[i] != trace.types[i - 1])
    {
      const std::size_t run = this->Runs_.size();
      this->Runs_.push_back({ i, 0, {}, run - 1, run + 1 });
    }
    Run& run = this->Runs_.back();
    ++run.count;
    run.weight.Add(weights[i], 1.0);
  }
  if (trace.closed && !this->Runs_.empty())
  {
    this->Runs_.front().previous = this->Runs_.size() - 1;
    this->Runs_.back().next = 0;
  }
}

void WeightedRuns::Push(std::size_t run, double least)
{
  const double significance = this->SignificanceOf(run);
  if (significance < least)
  {
    this->Queue_.emplace_back(significance, run);
    std::push_heap(this->Queue_.begin(), this->Queue_.end(), std::greater<Entry>());
  }
}

/// Adds to a run the one that follows it, which speaks for the same type, or against it.
void WeightedRuns::Unite(std::size_t run, std::size_t with, double sign)
{
  Run& other = this->Runs_[with];
  this->Runs_[run].count += other.count;
  this->Runs_[run].weight.Add(other.weight, sign);
  this->Runs_[run].next = other.next;
  other.isLeft = false;
  if (other.next < this->Runs_.size())
  {
    this->Runs_[other.next].previous = run;
  }
}

// A piece changes its type but rarely: each time its run has three times as many before.
void WeightedRuns::Absorb(double least)
{
  for (std::size_t run = 0; run < this->Runs_.size(); ++run)
  {
    this->Push(run, least);
  }
  while (!this->Queue_.empty())
  {
    std::pop_heap(this->Queue_.begin(), this->Queue_.end(), std::greater<Entry>());
    const auto [significance, run] = this->Queue_.back();
    this->Queue_.pop_back();
    const Run& absorbed = this->Runs_[run];
    if (!absorbed.isLeft || this->SignificanceOf(run) != significance ||
      !this->HasTwoNeighbors(run))
    {
      continue;
    }
    std::vector<RidgeType>& types = this->Trace_.types;
    const std::size_t before = absorbed.previous;
    const std::size_t after = absorbed.next;
    const RidgeType type = types[this->Runs_[before].first];
    for (std::size_t i = 0; i < absorbed.count; ++i)
    {
      types[(absorbed.first + i) % types.size()] = type;
    }
    this->Unite(before, run, this->Kind_ == Kind::Signed ? -1.0 : 1.0);
    if (after != before && types[this->Runs_[after].first] == type)
    {
      this->Unite(before, after, 1.0);
    }
    this->Push(before, least);
  }
}

/// So that no run of a loop is cut at its start.
void StartAtRun(RidgeTrace& trace)
{
  for (std::size_t i = 1; trace.closed && i < trace.types.size(); ++i)
  {
    if (trace.types[i] != trace.types[i - 1])
    {
      RotateLoop(trace, i);
      break;
    }
  }
}

bool HasSeveralRuns(const RidgeTrace& trace)
{
  return std::any_of(trace.types.begin(), trace.types.end(),
    [&trace](RidgeType type) { return type != trace.types.front(); });
}

// A turning point that does not turn any more lies on the straight piece that it was put on.
void RemoveFormerTurningPoints(RidgeTrace& trace)
{
  const auto isBetween = [](const RidgeVertex& vertex)
  { return vertex.edge == RidgeVertex::None && vertex.umbilic == RidgeVertex::None; };
  if (trace.closed && trace.types.front() == trace.types.back())
  {
    // Between two turning points of a loop there is a crossing of an edge.
    RotateLoop(trace, isBetween(trace.vertices.front()) ? 1 : 0);
  }
  std::vector<RidgeVertex> vertices{ trace.vertices.front() };
  std::vector<RidgeType> types;
  for (std::size_t i = 0; i < trace.types.size(); ++i)
  {
    const RidgeVertex& start = trace.vertices[i];
    if (i > 0 && isBetween(start) && trace.types[i] == trace.types[i - 1])
    {
      vertices.back() = trace.vertices[i + 1];
      continue;
    }
    types.push_back(trace.types[i]);
    vertices.push_back(trace.vertices[i + 1]);
  }
  trace.vertices = std::move(vertices);
  trace.types = std::move(types);
}

} // namespace

void AbsorbShortRuns(RidgeTrace& trace, double length)
{
  if (!HasSeveralRuns(trace))
  {
    return;
  }
  StartAtRun(trace);
  std::vector<Weight> weights(trace.types.size());
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    weights[i].evidence = LengthOf(trace, i);
  }
  WeightedRuns(trace, weights, WeightedRuns::Kind::Lengths).Absorb(length);
  RemoveFormerTurningPoints(trace);
}

void AbsorbInsignificantRuns(RidgeTrace& trace, const TypeErrors& errors, double significance)
{
  if (!HasSeveralRuns(trace))
  {
    return;
  }
  StartAtRun(trace);
  const std::vector<double> errorOf = errors.ErrorsOf(trace);
  const std::vector<double> scaleOf = errors.ScalesOf(trace);
  std::vector<Weight> weights(trace.types.size());
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    const double length = LengthOf(trace, i);
    const double error = 0.5 * (errorOf[i] + errorOf[i + 1]);
    const double scale = 0.5 * (scaleOf[i] + scaleOf[i + 1]);
    weights[i] = { length * EvidenceOf(trace, i), length, length * error * error, length * scale };
  }
  WeightedRuns(trace, weights, WeightedRuns::Kind::Signed).Absorb(significance);
  RemoveFormerTurningPoints(trace);
}

std::vector<double> SureLengthsOf(
  const RidgeTrace& trace, const TypeErrors& errors, double significance)
{
  const std::vector<double> errorOf = errors.ErrorsOf(trace);
  const std::vector<double> slopeOf = errors.SlopesOf(trace);
  std::vector<double> lengths(trace.types.size(), 0.0);
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    const double sign = IsElliptic(trace.types[i]) ? -1.0 : 1.0;
    const double error = 0.5 * (errorOf[i] + errorOf[i + 1]);
    if (EvidenceOf(trace, i) > significance * error && sign * (slopeOf[i] + slopeOf[i + 1]) > 0.0)
    {
      lengths[i] = LengthOf(trace, i);
    }
  }
  return lengths;
}

} // namespace ridges
