// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certification/UmbilicRing.h"

#include <cmath>
#include <utility>
#include <vector>

namespace ridges
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

/// A ring around the umbilic, as triangles of the plane that cover it.
class RingSearch
{
public:
  RingSearch(const SurfaceBounds& surface, const UmbilicCertificate& umbilic)
    : Surface_(surface)
    , Axes_{ umbilic.frame.col(0), umbilic.frame.col(1) }
  {
    const Eigen::Vector3d& x = umbilic.position;
    this->Plane_ = { { x, x + this->Axes_[0], x + this->Axes_[1] },
      { umbilic.frame.col(2), umbilic.frame.col(2), umbilic.frame.col(2) } };
  }

  /// Whether ridges cross all circles between two radii transversally, and there is no umbilic.
  bool IsCrossedTransversally(double inner, double outer)
  {
    constexpr int sides = 16;
    const double reach = outer / std::cos(Pi / sides);
    for (int i = 0; i < sides; ++i)
    {
      const auto corner = [](double radius, int side)
      {
        const double angle = 2.0 * Pi * side / sides;
        return Eigen::Vector2d(radius * std::cos(angle), radius * std::sin(angle));
      };
      if (!this->Covers({ corner(inner, i), corner(reach, i), corner(reach, i + 1) }, 0.0) ||
        !this->Covers({ corner(inner, i), corner(reach, i + 1), corner(inner, i + 1) }, 0.0))
      {
        return false;
      }
    }
    return true;
  }

private:
  using Flat = std::array<Eigen::Vector2d, 3>;

  bool Covers(const Flat& first, double height)
  {
    constexpr int most = 200;
    std::vector<std::pair<Flat, double>> tasks{ { first, height } };
    int count = 0;
    while (!tasks.empty())
    {
      const auto [flat, guess] = tasks.back();
      tasks.pop_back();
      double found = guess;
      if (this->IsTransversal(flat, found))
      {
        continue;
      }
      if (++count > most)
      {
        return false;
      }
      for (const Flat& quarter : Quarters(flat))
      {
        tasks.emplace_back(quarter, found);
      }
    }
    return true;
  }

  bool IsTransversal(const Flat& flat, double& height) const
  {
    Part part{ {}, 3 };
    std::array<Interval, 2> place;
    for (int i = 0; i < 3; ++i)
    {
      part.corner[i] = { 1.0 - flat[i][0] - flat[i][1], flat[i][0], flat[i][1] };
      for (int axis = 0; axis < 2; ++axis)
      {
        const Interval at(flat[i][axis]);
        place[axis] = i == 0 ? at : boost::numeric::hull(place[axis], at);
      }
    }
    const PartBounds bounds = BoundPart(this->Surface_, this->Plane_, part, height);
    height = std::isfinite(bounds.height) ? bounds.height : height;
    if (!bounds.hasGap || !bounds.isNarrow)
    {
      return false;
    }
    for (const ExtremalityBounds& extremality : bounds.extremality)
    {
      const Interval turning = place[0] * extremality.slope[1] - place[1] * extremality.slope[0];
      if (!HasSign(extremality.value) && !HasSign(turning))
      {
        return false;
      }
    }
    return true;
  }

  const SurfaceBounds& Surface_;
  std::array<Eigen::Vector3d, 2> Axes_;
  MappedTriangle Plane_;
};

} // namespace

bool IsCrossedTransversally(
  const SurfaceBounds& surface, const UmbilicCertificate& umbilic, double inner, double outer)
{
  return RingSearch(surface, umbilic).IsCrossedTransversally(inner, outer);
}

} // namespace ridges
