// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WaveSurface.h"

#include "ParallelFor.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>

namespace ridges
{
namespace testing
{

using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace
{

const double Pi = 3.14159265358979323846;

// By how much the second fundamental form is not a multiple of the first, in two numbers, and their
// derivatives by x and y; needs a jet of degree 3.
struct UmbilicEquations
{
  Vector2d value;
  Matrix2d derivative;
};

//------------------------------------------------------------------------------
UmbilicEquations EquationsOf(const HeightJet& z)
{
  const double p = z.Derivative(1, 0);
  const double q = z.Derivative(0, 1);
  const double r = z.Derivative(2, 0);
  const double s = z.Derivative(1, 1);
  const double t = z.Derivative(0, 2);
  UmbilicEquations result;
  result.value = { (1 + q * q) * r - (1 + p * p) * t, 2 * ((1 + p * p) * s - p * q * r) };
  for (int axis = 0; axis < 2; ++axis)
  {
    const double dp = axis == 0 ? r : s;
    const double dq = axis == 0 ? s : t;
    const double dr = z.Derivative(3 - axis, axis);
    const double ds = z.Derivative(2 - axis, 1 + axis);
    const double dt = z.Derivative(1 - axis, 2 + axis);
    result.derivative(0, axis) =
      (1 + q * q) * dr + 2 * q * dq * r - (1 + p * p) * dt - 2 * p * dp * t;
    result.derivative(1, axis) =
      2 * ((1 + p * p) * ds + 2 * p * dp * s - (dp * q + p * dq) * r - p * q * dr);
  }
  return result;
}

//------------------------------------------------------------------------------
// The covariant derivative of the second fundamental form in an orthonormal frame of the tangent
// plane: the third derivatives of the Monge form.
std::array<double, 4> ThirdOrderOf(const HeightJet& z)
{
  const Vector2d slope(z.Derivative(1, 0), z.Derivative(0, 1));
  const double w = std::sqrt(1 + slope.squaredNorm());
  Matrix2d second;
  second << z.Derivative(2, 0), z.Derivative(1, 1), z.Derivative(1, 1), z.Derivative(0, 2);
  double tensor[2][2][2];
  for (int i = 0; i < 2; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      for (int k = 0; k < 2; ++k)
      {
        const int ofY = i + j + k;
        const double turn = slope.dot(second.col(k)) * second(i, j) +
          slope.dot(second.col(j)) * second(k, i) + slope.dot(second.col(i)) * second(k, j);
        tensor[i][j][k] = z.Derivative(3 - ofY, ofY) / w - turn / (w * w * w);
      }
    }
  }
  // Columns: two tangent vectors in the coordinates x and y, orthonormal on the surface.
  Matrix2d frame;
  const double first = std::sqrt(1 + slope[0] * slope[0]);
  frame << 1 / first, -slope[0] * slope[1] / (first * w), 0, first / w;
  std::array<double, 4> b{};
  for (int n = 0; n < 4; ++n)
  {
    for (int ijk = 0; ijk < 8; ++ijk)
    {
      const int i = ijk & 1;
      const int j = ijk >> 1 & 1;
      const int k = ijk >> 2;
      b[n] += tensor[i][j][k] * frame(i, n > 0 ? 1 : 0) * frame(j, n > 1 ? 1 : 0) *
        frame(k, n > 2 ? 1 : 0);
    }
  }
  return b;
}

//------------------------------------------------------------------------------
double AngleBetween(const Vector2d& from, const Vector2d& to)
{
  return std::atan2(from[0] * to[1] - from[1] * to[0], from.dot(to));
}

//------------------------------------------------------------------------------
// Whether directions turn around a square, seen at many points of its sides: between its corners
// alone they may turn by more than half a turn.
bool TurnsAround(const WaveSurface& surface, const Vector2d& corner, double size)
{
  constexpr int pieces = 32; // of a side
  const Vector2d sides[4] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
  Vector2d point = corner;
  Vector2d from = EquationsOf(surface.Derivatives(point[0], point[1], 3)).value;
  double turned = 0.0;
  for (const Vector2d& side : sides)
  {
    for (int i = 0; i < pieces; ++i)
    {
      point += size / pieces * side;
      const Vector2d to = EquationsOf(surface.Derivatives(point[0], point[1], 3)).value;
      turned += AngleBetween(from, to);
      from = to;
    }
  }
  return std::abs(turned) > Pi;
}

//------------------------------------------------------------------------------
ExactUmbilic UmbilicAt(const WaveSurface& surface, const Vector2d& point)
{
  const HeightJet z = surface.Derivatives(point[0], point[1], 3);
  const Eigen::Vector3d normal(-z.Derivative(1, 0), -z.Derivative(0, 1), 1.0);
  ExactUmbilic umbilic;
  umbilic.position = { point[0], point[1], z.Derivative(0, 0) };
  umbilic.normal = normal.normalized();
  umbilic.curvature = z.Derivative(2, 0) / ((1 + std::pow(z.Derivative(1, 0), 2)) * normal.norm());
  umbilic.b = ThirdOrderOf(z);
  umbilic.index = EquationsOf(z).derivative.determinant() > 0.0 ? 0.5 : -0.5;
  ClassifyByForm(umbilic);
  return umbilic;
}

} // namespace

//------------------------------------------------------------------------------
WaveSurface::WaveSurface(int numberOfWaves, double amplitude, std::uint64_t seed)
  : Scale(amplitude * std::sqrt(2.0 / numberOfWaves))
{
  std::mt19937_64 generator(seed);
  const double goldenSection = 0.5 * (std::sqrt(5.0) - 1);
  for (int i = 0; i < numberOfWaves; ++i)
  {
    const double length = std::sqrt(-2 * std::log(1 - (i + Uniform(generator)) / numberOfWaves));
    const double angle = 2 * Pi * goldenSection * i;
    this->Waves.push_back(
      { length * Vector2d(std::cos(angle), std::sin(angle)), 2 * Pi * Uniform(generator) });
  }
}

//------------------------------------------------------------------------------
double WaveSurface::Height(double x, double y) const
{
  double sum = 0.0;
  for (const Wave& wave : this->Waves)
  {
    sum += std::cos(wave.k[0] * x + wave.k[1] * y + wave.phase);
  }
  return this->Scale * sum;
}

//------------------------------------------------------------------------------
HeightJet WaveSurface::Derivatives(double x, double y, int degree) const
{
  HeightJet jet;
  for (const Wave& wave : this->Waves)
  {
    const double angle = wave.k[0] * x + wave.k[1] * y + wave.phase;
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    // By how much each further derivative turns the phase.
    const double turned[4] = { cosine, -sine, -cosine, sine };
    double powersOfX[HeightJet::MaximumDegree + 1] = { 1.0 };
    double powersOfY[HeightJet::MaximumDegree + 1] = { 1.0 };
    for (int d = 0; d <= degree; ++d)
    {
      if (d > 0)
      {
        powersOfX[d] = powersOfX[d - 1] * wave.k[0];
        powersOfY[d] = powersOfY[d - 1] * wave.k[1];
      }
      for (int j = 0; j <= d; ++j)
      {
        jet.derivatives[HeightJet::Index(d - j, j)] +=
          turned[d % 4] * powersOfX[d - j] * powersOfY[j];
      }
    }
  }
  for (double& derivative : jet.derivatives)
  {
    derivative *= this->Scale;
  }
  return jet;
}

//------------------------------------------------------------------------------
double WaveSurface::ExpectedDensity() const
{
  double fourth = 0.0;
  double sixth = 0.0;
  for (const Wave& wave : this->Waves)
  {
    fourth += std::pow(wave.k.squaredNorm(), 2);
    sixth += std::pow(wave.k.squaredNorm(), 3);
  }
  return sixth / (4 * Pi * fourth);
}

//------------------------------------------------------------------------------
bool ConvergeToUmbilic(const WaveSurface& surface, Vector2d& point)
{
  UmbilicEquations at = EquationsOf(surface.Derivatives(point[0], point[1], 3));
  for (int iteration = 0; iteration < 50; ++iteration)
  {
    Vector2d step = -at.derivative.fullPivLu().solve(at.value);
    if (!step.allFinite())
    {
      return false;
    }
    if (step.norm() < 1e-11)
    {
      return true;
    }
    step *= std::min(1.0, 0.3 / step.norm()); // of the correlation length
    bool smaller = false;
    for (int halving = 0; halving < 12 && !smaller; ++halving, step *= 0.5)
    {
      const Vector2d next = point + step;
      const UmbilicEquations there = EquationsOf(surface.Derivatives(next[0], next[1], 3));
      if (there.value.norm() < at.value.norm())
      {
        point = next;
        at = there;
        smaller = true;
      }
    }
    if (!smaller)
    {
      return step.norm() < 1e-10; // no better point can be represented
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::vector<ExactUmbilic> FindUmbilics(const WaveSurface& surface, double halfSize, double cell)
{
  // One row of cells more on each side, for umbilics that belong to a cell beyond the border.
  const int n = static_cast<int>(std::ceil(2 * halfSize / cell)) + 3;
  const auto place = [&](std::size_t p) -> Vector2d
  {
    return Vector2d(static_cast<double>(p % n), static_cast<double>(p / n)) * cell -
      Vector2d::Constant(halfSize + cell);
  };
  const auto count = static_cast<std::size_t>(n) * n;
  std::vector<UmbilicEquations> equations(count);
  ParallelFor(count,
    [&](std::size_t p)
    {
      const Vector2d at = place(p);
      equations[p] = EquationsOf(surface.Derivatives(at[0], at[1], 3));
    });

  std::vector<char> isSeed(count, 0);
  std::vector<std::size_t> turning; // cells, by their first corner
  for (std::size_t p = 0; p < count; ++p)
  {
    const Vector2d step = equations[p].derivative.fullPivLu().solve(equations[p].value);
    isSeed[p] = step.norm() < 1.5 * cell ? 1 : 0; // not so for NaN
    if (p % n + 1 < static_cast<std::size_t>(n) && p / n + 1 < static_cast<std::size_t>(n))
    {
      const std::size_t corners[5] = { p, p + 1, p + 1 + n, p + n, p };
      double turned = 0.0;
      for (int i = 0; i < 4; ++i)
      {
        turned += AngleBetween(equations[corners[i]].value, equations[corners[i + 1]].value);
      }
      if (std::abs(turned) > Pi)
      {
        turning.push_back(p);
        std::for_each(corners, corners + 4, [&isSeed](std::size_t c) { isSeed[c] = 1; });
      }
    }
  }

  // Of a close pair both may be far by prediction, as the derivative is nearly singular there.
  for (int i = 1; i + 1 < n; ++i)
  {
    for (int j = 1; j + 1 < n; ++j)
    {
      const int p = i * n + j;
      bool isLeast = true;
      const std::array<int, 9> around = { p - n - 1, p - n, p - n + 1, p - 1, p, p + 1, p + n - 1,
        p + n, p + n + 1 };
      for (const int q : around)
      {
        isLeast = isLeast && equations[p].value.norm() <= equations[q].value.norm();
      }
      for (const int q : around)
      {
        isSeed[q] = isSeed[q] || isLeast ? 1 : 0;
      }
    }
  }

  std::vector<Vector2d> ends(count);
  ParallelFor(count,
    [&](std::size_t p)
    {
      ends[p] = place(p);
      isSeed[p] = isSeed[p] && ConvergeToUmbilic(surface, ends[p]) ? 1 : 0;
    });

  // By cells, and so near to each other only in neighbouring ones.
  using Key = std::pair<int, int>;
  const auto keyOf = [cell](const Vector2d& point) -> Key
  {
    return { static_cast<int>(std::floor(point[0] / cell)),
      static_cast<int>(std::floor(point[1] / cell)) };
  };
  std::map<Key, std::vector<Vector2d>> known;
  const auto isNear = [&known, &keyOf](const Vector2d& point, double distance)
  {
    const Key key = keyOf(point);
    for (int i = -1; i <= 1; ++i)
    {
      for (int j = -1; j <= 1; ++j)
      {
        const auto found = known.find({ key.first + i, key.second + j });
        if (found != known.end() &&
          std::any_of(found->second.begin(), found->second.end(),
            [&](const Vector2d& other) { return (other - point).norm() < distance; }))
        {
          return true;
        }
      }
    }
    return false;
  };
  std::vector<ExactUmbilic> umbilics;
  for (std::size_t p = 0; p < count; ++p)
  {
    if (isSeed[p] && !isNear(ends[p], 1e-7))
    {
      known[keyOf(ends[p])].push_back(ends[p]);
      if (ends[p].cwiseAbs().maxCoeff() <= halfSize)
      {
        umbilics.push_back(UmbilicAt(surface, ends[p]));
      }
    }
  }
  for (const std::size_t p : turning)
  {
    if (!isNear(place(p) + Vector2d::Constant(0.5 * cell), cell) &&
      TurnsAround(surface, place(p), cell))
    {
      throw std::runtime_error("FindUmbilics: an umbilic of the waves was missed");
    }
  }
  std::sort(umbilics.begin(), umbilics.end(),
    [](const ExactUmbilic& a, const ExactUmbilic& b) { return a.position.x() < b.position.x(); });
  return umbilics;
}

} // namespace testing
} // namespace ridges
