// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certification/UmbilicSectors.h"

#include <cmath>
#include <utility>
#include <vector>

namespace ridges
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

/// A value and its derivative by the angle.
using Dual = Series2<1, Interval>;

Dual DualOf(const Interval& value, const Interval& slope)
{
  Dual result(value);
  result(1, 0) = slope;
  return result;
}

/// What is known of the disk.
struct Disk
{
  Interval radius; ///< 0 to its radius.
  GraphSeries<1, Interval> graph;
  CubicSeries<Interval> cubic;
  std::array<Series2<2, Interval>, 2> anisotropy;

  Disk(double r, const Series2<4, Interval>& height)
    : radius(0.0, r)
    , graph(height)
    , cubic(height)
    , anisotropy(GraphSeries<2, Interval>(height).Anisotropy())
  {
  }
};

struct Sector
{
  double d1 = 0.0;            ///< Angle of d1 at its middle, in the frame.
  std::array<int, 2> sign{};  ///< Of the extremality; 0 if it may vanish
  std::array<int, 2> slope{}; ///< By the angle.
};

/// The anisotropy divided by the radius.
std::array<Dual, 2> AnisotropyByRadius(
  const Disk& disk, const std::array<Interval, 2>& e, const std::array<Interval, 2>& turned)
{
  std::array<Dual, 2> result;
  for (int i = 0; i < 2; ++i)
  {
    const Series2<2, Interval>& w = disk.anisotropy[i];
    const Interval value = w.U() * e[0] + w.V() * e[1];
    // Averages of what lies between the umbilic and the point.
    const Interval bend = Interval(2.0) * w(2, 0) * turned[0] * e[0] +
      w(1, 1) * (turned[0] * e[1] + turned[1] * e[0]) + Interval(2.0) * w(0, 2) * turned[1] * e[1];
    const Interval slope =
      w.U() * turned[0] + w.V() * turned[1] + Interval(0.5) * disk.radius * bend;
    result[i] = DualOf(value, slope);
  }
  return result;
}

/// What a sector of the disk says; false if it must be divided.
bool Examine(const Disk& disk, double begin, double end, Sector& sector)
{
  const Interval angle(begin, end);
  const std::array<Interval, 2> e{ cos(angle), sin(angle) };
  const std::array<Interval, 2> turned{ -e[1], e[0] };
  const auto onCircle = [&disk, &turned](const Series2<1, Interval>& a)
  { return DualOf(a.Constant(), disk.radius * (a.U() * turned[0] + a.V() * turned[1])); };
  const std::array<Dual, 2> w = AnisotropyByRadius(disk, e, turned);
  const double half = 0.5 *
    std::atan2(boost::numeric::median(w[1].Constant()), boost::numeric::median(w[0].Constant()));
  // Turned so that d1 is near the first axis at the middle.
  const Interval c(std::cos(2.0 * half));
  const Interval s(std::sin(2.0 * half));
  const Dual along = c * w[0] + s * w[1];
  const Dual across = c * w[1] - s * w[0];
  if (!IsPositive(along.Constant()))
  {
    return false;
  }
  const Dual first = along + Root(along * along + across * across);
  if (!(Magnitude(across.Constant() / first.Constant()) < 0.5))
  {
    return false;
  }
  const Interval ch(std::cos(half));
  const Interval sh(std::sin(half));
  const Dual d0 = ch * first - sh * across;
  const Dual d1 = sh * first + ch * across;
  sector.d1 = half;
  const auto& graph = disk.graph;
  const std::array<Dual, 2> slope{ onCircle(graph.slope[0]), onCircle(graph.slope[1]) };
  const std::array<Dual, 3> second{ onCircle(graph.second[0]), onCircle(graph.second[1]),
    onCircle(graph.second[2]) };
  const std::array<Dual, 4> third{ onCircle(disk.cubic.third[0]), onCircle(disk.cubic.third[1]),
    onCircle(disk.cubic.third[2]), onCircle(disk.cubic.third[3]) };
  const std::array<Dual, 3> T{ onCircle(graph.T[0]), onCircle(graph.T[1]), onCircle(graph.T[2]) };
  for (int color = 0; color < 2; ++color)
  {
    const std::array<Dual, 2> d =
      color == 0 ? std::array<Dual, 2>{ d0, d1 } : std::array<Dual, 2>{ -d1, d0 };
    const Dual b = ExtremalityAlong(slope, second, third, onCircle(graph.squaredArea), T, d);
    sector.sign[color] = SignOf(b.Constant());
    sector.slope[color] = SignOf(b.U());
    if (sector.sign[color] == 0 && sector.slope[color] == 0)
    {
      return false;
    }
  }
  return true;
}

/// All sectors in order; empty if some are not understood.
std::vector<Sector> Sectors(const Disk& disk)
{
  constexpr int atFirst = 16;
  constexpr int most = 4000;
  std::vector<std::pair<double, double>> tasks;
  for (int i = atFirst - 1; i >= 0; --i)
  {
    tasks.emplace_back(2.0 * Pi * i / atFirst, 2.0 * Pi * (i + 1) / atFirst);
  }
  std::vector<Sector> sectors;
  int count = 0;
  while (!tasks.empty())
  {
    const auto [begin, end] = tasks.back();
    tasks.pop_back();
    Sector sector;
    if (Examine(disk, begin, end, sector))
    {
      sectors.push_back(sector);
      continue;
    }
    if (++count > most || end - begin < 1e-5)
    {
      return {};
    }
    tasks.emplace_back(0.5 * (begin + end), end);
    tasks.emplace_back(begin, 0.5 * (begin + end));
  }
  return sectors;
}

/// Turns each sector's d1 to the one before; true if d1 comes back to itself after one turn.
bool Orient(std::vector<Sector>& sectors)
{
  const auto agree = [](double a, double b) { return std::cos(a - b) >= 0.0; };
  for (std::size_t i = 1; i < sectors.size(); ++i)
  {
    if (!agree(sectors[i].d1, sectors[i - 1].d1))
    {
      sectors[i].d1 += Pi;
      for (int color = 0; color < 2; ++color)
      {
        sectors[i].sign[color] = -sectors[i].sign[color];
        sectors[i].slope[color] = -sectors[i].slope[color];
      }
    }
  }
  return agree(sectors.front().d1, sectors.back().d1);
}

/// Changes of sign of a colour around the umbilic, where d1 returns reversed; -1 if a run of
/// sectors without a sign does not have one slope.
int CountZeros(const std::vector<Sector>& sectors, int color)
{
  const std::size_t n = sectors.size();
  std::size_t first = 0;
  while (first < n && sectors[first].sign[color] == 0)
  {
    ++first;
  }
  if (first == n)
  {
    return -1;
  }
  int zeros = 0;
  int sign = sectors[first].sign[color];
  int slope = 0;
  for (std::size_t i = 1; i <= n; ++i)
  {
    const std::size_t at = (first + i) % n;
    const int turn = first + i >= n ? -1 : 1;
    const int here = turn * sectors[at].sign[color];
    const int slopeHere = turn * sectors[at].slope[color];
    if (here == 0)
    {
      if (slope != 0 && slope != slopeHere)
      {
        return -1;
      }
      slope = slopeHere;
      continue;
    }
    zeros += here != sign ? 1 : 0;
    sign = here;
    slope = 0;
  }
  return zeros;
}

} // namespace

std::optional<std::array<int, 2>> RidgesAroundUmbilic(
  double radius, const Series2<4, Interval>& height)
{
  const Disk disk(radius, height);
  std::vector<Sector> sectors = Sectors(disk);
  if (sectors.empty() || Orient(sectors))
  {
    return std::nullopt;
  }
  std::array<int, 2> ridgeCount{};
  for (int color = 0; color < 2; ++color)
  {
    ridgeCount[color] = CountZeros(sectors, color);
    if (ridgeCount[color] < 0)
    {
      return std::nullopt;
    }
  }
  return ridgeCount;
}

} // namespace ridges
