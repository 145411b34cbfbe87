// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certification/EdgeCertificate.h"

#include "Formula/ImplicitHeight.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ridges
{
namespace
{

constexpr int MostParts = 400;
constexpr int Deepest = 24;

/// Weights of a point of the edge.
Eigen::Vector3d At(double t)
{
  return { 1.0 - t, t, 0.0 };
}

/// The sign of a colour's extremality along a part, or of its derivative.
struct ColorState
{
  int sign = 0;  ///< Of the value; 0 if it may vanish.
  int slope = 0; ///< Of the derivative, where the value may vanish.
};

struct EdgePart
{
  double begin;
  double end;
  Eigen::Vector3d d1;
  std::array<ColorState, 2> color;
};

class EdgeSearch
{
public:
  EdgeSearch(const SurfaceBounds& surface, const MappedTriangle& whole)
    : Surface_(surface)
    , Whole_(whole)
  {
  }

  /// Parts that are understood, in order; false if some are not. Without ridges, all that matters
  /// is that d1 is continuous.
  bool Split(EdgeCertificate& result, bool looksAtRidges)
  {
    this->Parts_.clear();
    struct Task
    {
      double begin;
      double end;
      double height;
      int depth;
    };
    std::vector<Task> tasks{ { 0.0, 1.0, 0.0, 0 } };
    int count = 0;
    while (!tasks.empty())
    {
      const Task task = tasks.back();
      tasks.pop_back();
      const PartBounds bounds = BoundPart(
        this->Surface_, this->Whole_, { { At(task.begin), At(task.end), {} }, 2 }, task.height);
      EdgePart part{ task.begin, task.end, bounds.frame.col(0), {} };
      if (IsUnderstood(bounds, part, looksAtRidges))
      {
        this->Parts_.push_back(part);
        continue;
      }
      if (++count >= MostParts || task.depth >= Deepest)
      {
        result.failed |= this->Reason(bounds, task.begin, task.end);
        result.place = bounds.center;
        return false;
      }
      const double middle = 0.5 * (task.begin + task.end);
      const double height = std::isfinite(bounds.height) ? bounds.height : 0.0;
      tasks.push_back({ middle, task.end, height, task.depth + 1 });
      tasks.push_back({ task.begin, middle, height, task.depth + 1 });
    }
    return true;
  }

  /// Turns all parts so that d1 is continuous, from a direction at the beginning. Returns that at
  /// the end.
  Eigen::Vector3d Orient(const Eigen::Vector3d& first)
  {
    Eigen::Vector3d d1 = first;
    for (EdgePart& part : this->Parts_)
    {
      if (part.d1.dot(d1) < 0.0)
      {
        part.d1 = -part.d1;
        for (ColorState& color : part.color)
        {
          color.sign = -color.sign;
          color.slope = -color.slope;
        }
      }
      d1 = part.d1;
    }
    return d1;
  }

  /// The crossings of a colour, between signs that are known.
  void Count(int color, EdgeCertificate& result)
  {
    std::vector<EdgePart>& parts = this->Parts_;
    int& crossings = result.crossings[color];
    std::size_t i = 0;
    while (i < parts.size())
    {
      if (parts[i].color[color].sign != 0)
      {
        ++i;
        continue;
      }
      std::size_t end = i;
      const int slope = parts[i].color[color].slope;
      while (end < parts.size() && parts[end].color[color].sign == 0)
      {
        if (parts[end].color[color].slope != slope)
        {
          this->Fail(result, color, TransversalCrossings, parts[end].begin);
          return;
        }
        ++end;
      }
      const int before = i > 0 ? parts[i - 1].color[color].sign : this->SignAtEnd(color, 0);
      const int after =
        end < parts.size() ? parts[end].color[color].sign : this->SignAtEnd(color, 1);
      if (before == 0 || after == 0)
      {
        this->Fail(result, color, NoRidgeThroughVertex, before == 0 ? 0.0 : 1.0);
        return;
      }
      if (before != after)
      {
        ++crossings;
        this->Locate(color, parts[i], parts[end - 1].end, before, result);
      }
      i = end;
    }
  }

  bool HasRightAngle(const std::array<Eigen::Vector3d, 2>& d1) const
  {
    // Exact directions are off by the round-off of forms only.
    return std::abs(d1[0].dot(d1[1])) < 1e-9;
  }

private:
  static bool IsUnderstood(const PartBounds& bounds, EdgePart& part, bool looksAtRidges)
  {
    if (!bounds.hasGap || !bounds.isNarrow)
    {
      return false;
    }
    for (int color = 0; color < 2; ++color)
    {
      part.color[color].sign = SignOf(bounds.extremality[color].value);
      part.color[color].slope = SignOf(bounds.extremality[color].slope[0]);
      if (looksAtRidges && part.color[color].sign == 0 && part.color[color].slope == 0)
      {
        return false;
      }
    }
    return true;
  }

  std::uint16_t Reason(const PartBounds& bounds, double begin, double end) const
  {
    if (!bounds.isMapped)
    {
      return MeshFollowsSurface;
    }
    if (!bounds.hasGap || !bounds.isNarrow)
    {
      return NoUmbilicOnEdge;
    }
    return begin == 0.0 || end == 1.0 ? NoRidgeThroughVertex | TransversalCrossings
                                      : TransversalCrossings;
  }

  void Fail(EdgeCertificate& result, int color, std::uint16_t hypothesis, double t) const
  {
    result.failed |= hypothesis | OneCrossing;
    result.crossings[color] = -1;
    result.place = this->Whole_.Position(At(t));
  }

  /// Of a vertex, turned as the part next to it.
  int SignAtEnd(int color, int end) const
  {
    const Eigen::Vector3d weights = At(end);
    const PartBounds bounds =
      BoundPart(this->Surface_, this->Whole_, { { weights, {}, {} }, 1 }, 0.0);
    if (!bounds.hasGap || !bounds.isNarrow)
    {
      return 0;
    }
    const Eigen::Vector3d& d1 = end == 0 ? this->Parts_.front().d1 : this->Parts_.back().d1;
    const int turn = bounds.frame.col(0).dot(d1) < 0.0 ? -1 : 1;
    return turn * SignOf(bounds.extremality[color].value);
  }

  /// The extremality at a point of the edge, with d1 turned towards another direction.
  double Extremality(
    int color, double t, const Eigen::Vector3d& d1, double& height, Eigen::Vector3d& position) const
  {
    const Eigen::Vector3d normal = this->Whole_.Normal(At(t));
    const Eigen::Vector3d flat = this->Whole_.Position(At(t));
    height = HeightAlong(this->Surface_, flat, normal, height);
    position = flat + height * normal;
    return ExtremalityAt(this->Surface_, position, color, d1);
  }

  /// Bisection, as the sign changes just once.
  void Locate(
    int color, const EdgePart& first, double end, int signBefore, EdgeCertificate& result) const
  {
    double low = first.begin;
    double high = end;
    double height = 0.0;
    Eigen::Vector3d d1 = first.d1;
    for (int step = 0; step < 60 && high - low > 1e-15; ++step)
    {
      const double middle = 0.5 * (low + high);
      const double b = this->Extremality(color, middle, d1, height, result.position[color]);
      (b * signBefore > 0.0 ? low : high) = middle;
    }
    result.parameter[color] = 0.5 * (low + high);
    this->Extremality(color, result.parameter[color], d1, height, result.position[color]);
  }

  const SurfaceBounds& Surface_;
  const MappedTriangle& Whole_;
  std::vector<EdgePart> Parts_;
};

} // namespace

EdgeCertificate CertifyEdge(const SurfaceBounds& surface, const MappedTriangle& whole,
  const std::array<Eigen::Vector3d, 2>& d1, bool isDegenerate)
{
  EdgeCertificate result;
  result.place = whole.point[0];
  EdgeSearch search(surface, whole);
  result.failed = search.HasRightAngle(d1) ? NoRightAngle : 0;
  const bool areRidgesKnown = !isDegenerate && search.Split(result, true);
  if (!areRidgesKnown)
  {
    // What stopped the search says nothing about the parts that it did not come to.
    result.crossings = { -1, -1 };
    result.failed |= NoRidgeThroughVertex | TransversalCrossings | OneCrossing;
    if (!search.Split(result, false))
    {
      result.failed |= NoUmbilicOnEdge | CorrectOrientation;
      return result;
    }
  }
  const Eigen::Vector3d last = search.Orient(d1[0]);
  result.orientation = last.dot(d1[1]) < 0.0 ? -1 : 1;
  const int acute = d1[0].dot(d1[1]) < 0.0 ? -1 : 1;
  if (acute != result.orientation)
  {
    result.failed |= CorrectOrientation;
  }
  for (int color = 0; areRidgesKnown && color < 2; ++color)
  {
    search.Count(color, result);
    if (result.crossings[color] > 1)
    {
      result.failed |= OneCrossing;
      result.place = result.position[color];
    }
  }
  return result;
}

} // namespace ridges
