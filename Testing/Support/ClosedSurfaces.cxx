// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ClosedSurfaces.h"

#include "RandomPolynomial.h"

#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>

namespace ridges
{
namespace testing
{

using Eigen::Vector3d;

namespace
{

//------------------------------------------------------------------------------
// About the distance to the torus around the z axis, negative inside.
template <typename Number>
Number TorusLevel(const Number& x, const Number& y, const Number& z, double R, double r)
{
  const Number h = x * x + y * y;
  const Number s = h + z * z + (R * R - r * r);
  return (s * s - 4 * R * R * h) / (8 * R * R * r);
}

//------------------------------------------------------------------------------
double Between(std::mt19937_64& generator, double from, double to)
{
  return from + (to - from) * Uniform(generator);
}

//------------------------------------------------------------------------------
// To be blended with others as the ellipsoids of MakeBlend are: 1 on an ellipsoid with random axes,
// moved a little at random, more inside and less outside.
class Bulge
{
public:
  Bulge(std::mt19937_64& generator, const Vector3d& center)
    : Center(center)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Center[i] += Between(generator, -0.15, 0.15);
      this->Axes[i] = Between(generator, 0.4, 0.7);
    }
  }

  template <typename Number>
  Number operator()(const Number& x, const Number& y, const Number& z) const
  {
    const Number u = (x - this->Center.x()) / this->Axes.x();
    const Number v = (y - this->Center.y()) / this->Axes.y();
    const Number w = (z - this->Center.z()) / this->Axes.z();
    return exp(-0.7 * (u * u + v * v + w * w - 1.0));
  }

private:
  Vector3d Center;
  Vector3d Axes;
};

} // namespace

//------------------------------------------------------------------------------
ClosedSurface PerturbedSphere(std::uint64_t seed)
{
  return { "sphere", MakePerturbedSphere(0.1, seed), Vector3d::Constant(1.4), 2 };
}

//------------------------------------------------------------------------------
ClosedSurface BulgedTorus(std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  std::vector<Bulge> bulges;
  for (int i = 0; i < 3; ++i)
  {
    const double angle = 2.0 * i + Between(generator, -0.3, 0.3);
    bulges.emplace_back(generator, Vector3d(1.2 * std::cos(angle), 1.2 * std::sin(angle), 0.0));
  }
  return { "torus",
    AnalyticSurface(
      [bulges](auto x, auto y, auto z)
      {
        auto sum = exp(-2.0 * TorusLevel(x, y, z, 1.2, 0.35));
        for (const Bulge& bulge : bulges)
        {
          sum += bulge(x, y, z);
        }
        return 1.0 - sum;
      }),
    Vector3d(2.4, 2.4, 1.2), 0 };
}

//------------------------------------------------------------------------------
ClosedSurface BulgedDoubleTorus(std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  const std::vector<Bulge> bulges = { { generator, Vector3d(0.0, 0.4, 0.1) },
    { generator, Vector3d(-2.0, -0.3, 0.0) }, { generator, Vector3d(1.5, -0.7, -0.3) } };
  return { "double torus",
    AnalyticSurface(
      [bulges](auto x, auto y, auto z)
      {
        // Both tori are bent and flattened, as k1 is all but constant around a round tube; the
        // second one is turned about the x axis.
        const auto u = 0.8 * y + 0.6 * z;
        const auto v = 0.8 * z - 0.6 * y;
        auto sum = exp(-3.0 *
                     TorusLevel(x + 1.15 + 0.15 * y * z, y + 0.1 * x * z,
                       0.7 * z + 0.12 * x * y + 0.1 * x * x, 0.95, 0.35)) +
          exp(-3.0 *
            TorusLevel(x - 1.05 - 0.15 * u * u, u + 0.12 * x * v,
              1.4 * v + 0.1 * x * u - 0.1 * u * u, 0.85, 0.4));
        for (const Bulge& bulge : bulges)
        {
          sum += bulge(x, y, z);
        }
        return 1.0 - sum;
      }),
    Vector3d(3.2, 2.0, 1.6), -2 };
}

//------------------------------------------------------------------------------
ClosedSurface Blob(std::uint64_t seed)
{
  const RandomPolynomial q(2, 4, seed);
  return { "blob",
    AnalyticSurface(
      [q](auto x, auto y, auto z)
      {
        const auto r = sqrt(x * x + y * y + z * z + 0.01); // smooth at the origin too
        return r - 1.0 - 0.15 * q(x / r, y / r, z / r);
      }),
    Vector3d::Constant(1.8), 2 };
}

//------------------------------------------------------------------------------
ClosedSurface Metaballs(std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  std::vector<Bulge> balls;
  Vector3d center(-1.0, -0.5, -0.2);
  for (int i = 0; i < 5; ++i)
  {
    balls.emplace_back(generator, center);
    // Near enough for one component. One after the other: compilers differ in the order of
    // arguments.
    const double z = Between(generator, -0.5, 0.6);
    const double y = Between(generator, -0.3, 0.8);
    const double x = Between(generator, 0.2, 0.8);
    center += Vector3d(x, y, z);
  }
  return { "metaballs",
    AnalyticSurface(
      [balls](auto x, auto y, auto z)
      {
        auto sum = x * 0.0;
        for (const Bulge& ball : balls)
        {
          sum += ball(x, y, z);
        }
        return 1.0 - sum;
      }),
    Vector3d(3.2, 2.5, 2.0), 2 };
}

//------------------------------------------------------------------------------
ClosedSurface ClosedSurfaceByName(const std::string& name)
{
  if (name == "ellipsoid")
  {
    return { name, MakeEllipsoid(1.0, 0.8, 0.6), Vector3d(1.05, 0.85, 0.65), 2 };
  }
  if (name == "blend")
  {
    return { name, MakeBlend(), Vector3d(0.45, 0.4, 0.5), 2 };
  }
  using Maker = ClosedSurface (*)(std::uint64_t);
  static const std::map<std::string, std::pair<Maker, std::uint64_t>> families = {
    { "sphere", { PerturbedSphere, 14 } }, { "torus", { BulgedTorus, 6 } },
    { "double torus", { BulgedDoubleTorus, 17 } }, { "blob", { Blob, 6 } },
    { "metaballs", { Metaballs, 11 } }
  };
  const std::size_t colon = name.find(':');
  const auto found = families.find(name.substr(0, colon));
  if (found == families.end())
  {
    throw std::invalid_argument("no surface is called " + name);
  }
  ClosedSurface closed = found->second.first(
    colon == std::string::npos ? found->second.second : std::stoull(name.substr(colon + 1)));
  closed.name = name;
  return closed;
}

//------------------------------------------------------------------------------
std::vector<ClosedSurface> GenericClosedSurfaces()
{
  std::vector<ClosedSurface> surfaces;
  for (const char* name : { "sphere", "torus", "double torus", "blob", "metaballs" })
  {
    surfaces.push_back(ClosedSurfaceByName(name));
  }
  return surfaces;
}

} // namespace testing
} // namespace ridges
