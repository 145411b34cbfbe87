// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Foliation/PrincipalFoliation.h"

#include "Mesh/PositionOrder.h"
#include "Monge/AcuteRule.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ridges
{
namespace
{

/// A candidate is taken from the line it comes from along a straight way over a bent surface; so
/// much less than the separation may be left, for that line and for others.
constexpr double SeedTolerance = 0.95;

/// Distances are looked up to this multiple of the least one: what is over is a way on which no
/// line can come too near. That bounds the work whatever the separation is, in triangles.
constexpr double LookAhead = 1.25;

/// Own segments within this multiple of the least distance along the line are no obstacle to it.
constexpr double OwnArc = 4.0;

/// Of the separation, along a line.
constexpr double CandidateSpacing = 0.5;
constexpr double CoverSpacing = 0.25;

/// Of the separation: around a seed without a line of the minimum length none is tried again.
constexpr double FailureRadius = 0.25;

/// Of the first line.
constexpr std::size_t NumberOfTrials = 16;

constexpr int StepsPerReport = 256;
constexpr std::size_t TrianglesPerStep = 64;

WalkRule RuleOf(Color color)
{
  return color == Color::Blue ? WalkRule::Blue : WalkRule::Red;
}

/// Whether a multiple of the spacing lies between two arc lengths.
bool Passes(double from, double to, double spacing)
{
  return std::floor(from / spacing) != std::floor(to / spacing);
}

/// Puts the first on top of a heap.
struct ComesLater
{
  template <typename T>
  bool operator()(const T& a, const T& b) const
  {
    return b < a;
  }
};

Eigen::Vector3d Middle(const TracedSegment& segment)
{
  return 0.5 * (segment.start + segment.end);
}

} // namespace

bool PrincipalFoliation::Seed::operator<(const Seed& other) const
{
  if (this->parentLength != other.parentLength)
  {
    return this->parentLength > other.parentLength;
  }
  if (this->gap != other.gap)
  {
    return this->gap > other.gap;
  }
  return ComesBefore(this->position, other.position);
}

PrincipalFoliation::PrincipalFoliation(const TriangleMesh& mesh, const MongeField& field,
  const FoliationRule& rule, std::vector<std::uint8_t> closed)
  : Mesh_(mesh)
  , Field_(field)
  , Rule_(rule)
  , Closed_(std::move(closed))
  , Covered_(mesh.NumberOfTriangles(), 0)
  , Segments_(mesh)
  , Walk_(mesh, field, Closed_)
{
  this->Closed_.resize(mesh.NumberOfTriangles(), 0);
}

/// Large balls take longer than steps: the monitor is to hear as often.
void PrincipalFoliation::CountBall()
{
  this->UntilReport_ -= static_cast<int>(this->Segments_.Ball().Size() / TrianglesPerStep);
}

bool PrincipalFoliation::Report()
{
  if (--this->UntilReport_ < 0 && !this->Stopped_)
  {
    this->UntilReport_ = StepsPerReport;
    this->Stopped_ = !this->Monitor_(static_cast<double>(this->NumberOfCovered_) /
      std::max<Id>(1, this->Mesh_.NumberOfTriangles()));
  }
  return !this->Stopped_;
}

bool PrincipalFoliation::Trace(const Monitor& monitor)
{
  this->Monitor_ = monitor;
  this->UntilReport_ = 0;
  this->Stopped_ = false;
  const std::vector<Seed> seeds = this->SeedsInTriangles();
  this->TraceLongest(seeds);
  this->TraceCandidates();
  for (const Seed& seed : seeds)
  {
    if (this->Covered_[seed.triangle] || !this->IsFree(seed))
    {
      continue;
    }
    if (!this->TraceLine(seed))
    {
      this->CoverAround(seed.position, seed.triangle, FailureRadius * this->Rule_.separation);
    }
    this->TraceCandidates();
    if (!this->Report())
    {
      return false;
    }
  }
  return !this->Stopped_;
}

/// The longest line from seeds at some quantiles of k1 - k2.
void PrincipalFoliation::TraceLongest(const std::vector<Seed>& seeds)
{
  double greatest = 0.0;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < NumberOfTrials && !seeds.empty(); ++i)
  {
    const std::size_t trial = i * seeds.size() / NumberOfTrials;
    std::size_t middle = 0;
    bool closed = false;
    const double length = this->TraceSegments(seeds[trial], middle, closed);
    this->DropSegments(0);
    if (length > greatest)
    {
      greatest = length;
      longest = trial;
    }
  }
  if (greatest > 0.0)
  {
    this->TraceLine(seeds[longest]);
  }
}

void PrincipalFoliation::TraceCandidates()
{
  while (!this->Candidates_.empty() && this->Report())
  {
    std::pop_heap(this->Candidates_.begin(), this->Candidates_.end(), ComesLater{});
    const Seed candidate = this->Candidates_.back();
    this->Candidates_.pop_back();
    if (this->IsFree(candidate))
    {
      this->TraceLine(candidate);
    }
  }
}

/// The centroids of all triangles in which a line may start, in the order in which to try them.
std::vector<PrincipalFoliation::Seed> PrincipalFoliation::SeedsInTriangles()
{
  std::vector<Seed> seeds;
  for (Id t = 0; t < this->Mesh_.NumberOfTriangles() && this->Report(); ++t)
  {
    if (!this->Closed_[t] && !IsRegular(this->Mesh_, this->Field_, t))
    {
      this->Closed_[t] = 1;
    }
    const FlatTriangle face(this->Mesh_, this->Field_, t);
    if (this->Closed_[t] || face.IsDegenerate())
    {
      this->Covered_[t] = 1;
      ++this->NumberOfCovered_;
      continue;
    }
    const Eigen::Vector2d centroid = face.Centroid();
    seeds.push_back({ 0.0, face.Gap(centroid), face.ToSpace(centroid), t });
  }
  std::sort(seeds.begin(), seeds.end());
  return seeds;
}

bool PrincipalFoliation::IsFree(const Seed& seed)
{
  const bool isFree =
    this->Segments_.IsFree(seed.position, seed.triangle, SeedTolerance * this->Rule_.separation);
  this->CountBall();
  return isFree;
}

/// Adds the segments of the line through a seed, those of its second half from `middle` on; its
/// length.
double PrincipalFoliation::TraceSegments(const Seed& seed, std::size_t& middle, bool& closed)
{
  this->Seed_ = seed;
  this->Line_ = static_cast<Id>(this->Lines_.size());
  const std::size_t first = this->Segments_.Size();
  closed = this->TraceHalf(1.0, this->Rule_.maximumLength);
  middle = this->Segments_.Size();
  double length = middle > first ? this->Segments_.Last().arc : 0.0;
  if (!closed)
  {
    this->TraceHalf(-1.0, this->Rule_.maximumLength - length);
    length -= this->Segments_.Size() > middle ? this->Segments_.Last().arc : 0.0;
  }
  return length;
}

void PrincipalFoliation::DropSegments(std::size_t first)
{
  while (this->Segments_.Size() > first)
  {
    this->Segments_.Pop();
  }
}

bool PrincipalFoliation::TraceLine(const Seed& seed)
{
  const std::size_t first = this->Segments_.Size();
  std::size_t middle = first;
  bool closed = false;
  const double length = this->TraceSegments(seed, middle, closed);
  if (!(length > 0.0) || length < this->Rule_.minimumLength ||
    !this->StoreLine(first, middle, closed))
  {
    this->DropSegments(first);
    return false;
  }
  this->Cover(first);
  this->AddCandidates(first);
  return true;
}

/// From the seed to one side; true where the line came back to it.
bool PrincipalFoliation::TraceHalf(double sign, double longest)
{
  const FlatTriangle face(this->Mesh_, this->Field_, this->Seed_.triangle);
  this->SeedDirection_ =
    face.Direction(this->Rule_.color, face.ToFlat(this->Seed_.position), Eigen::Vector2d::Zero());
  const Eigen::Vector3d direction =
    face.ToSpace(this->SeedDirection_) - face.ToSpace(Eigen::Vector2d::Zero());
  this->Walk_.Start(RuleOf(this->Rule_.color), this->Seed_.triangle, this->Seed_.position,
    sign * this->SeedDirection_);

  const std::size_t first = this->Segments_.Size();
  double arc = 0.0;
  double nextLook = 0.0;
  while (arc < longest && this->Report())
  {
    const Eigen::Vector3d start = this->Walk_.Position();
    if (!this->Walk_.Step(this->Rule_.step))
    {
      break;
    }
    if (!(this->Walk_.StepLength() > 0.0))
    {
      continue;
    }
    arc += this->Walk_.StepLength();
    this->Segments_.Push({ start, this->Walk_.Position(),
      this->Walk_.Face().Curvature(this->Rule_.color, this->Walk_.FlatPosition()), sign * arc,
      this->Walk_.CurrentTriangle(), this->Line_ });
    if (sign > 0.0 && this->CloseAt(direction))
    {
      return true;
    }
    if (arc >= nextLook)
    {
      const double least = this->Rule_.leastDistance;
      const double distance = this->DistanceToLines(LookAhead * least, { sign * arc, sign > 0.0 });
      if (distance < least)
      {
        this->Segments_.Pop();
        break;
      }
      nextLook = arc + (distance - least);
    }
  }
  if (sign > 0.0)
  {
    while (this->Segments_.Size() > first &&
      this->DistanceToLines(this->Rule_.leastDistance, { this->Segments_.Last().arc, false }) <
        this->Rule_.leastDistance)
    {
      this->Segments_.Pop();
    }
  }
  return false;
}

/// Ends the line at its seed, if the last segment passes it.
bool PrincipalFoliation::CloseAt(const Eigen::Vector3d& direction)
{
  const TracedSegment& last = this->Segments_.Last();
  const double before = (last.start - this->Seed_.position).dot(direction);
  const double after = (last.end - this->Seed_.position).dot(direction);
  if (!(before < 0.0 && after >= 0.0))
  {
    return false;
  }
  const Eigen::Vector3d passed = last.start + before / (before - after) * (last.end - last.start);
  const Eigen::Vector3d step = last.end - last.start;
  if ((passed - this->Seed_.position).norm() > this->Rule_.closingDistance ||
    step.dot(direction) < 0.5 * step.norm())
  {
    return false;
  }
  const FlatTriangle face(this->Mesh_, this->Field_, this->Seed_.triangle);
  this->Segments_.SetLastEnd(
    this->Seed_.position, face.Curvature(this->Rule_.color, face.ToFlat(this->Seed_.position)));
  return true;
}

/// From the end of the last segment.
double PrincipalFoliation::DistanceToLines(double radius, const OwnRange& own)
{
  const TracedSegment& last = this->Segments_.Last();
  const double ignored = OwnArc * this->Rule_.leastDistance;
  const double distance = this->Segments_.Distance(last.end, last.triangle, radius,
    [this, &own, &ignored](const TracedSegment& segment)
    {
      return segment.line != this->Line_ ||
        (std::abs(segment.arc - own.arc) > ignored &&
          !(own.ignoreSeed && std::abs(segment.arc) < ignored));
    });
  this->CountBall();
  return distance;
}

/// Unless it has a single point.
bool PrincipalFoliation::StoreLine(std::size_t first, std::size_t middle, bool closed)
{
  CurvatureLine line;
  line.closed = closed;
  const auto add = [&line](const Eigen::Vector3d& point, double curvature)
  {
    // A step from a seed on an edge to that edge is round-off.
    constexpr double roundOff = 1e-15;
    if (line.points.empty() || (point - line.points.back()).norm() > roundOff * point.norm())
    {
      line.points.push_back(point);
      line.curvatures.push_back(curvature);
    }
  };
  for (std::size_t i = this->Segments_.Size(); i-- > middle;)
  {
    add(this->Segments_[i].end, this->Segments_[i].curvature);
  }
  const FlatTriangle face(this->Mesh_, this->Field_, this->Seed_.triangle);
  add(this->Seed_.position, face.Curvature(this->Rule_.color, face.ToFlat(this->Seed_.position)));
  for (std::size_t i = first; i < middle; ++i)
  {
    add(this->Segments_[i].end, this->Segments_[i].curvature);
  }
  if (line.points.size() < (closed ? 3 : 2))
  {
    return false;
  }
  for (std::size_t i = 1; i < line.points.size(); ++i)
  {
    line.length += (line.points[i] - line.points[i - 1]).norm();
  }
  if (closed)
  {
    line.points.pop_back();
    line.curvatures.pop_back();
  }
  this->Lines_.push_back(std::move(line));
  return true;
}

/// Seeds at the separation on both sides of the line.
void PrincipalFoliation::AddCandidates(std::size_t first)
{
  const double separation = this->Rule_.separation;
  double arcBefore = 0.0;
  for (std::size_t i = first; i < this->Segments_.Size() && this->Report(); ++i)
  {
    const TracedSegment segment = this->Segments_[i];
    const double from = (segment.arc > 0.0) == (arcBefore >= 0.0) ? arcBefore : 0.0;
    arcBefore = segment.arc;
    if (i != first && !Passes(from, segment.arc, CandidateSpacing * separation))
    {
      continue;
    }
    const FlatTriangle face(this->Mesh_, this->Field_, segment.triangle);
    const Eigen::Vector2d along =
      (face.ToFlat(segment.end) - face.ToFlat(segment.start)).stableNormalized();
    const Eigen::Vector3d foot = Middle(segment);
    for (const double side : { 1.0, -1.0 })
    {
      this->Walk_.Start(
        WalkRule::Straight, segment.triangle, foot, side * Eigen::Vector2d(-along[1], along[0]));
      double way = 0.0;
      double distance = 0.0;
      // A bend of the surface shortens the distance, but there are folds that it never leaves.
      while (distance < separation && way < 1.5 * separation &&
        this->Walk_.Step(std::min(this->Rule_.step, 0.8 * (separation - distance))))
      {
        way += this->Walk_.StepLength();
        distance = (this->Walk_.Position() - foot).norm();
        if (distance > 0.99 * separation)
        {
          break;
        }
      }
      if (distance > SeedTolerance * separation)
      {
        this->Candidates_.push_back(
          { this->Lines_.back().length, this->Walk_.Face().Gap(this->Walk_.FlatPosition()),
            this->Walk_.Position(), this->Walk_.CurrentTriangle() });
        std::push_heap(this->Candidates_.begin(), this->Candidates_.end(), ComesLater{});
      }
    }
  }
}

/// Notes what is nearer to the line than the separation.
void PrincipalFoliation::Cover(std::size_t first)
{
  double arcBefore = 0.0;
  for (std::size_t i = first; i < this->Segments_.Size() && this->Report(); ++i)
  {
    const TracedSegment& segment = this->Segments_[i];
    if (i == first || Passes(arcBefore, segment.arc, CoverSpacing * this->Rule_.separation))
    {
      this->CoverAround(Middle(segment), segment.triangle, this->Rule_.separation);
    }
    arcBefore = segment.arc;
  }
}

void PrincipalFoliation::CoverAround(const Eigen::Vector3d& center, Id triangle, double radius)
{
  const double square = radius * radius;
  this->Segments_.Ball().Visit(center, triangle, square,
    [this, &triangle, &center, &square](Id t)
    {
      const bool isNear =
        t == triangle || (this->Mesh_.Centroid(t) - center).squaredNorm() < square;
      if (isNear && !this->Covered_[t])
      {
        this->Covered_[t] = 1;
        ++this->NumberOfCovered_;
      }
      return square;
    });
  this->CountBall();
}

} // namespace ridges
