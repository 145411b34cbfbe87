// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RidgeComparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>
#include <utility>

namespace ridges
{
namespace testing
{

using Eigen::Vector3d;

namespace
{

const char* const Colors[2] = { "blue", "red" };
const char* const Types[5] = { "undecided", "blue ell", "green hyp", "red ell", "yellow hyp" };

} // namespace

//------------------------------------------------------------------------------
RidgeComparison::RidgeComparison(Truth truth, FoundPicture found, double edge)
  : True(std::move(truth))
  , Found(std::move(found))
  , Edge(edge)
  , OfFound(MeasureFound(this->True.ridges, this->Found.ridges, edge))
  , OfTrue(MeasureTrue(this->True.ridges, this->Found.ridges, edge))
{
  this->MatchUmbilics();
  this->MatchRidges();
}

//------------------------------------------------------------------------------
// The nearest pairs first, up to four edges.
void RidgeComparison::MatchUmbilics()
{
  this->FoundOfTrue.assign(this->True.umbilics.size(), -1);
  this->TrueOfFound.assign(this->Found.umbilics.size(), -1);
  std::vector<std::tuple<double, int, int>> pairs;
  for (std::size_t i = 0; i < this->FoundOfTrue.size(); ++i)
  {
    for (std::size_t j = 0; j < this->TrueOfFound.size(); ++j)
    {
      const double distance =
        (this->True.umbilics[i].position - this->Found.umbilics[j].position).norm();
      if (distance < 4.0 * this->Edge)
      {
        pairs.emplace_back(distance, static_cast<int>(i), static_cast<int>(j));
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [distance, i, j] : pairs)
  {
    if (this->FoundOfTrue[i] < 0 && this->TrueOfFound[j] < 0)
    {
      this->FoundOfTrue[i] = j;
      this->TrueOfFound[j] = i;
    }
  }
}

//------------------------------------------------------------------------------
// Numbers of true umbilics, -1 for an end that is at none, in ascending order.
std::vector<int> RidgeComparison::TrueEndsOf(const FoundRidge& ridge) const
{
  std::vector<int> ends;
  for (const FoundEnd& end : ridge.ends)
  {
    const bool known = end.umbilic >= 0 && end.umbilic < static_cast<int>(this->TrueOfFound.size());
    ends.push_back(known ? this->TrueOfFound[end.umbilic] : -1);
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

//------------------------------------------------------------------------------
std::string RidgeComparison::NameOfEnds(const std::vector<int>& ends) const
{
  if (ends.empty())
  {
    return "loop";
  }
  std::string name;
  for (const int end : ends)
  {
    name += (name.empty() ? "" : "-") + (end < 0 ? std::string("?") : std::to_string(end));
  }
  return name;
}

//------------------------------------------------------------------------------
void RidgeComparison::MatchRidges()
{
  char text[200];
  for (std::size_t r = 0; r < this->True.ridges.size(); ++r)
  {
    const TrueRidge& ridge = this->True.ridges[r];
    std::vector<int> expected;
    if (!ridge.closed)
    {
      expected.assign(ridge.umbilics.begin(), ridge.umbilics.end());
      std::sort(expected.begin(), expected.end());
    }
    std::string pieces;
    int count = 0;
    bool same = true;
    for (std::size_t f = 0; f < this->OfFound.ridges.size(); ++f)
    {
      if (this->OfFound.ridges[f] == static_cast<int>(r))
      {
        const std::vector<int> ends = this->TrueEndsOf(this->Found.ridges[f]);
        std::snprintf(text, sizeof text, " %s (%.1f)", this->NameOfEnds(ends).c_str(),
          LengthOf(this->Found.ridges[f]) / this->Edge);
        pieces += text;
        same = same && ends == expected;
        ++count;
      }
    }
    const double length = LengthOf(ridge.points);
    const bool missing = this->OfTrue.missing[r] > 0.5 * length;
    this->MissingRidges += missing ? 1 : 0;
    if (count == 1 && same && this->OfTrue.missing[r] < 0.05 * length)
    {
      ++this->WholeRidges;
      continue;
    }
    std::snprintf(text, sizeof text,
      "  %-4s %-7s length %7.1f, missing %6.1f, at %.3f %.3f %.3f; found:",
      Colors[ridge.maximum ? 0 : 1], this->NameOfEnds(expected).c_str(), length / this->Edge,
      this->OfTrue.missing[r] / this->Edge, ridge.points[ridge.points.size() / 2].x(),
      ridge.points[ridge.points.size() / 2].y(), ridge.points[ridge.points.size() / 2].z());
    this->RidgeFaults.push_back(text + (pieces.empty() ? std::string(" nothing") : pieces));
  }
  for (std::size_t f = 0; f < this->OfFound.ridges.size(); ++f)
  {
    if (this->OfFound.ridges[f] < 0)
    {
      ++this->SpuriousRidges;
      const FoundRidge& ridge = this->Found.ridges[f];
      const Vector3d& at = ridge.lines.front().points[ridge.lines.front().points.size() / 2];
      std::snprintf(text, sizeof text, "  %-4s %-7s length %7.1f, spurious, at %.3f %.3f %.3f",
        Colors[ridge.IsMaximum() ? 0 : 1], this->NameOfEnds(this->TrueEndsOf(ridge)).c_str(),
        LengthOf(ridge) / this->Edge, at.x(), at.y(), at.z());
      this->RidgeFaults.emplace_back(text);
    }
  }
}

//------------------------------------------------------------------------------
int RidgeComparison::EndsAt(int foundUmbilic, bool maximum) const
{
  int count = 0;
  for (const FoundRidge& ridge : this->Found.ridges)
  {
    for (const FoundEnd& end : ridge.ends)
    {
      count += ridge.IsMaximum() == maximum && end.umbilic == foundUmbilic ? 1 : 0;
    }
  }
  return count;
}

//------------------------------------------------------------------------------
void RidgeComparison::PrintTables(int eulerCharacteristic) const
{
  double indexSum = 0.0;
  for (const FoundUmbilic& umbilic : this->Found.umbilics)
  {
    indexSum += umbilic.index;
  }
  std::printf("\nUmbilics: %zu true, %zu found; index sum %g, Euler characteristic %d%s\n",
    this->True.umbilics.size(), this->Found.umbilics.size(), indexSum, eulerCharacteristic,
    indexSum == eulerCharacteristic ? "" : "  <-- WRONG");
  std::printf("  true       index  ridges       kind  ridge margin   next  | found distance  "
              "index  ridges  blue  red ends\n");
  const char* const kinds[3] = { "lemon", "monstar", "star" };
  for (std::size_t i = 0; i < this->True.umbilics.size(); ++i)
  {
    const ExactUmbilic& umbilic = this->True.umbilics[i];
    double next = 1e300;
    for (std::size_t j = 0; j < this->True.umbilics.size(); ++j)
    {
      const double distance = (umbilic.position - this->True.umbilics[j].position).norm();
      next = j == i ? next : std::min(next, distance / this->Edge);
    }
    std::printf("  %4zu       %+5.1f  %6d  %9s  %12.3f %6.1f  |", i, umbilic.index,
      umbilic.ridgeCount, kinds[static_cast<int>(umbilic.kind)], umbilic.ridgeMargin, next);
    const int j = this->FoundOfTrue[i];
    if (j < 0)
    {
      std::printf(" MISSING at %.4f %.4f %.4f\n", umbilic.position.x(), umbilic.position.y(),
        umbilic.position.z());
      continue;
    }
    const FoundUmbilic& found = this->Found.umbilics[j];
    const int blue = this->EndsAt(j, true);
    const int red = this->EndsAt(j, false);
    const bool right = found.index == umbilic.index && found.ridgeCount == umbilic.ridgeCount &&
      blue == umbilic.ridgeCount && red == umbilic.ridgeCount;
    std::printf(" %5d %8.3f  %+5.1f  %6d  %4d %4d%s\n", j,
      (found.position - umbilic.position).norm() / this->Edge, found.index, found.ridgeCount, blue,
      red, right ? "" : "  <-- WRONG");
  }
  for (std::size_t j = 0; j < this->TrueOfFound.size(); ++j)
  {
    if (this->TrueOfFound[j] < 0)
    {
      const FoundUmbilic& found = this->Found.umbilics[j];
      std::printf("  SPURIOUS %zu: index %+.1f, ridges %d, at %.4f %.4f %.4f\n", j, found.index,
        found.ridgeCount, found.position.x(), found.position.y(), found.position.z());
    }
  }
  std::printf("  ends in singular triangles without umbilic: %d blue, %d red; on edges: %d, %d\n",
    this->EndsAt(FoundEnd::Nowhere, true), this->EndsAt(FoundEnd::Nowhere, false),
    this->EndsAt(FoundEnd::OnEdge, true), this->EndsAt(FoundEnd::OnEdge, false));

  std::printf("\nLengths by type:  true    found  difference\n");
  const std::array<double, 5> expected = LengthsByType(this->True.ridges);
  std::array<double, 5> found{};
  for (const FoundRidge& ridge : this->Found.ridges)
  {
    for (const FoundLine& line : ridge.lines)
    {
      found[std::clamp(line.type, 0, 4)] += LengthOf(line.points);
    }
  }
  for (int type = found[0] > 0.0 ? 0 : 1; type <= 4; ++type)
  {
    std::printf("  %-10s %9.4f %8.4f  %8.2f %%\n", Types[type], expected[type], found[type],
      expected[type] > 0.0 ? 100.0 * (found[type] / expected[type] - 1.0) : 0.0);
  }

  std::printf("\nDistances in edges          mean    95 %%     max  (at)                        "
              "length > 1  wrong type\n");
  for (int color = 0; color < 2; ++color)
  {
    for (const bool isFound : { true, false })
    {
      const Coverage& coverage = (isFound ? this->OfFound.colors : this->OfTrue.colors)[color];
      std::printf("  %-4s %-17s %8.4f %7.4f %7.3f  (%7.3f %7.3f %7.3f)  %10.1f  %10.1f\n",
        Colors[color], isFound ? "found to true" : "true to found", coverage.mean,
        coverage.percentile95, coverage.greatest, coverage.farthest.x(), coverage.farthest.y(),
        coverage.farthest.z(), coverage.off / this->Edge, coverage.wrongType / this->Edge);
    }
  }

  std::array<std::array<int, 2>, 2> trueCount{};
  std::array<std::array<int, 2>, 2> foundCount{};
  for (const TrueRidge& ridge : this->True.ridges)
  {
    ++trueCount[ridge.maximum ? 0 : 1][ridge.closed ? 0 : 1];
  }
  for (const FoundRidge& ridge : this->Found.ridges)
  {
    ++foundCount[ridge.IsMaximum() ? 0 : 1][ridge.ends.empty() ? 0 : 1];
  }
  std::printf("\nRidges        true              found\n");
  for (int color = 0; color < 2; ++color)
  {
    std::printf("  %-4s %3d loops %3d open  %3d loops %3d open\n", Colors[color],
      trueCount[color][0], trueCount[color][1], foundCount[color][0], foundCount[color][1]);
  }
  std::printf("  whole: %d of %zu; missing: %d; spurious: %d. Not whole, by their umbilics:\n",
    this->WholeRidges, this->True.ridges.size(), this->MissingRidges, this->SpuriousRidges);
  for (const std::string& fault : this->RidgeFaults)
  {
    std::printf("%s\n", fault.c_str());
  }
  const std::vector<std::string> doubts = DoubtsAbout(this->True.ridges, this->True.umbilics);
  for (const std::string& doubt : doubts)
  {
    std::printf("  THE REFERENCE ITSELF IS IN DOUBT: %s\n", doubt.c_str());
  }
}

//------------------------------------------------------------------------------
RidgeScore RidgeComparison::Score() const
{
  RidgeScore score;
  for (const FoundUmbilic& umbilic : this->Found.umbilics)
  {
    score.indexSum += umbilic.index;
  }
  score.umbilics = static_cast<int>(this->True.umbilics.size());
  for (std::size_t i = 0; i < this->FoundOfTrue.size(); ++i)
  {
    const int j = this->FoundOfTrue[i];
    if (j < 0)
    {
      continue;
    }
    const ExactUmbilic& umbilic = this->True.umbilics[i];
    const FoundUmbilic& found = this->Found.umbilics[j];
    score.farthest =
      std::max(score.farthest, (found.position - umbilic.position).norm() / this->Edge);
    const bool right = found.index == umbilic.index && found.ridgeCount == umbilic.ridgeCount;
    const bool joined =
      this->EndsAt(j, true) == umbilic.ridgeCount && this->EndsAt(j, false) == umbilic.ridgeCount;
    score.rightUmbilics += right ? 1 : 0;
    score.joinedUmbilics += joined ? 1 : 0;
  }
  score.spuriousUmbilics =
    static_cast<int>(std::count(this->TrueOfFound.begin(), this->TrueOfFound.end(), -1));
  score.ridges = static_cast<int>(this->True.ridges.size());
  score.wholeRidges = this->WholeRidges;
  score.missingRidges = this->MissingRidges;
  score.spuriousRidges = this->SpuriousRidges;
  double length = 0.0;
  for (const FoundRidge& ridge : this->Found.ridges)
  {
    score.typedLines += static_cast<int>(ridge.lines.size());
    length += LengthOf(ridge);
  }
  for (const TrueRidge& ridge : this->True.ridges)
  {
    score.arcs += NumberOfArcs(ridge);
  }
  const double wrong = this->OfFound.colors[0].wrongType + this->OfFound.colors[1].wrongType;
  score.wrongType = length > 0.0 ? wrong / length : 0.0;
  for (const int end : { FoundEnd::Nowhere, FoundEnd::OnEdge })
  {
    score.looseEnds += this->EndsAt(end, true) + this->EndsAt(end, false);
  }
  return score;
}

//------------------------------------------------------------------------------
void RidgeComparison::PrintLine(int eulerCharacteristic) const
{
  const RidgeScore score = this->Score();
  std::printf("umbilics %d/%d right (+%d spurious, %d joined, off %.2f), index %g/%d; ridges "
              "%d/%d whole, %d missing, %d spurious; typed lines %d/%d, wrong type %.2f %%; 95%% "
              "%.3f %.3f max %.2f %.2f%s\n",
    score.rightUmbilics, score.umbilics, score.spuriousUmbilics, score.joinedUmbilics,
    score.farthest, score.indexSum, eulerCharacteristic, score.wholeRidges, score.ridges,
    score.missingRidges, score.spuriousRidges, score.typedLines, score.arcs,
    100.0 * score.wrongType, this->OfFound.colors[0].percentile95,
    this->OfFound.colors[1].percentile95, this->OfFound.colors[0].greatest,
    this->OfFound.colors[1].greatest,
    DoubtsAbout(this->True.ridges, this->True.umbilics).empty() ? "" : " (reference in doubt)");
}

} // namespace testing
} // namespace ridges
