// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EllipsoidRidges.h"

#include "AnalyticSurface.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace ridges
{
namespace testing
{

using Eigen::Vector3d;

namespace
{

const double Pi = 3.14159265358979323846;
using Function = std::function<double(double)>;

//------------------------------------------------------------------------------
struct RidgeSample
{
  bool maximum = false; // a ridge of k1, not of k2
  double k = 0.0;
  double P = 0.0;
  double secondDerivative = 0.0;
};

//------------------------------------------------------------------------------
class Ellipse
{
public:
  Ellipse(double a, double b, double c, int plane)
    : Axes{ a, b, c }
    , Plane(plane)
    , Surface(MakeEllipsoid(a, b, c))
  {
  }

  Vector3d Point(double t) const
  {
    Vector3d point = Vector3d::Zero();
    const int first = this->Plane == 0 ? 1 : 0;
    const int second = this->Plane == 2 ? 1 : 2;
    point[first] = this->Axes[first] * std::cos(t);
    point[second] = this->Axes[second] * std::sin(t);
    return point;
  }

  double Speed(double t) const
  {
    const double first = this->Axes[this->Plane == 0 ? 1 : 0];
    const double second = this->Axes[this->Plane == 2 ? 1 : 2];
    return std::hypot(first * std::sin(t), second * std::cos(t));
  }

  // The ellipse is fixed by a symmetry, so it is a ridge of the curvature across its plane.
  RidgeSample Sample(double t) const
  {
    const ExactMonge monge = this->Surface.Monge(this->Point(t));
    RidgeSample sample;
    sample.maximum = std::abs(monge.d1[this->Plane]) > std::abs(monge.d2[this->Plane]);
    sample.k = sample.maximum ? monge.k1 : monge.k2;
    sample.P = sample.maximum ? monge.P1 : monge.P2;
    sample.secondDerivative =
      sample.maximum ? monge.P1 / (monge.k1 - monge.k2) : monge.P2 / (monge.k2 - monge.k1);
    return sample;
  }

private:
  std::array<double, 3> Axes;
  int Plane;
  AnalyticSurface Surface;
};

//------------------------------------------------------------------------------
double Gauss8(const Function& f, double begin, double end)
{
  static const double nodes[4] = { 0.18343464249564980494, 0.52553240991632898582,
    0.79666647741362673959, 0.96028985649753623168 };
  static const double weights[4] = { 0.36268378337836198297, 0.31370664587788728734,
    0.22238103445337447054, 0.10122853629037625915 };
  const double middle = 0.5 * (begin + end);
  const double half = 0.5 * (end - begin);
  double sum = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    sum += weights[i] * (f(middle - half * nodes[i]) + f(middle + half * nodes[i]));
  }
  return half * sum;
}

//------------------------------------------------------------------------------
double Refine(
  const Function& f, double begin, double end, double whole, double tolerance, int depth)
{
  const double middle = 0.5 * (begin + end);
  const double left = Gauss8(f, begin, middle);
  const double right = Gauss8(f, middle, end);
  if (depth == 0 || std::abs(left + right - whole) <= tolerance)
  {
    return left + right;
  }
  return Refine(f, begin, middle, left, 0.5 * tolerance, depth - 1) +
    Refine(f, middle, end, right, 0.5 * tolerance, depth - 1);
}

//------------------------------------------------------------------------------
double Integrate(const Function& f, double begin, double end)
{
  const double whole = Gauss8(f, begin, end);
  return Refine(f, begin, end, whole, 1e-11 * std::abs(whole), 12);
}

//------------------------------------------------------------------------------
// A root of f between begin and end, where its signs differ.
double Bisect(const Function& f, double begin, double end)
{
  const bool positive = f(begin) > 0.0;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (begin + end);
    ((f(middle) > 0.0) == positive ? begin : end) = middle;
  }
  return 0.5 * (begin + end);
}

//------------------------------------------------------------------------------
// Parameters of the turning points strictly between begin and end. A fine enough sampling is
// assumed to separate them.
std::vector<double> TurningPoints(const Ellipse& ellipse, double begin, double end)
{
  const int samples = 400;
  const Function P = [&ellipse](double t) { return ellipse.Sample(t).P; };
  std::vector<double> found;
  // Half-steps keep clear of the ends, which may be umbilics.
  double previous = begin + 0.5 * (end - begin) / samples;
  for (int i = 1; i < samples; ++i)
  {
    const double next = begin + (i + 0.5) * (end - begin) / samples;
    if ((P(previous) > 0.0) != (P(next) > 0.0))
    {
      found.push_back(Bisect(P, previous, next));
    }
    previous = next;
  }
  return found;
}

//------------------------------------------------------------------------------
int TypeOf(const RidgeSample& sample)
{
  if (sample.maximum)
  {
    return sample.P < 0.0 ? MaximumElliptic : MaximumHyperbolic;
  }
  return sample.P < 0.0 ? MinimumElliptic : MinimumHyperbolic;
}

//------------------------------------------------------------------------------
// The parameter where the distance to the end of the arc is the cut-off.
double CutEnd(const Ellipse& ellipse, double end, double other, double distance)
{
  const Vector3d umbilic = ellipse.Point(end);
  const double middle = 0.5 * (end + other);
  const Function excess = [&](double t) { return (ellipse.Point(t) - umbilic).norm() - distance; };
  return excess(middle) <= 0.0 ? middle : Bisect(excess, end, middle);
}

} // namespace

//------------------------------------------------------------------------------
std::array<Vector3d, 4> EllipsoidUmbilics(double a, double b, double c)
{
  const double x = a * std::sqrt((a * a - b * b) / (a * a - c * c));
  const double z = c * std::sqrt((b * b - c * c) / (a * a - c * c));
  return { Vector3d(x, 0, z), Vector3d(-x, 0, z), Vector3d(-x, 0, -z), Vector3d(x, 0, -z) };
}

//------------------------------------------------------------------------------
Vector3d EllipsoidRidgePoint(double a, double b, double c, int plane, double t)
{
  return Ellipse(a, b, c, plane).Point(t);
}

//------------------------------------------------------------------------------
int EllipsoidRidgeTypeAt(double a, double b, double c, int plane, double t)
{
  return TypeOf(Ellipse(a, b, c, plane).Sample(t));
}

//------------------------------------------------------------------------------
std::vector<EllipsoidRidgePiece> EllipsoidRidgeIntegrals(
  double a, double b, double c, double cutoff)
{
  std::vector<EllipsoidRidgePiece> pieces;
  for (int plane = 0; plane < 3; ++plane)
  {
    const Ellipse ellipse(a, b, c, plane);

    // Cut at the umbilics, then at the turning points.
    std::vector<double> umbilics;
    if (plane == 1)
    {
      const double t = std::atan2(
        std::sqrt(b * b - c * c), std::sqrt(a * a - b * b)); // sin and cos of EllipsoidUmbilics
      umbilics = { -t, t, Pi - t, Pi + t, 2 * Pi - t };
    }
    std::vector<double> cuts = umbilics;
    if (umbilics.empty())
    {
      // A closed ridge. A start off the vertices, where P may be stationary.
      cuts = TurningPoints(ellipse, 0.1, 2 * Pi + 0.1);
      if (!cuts.empty())
      {
        cuts.push_back(cuts.front() + 2 * Pi);
      }
    }
    for (std::size_t i = 1; i < umbilics.size(); ++i)
    {
      const std::vector<double> turning = TurningPoints(ellipse, umbilics[i - 1], umbilics[i]);
      cuts.insert(cuts.end(), turning.begin(), turning.end());
    }
    std::sort(cuts.begin(), cuts.end());
    const bool closed = cuts.empty();
    if (closed)
    {
      cuts = { 0.0, 2 * Pi };
    }

    for (std::size_t i = 1; i < cuts.size(); ++i)
    {
      EllipsoidRidgePiece piece;
      piece.plane = plane;
      piece.begin = cuts[i - 1];
      piece.end = cuts[i];
      piece.closed = closed;
      piece.type = TypeOf(ellipse.Sample(0.5 * (piece.begin + piece.end)));
      const bool beginsAtUmbilic =
        std::find(umbilics.begin(), umbilics.end(), piece.begin) != umbilics.end();
      const bool endsAtUmbilic =
        std::find(umbilics.begin(), umbilics.end(), piece.end) != umbilics.end();
      piece.endsAtUmbilics = beginsAtUmbilic && endsAtUmbilic;

      piece.length = Integrate([&](double t) { return ellipse.Speed(t); }, piece.begin, piece.end);
      piece.strength =
        Integrate([&](double t) { return std::abs(ellipse.Sample(t).k) * ellipse.Speed(t); },
          piece.begin, piece.end);
      const double begin =
        beginsAtUmbilic ? CutEnd(ellipse, piece.begin, piece.end, cutoff * a) : piece.begin;
      const double end =
        endsAtUmbilic ? CutEnd(ellipse, piece.end, piece.begin, cutoff * a) : piece.end;
      piece.sharpness = a * a *
        Integrate([&](double t)
          { return std::abs(ellipse.Sample(t).secondDerivative) * ellipse.Speed(t); },
          begin, end);
      pieces.push_back(piece);
    }
  }
  return pieces;
}

} // namespace testing
} // namespace ridges
