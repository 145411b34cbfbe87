// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesCheckText.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace
{

using ridges::CheckKind;
using ridges::CoherenceCheck;

template <typename... Values>
std::string Join(const Values&... values)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(3);
  (text << ... << values);
  return text.str();
}

/// Halves as such: "2", "-1/2".
std::string Halves(double value)
{
  const long twice = std::lround(2.0 * value);
  return twice % 2 == 0 ? Join(twice / 2) : Join(twice, "/2");
}

struct Heading
{
  const char* name;
  const char* section;
  const char* expected;
};

Heading HeadingOf(CheckKind kind)
{
  switch (kind)
  {
    case CheckKind::IndexSum:
      return { "index sum", "8.2", "Euler characteristic" };
    case CheckKind::UmbilicsPerTriangle:
      return { "umbilics per triangle", "5.2.1, D1", "at most 1" };
    case CheckKind::RidgesAtUmbilics:
      return { "ridges at umbilics", "3", "1 or 3 ridges of each colour, by RidgeCount" };
    case CheckKind::TypesAtUmbilics:
      return { "types at umbilics", "3", "hyperbolic" };
    case CheckKind::RidgeEnds:
      return { "ridge ends", "definition 4", "loops, or ended at umbilics or borders" };
    case CheckKind::TurningPoints:
      return { "turning points", "3", "even number on each loop and between umbilics" };
    case CheckKind::Intersections:
      return { "intersections", "3", "none among ridges of one colour" };
    case CheckKind::Patches:
      return { "patches", "6.3, 2.2(a)", "a disk around each umbilic" };
    case CheckKind::RidgesInPatches:
      return { "ridges inside patches", "6.3, 2.2(b)", "none" };
    case CheckKind::PatchContours:
      return { "patch contours", "6.3, 2.2(c)", "1 or 3 crossings of each colour, by RidgeCount" };
    case CheckKind::RightAngles:
      return { "right angles", "5.2.1, S1", "cosine" };
    case CheckKind::DoubleCrossings:
      return { "double crossings", "6.3, 2.2(d)", "none by one colour outside patches" };
    case CheckKind::PointsOnEdges:
      return { "points on edges", "5.2.2", "at their parameters" };
    case CheckKind::Crossings:
      break;
  }
  return { "crossings", "5.2.2", "those of the acute rule" };
}

/// What a check has found, from its numbers.
struct Finding
{
  const CoherenceCheck& check;
  std::size_t offenders;

  std::string operator()(const ridges::IndexSums& sums) const
  {
    const bool isWhole = sums.closedParts == 1 && sums.parts == 1;
    return Halves(sums.index) +
      (isWhole ? "" : Join(" on ", sums.closedParts, " closed of ", sums.parts, " parts"));
  }

  std::string operator()(const ridges::RidgeCounts& counts) const
  {
    return Join(offenders, " of ", counts.umbilics,
             check.kind == CheckKind::RidgesAtUmbilics ? " umbilics have others" : " have others") +
      (check.Passed() ? ""
                      : Join(", the first ", counts.blue, " blue and ", counts.red,
                          " red instead of ", counts.expected));
  }

  std::string operator()(const ridges::EndCounts& counts) const
  {
    return Join(offenders, " of ", counts.ridges, " are neither, ", counts.loops,
      " loops, ends: ", counts.atUmbilics, " at umbilics, ", counts.atBorders, " at borders");
  }

  std::string operator()(const ridges::TurningCounts& counts) const
  {
    return Join(counts.turningPoints, " in all, ", offenders, " ridges of ", counts.ridges,
      " have an odd number, or others than their types have");
  }

  std::string operator()(const ridges::Cosines& cosines) const
  {
    return Join(cosines.least, " at least");
  }

  std::string operator()(const ridges::CrossingCounts& counts) const
  {
    return Join(counts.lost[0], " of ", counts.crossed[0], " blue, ", counts.lost[1], " of ",
      counts.crossed[1], " red lost; ", counts.smallLoops,
      " small loops, or parts of them, left out");
  }

  std::string operator()(std::size_t number) const
  {
    switch (check.kind)
    {
      case CheckKind::UmbilicsPerTriangle:
        return Join(number);
      case CheckKind::TypesAtUmbilics:
        return Join(offenders, " ridges are not, of ", number, " ends");
      case CheckKind::Intersections:
        return Join(offenders, " triangles with some");
      case CheckKind::Patches:
        return Join(number, " patches, ", offenders, " umbilics without such");
      case CheckKind::PointsOnEdges:
        return Join(offenders, " of ", number, " are elsewhere");
      default:
        return Join(offenders);
    }
  }
};

} // namespace

vtkRidgesCheckText::vtkRidgesCheckText(const CoherenceCheck& check)
{
  const Heading heading = HeadingOf(check.kind);
  this->name = heading.name;
  this->section = heading.section;
  this->expected = heading.expected;
  if (const auto* sums = std::get_if<ridges::IndexSums>(&check.numbers))
  {
    this->expected += Join(" ", sums->characteristic);
  }
  if (const auto* cosines = std::get_if<ridges::Cosines>(&check.numbers))
  {
    this->expected += Join(" ", cosines->expected, " or more");
  }
  this->found = std::visit(Finding{ check, check.offenders.size() }, check.numbers);
}
