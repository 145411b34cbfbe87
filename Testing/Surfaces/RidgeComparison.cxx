// SPDX-License-Identifier: BSD-3-Clause
#include "RidgeComparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <tuple>
#include <utility>

namespace ridges
{
namespace testing
{

using Eigen::Vector3d;

namespace
{

//------------------------------------------------------------------------------
double LengthOf(const std::vector<Vector3d>& points)
{
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += (points[i] - points[i - 1]).norm();
  }
  return length;
}

//------------------------------------------------------------------------------
double LengthOf(const FoundRidge& ridge)
{
  double length = 0.0;
  for (const FoundLine& line : ridge.lines)
  {
    length += LengthOf(line.points);
  }
  return length;
}

//------------------------------------------------------------------------------
// Both ends and the middle of each segment, each with its share of the length.
template <typename Visitor>
void ForSamples(const std::vector<Vector3d>& points, const Visitor& visit)
{
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const double length = (points[i] - points[i - 1]).norm();
    visit(points[i - 1], 0.25 * length);
    visit(0.5 * (points[i - 1] + points[i]), 0.5 * length);
    visit(points[i], 0.25 * length);
  }
}

const char* const Colors[2] = { "blue", "red" };
const char* const Types[5] = { "undecided", "blue ell", "green hyp", "red ell", "yellow hyp" };

} // namespace

//------------------------------------------------------------------------------
bool FoundRidge::IsMaximum() const
{
  return std::any_of(this->lines.begin(), this->lines.end(),
    [](const FoundLine& line) { return line.type == 1 || line.type == 2; });
}

//------------------------------------------------------------------------------
RidgeComparison::RidgeComparison(Truth truth, FoundPicture found, double edge)
  : True(std::move(truth))
  , Found(std::move(found))
  , Edge(edge)
{
  this->MatchUmbilics();
  this->MeasureFound();
  this->MeasureTrue();
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
RidgeComparison::Coverage RidgeComparison::Summarize(std::vector<Sample> samples)
{
  Coverage coverage;
  std::sort(samples.begin(), samples.end(),
    [](const Sample& a, const Sample& b) { return a.distance < b.distance; });
  const double total = std::accumulate(samples.begin(), samples.end(), 0.0,
    [](double sum, const Sample& sample) { return sum + sample.length; });
  double sum = 0.0;
  for (const Sample& sample : samples)
  {
    sum += sample.length;
    coverage.mean += sample.distance * sample.length / total;
    coverage.percentile95 = sum <= 0.95 * total ? sample.distance : coverage.percentile95;
    coverage.off += sample.distance > 1.0 ? sample.length : 0.0;
  }
  return coverage;
}

//------------------------------------------------------------------------------
bool RidgeComparison::TypeIsRight(int type, const SegmentGrid::Hit& hit) const
{
  const TrueRidge& ridge = this->True.ridges[hit.line];
  const bool elliptic = type == 1 || type == 3;
  // Any place within an edge of the turning point will do.
  const Vector3d at = ridge.points[hit.segment];
  for (const int step : { -1, 1 })
  {
    for (int i = hit.segment; i >= 0 && i < static_cast<int>(ridge.points.size()); i += step)
    {
      if ((ridge.P[i] < 0.0) == elliptic)
      {
        return true;
      }
      if ((ridge.points[i] - at).norm() > this->Edge)
      {
        break;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void RidgeComparison::MeasureFound()
{
  std::array<SegmentGrid, 2> grids{ SegmentGrid(Reach * this->Edge),
    SegmentGrid(Reach * this->Edge) };
  for (std::size_t r = 0; r < this->True.ridges.size(); ++r)
  {
    const TrueRidge& ridge = this->True.ridges[r];
    for (std::size_t i = 1; i < ridge.points.size(); ++i)
    {
      grids[ridge.maximum ? 0 : 1].Add(
        ridge.points[i - 1], ridge.points[i], static_cast<int>(r), static_cast<int>(i) - 1);
    }
  }

  std::array<std::vector<Sample>, 2> samples;
  std::array<Coverage, 2> worst;
  for (const FoundRidge& ridge : this->Found.ridges)
  {
    const int color = ridge.IsMaximum() ? 0 : 1;
    std::vector<double> lengthOn(this->True.ridges.size() + 1, 0.0);
    for (const FoundLine& line : ridge.lines)
    {
      ForSamples(line.points,
        [&](const Vector3d& point, double length)
        {
          const SegmentGrid::Hit hit = grids[color].Nearest(point);
          const double distance = std::min(Reach, hit.distance / this->Edge);
          samples[color].push_back({ distance, length });
          if (distance > worst[color].greatest)
          {
            worst[color].greatest = distance;
            worst[color].farthest = point;
          }
          const bool near = distance <= 1.0;
          lengthOn[near ? hit.line : this->True.ridges.size()] += length;
          if (near && line.type != 0 && !this->TypeIsRight(line.type, hit))
          {
            worst[color].wrongType += length;
          }
        });
    }
    const auto most = std::max_element(lengthOn.begin(), lengthOn.end() - 1);
    const bool spurious = lengthOn.back() > 0.5 * LengthOf(ridge);
    this->RidgeOfFound.push_back(spurious ? -1 : static_cast<int>(most - lengthOn.begin()));
  }
  for (int color = 0; color < 2; ++color)
  {
    this->FoundCoverage[color] = Summarize(samples[color]);
    this->FoundCoverage[color].greatest = worst[color].greatest;
    this->FoundCoverage[color].farthest = worst[color].farthest;
    this->FoundCoverage[color].wrongType = worst[color].wrongType;
  }
}

//------------------------------------------------------------------------------
void RidgeComparison::MeasureTrue()
{
  std::array<SegmentGrid, 2> grids{ SegmentGrid(Reach * this->Edge),
    SegmentGrid(Reach * this->Edge) };
  for (std::size_t r = 0; r < this->Found.ridges.size(); ++r)
  {
    for (const FoundLine& line : this->Found.ridges[r].lines)
    {
      for (std::size_t i = 1; i < line.points.size(); ++i)
      {
        grids[this->Found.ridges[r].IsMaximum() ? 0 : 1].Add(
          line.points[i - 1], line.points[i], static_cast<int>(r), 0);
      }
    }
  }
  std::array<std::vector<Sample>, 2> samples;
  std::array<Coverage, 2> worst;
  for (const TrueRidge& ridge : this->True.ridges)
  {
    const int color = ridge.maximum ? 0 : 1;
    double missing = 0.0;
    ForSamples(ridge.points,
      [&](const Vector3d& point, double length)
      {
        const double distance = std::min(Reach, grids[color].Nearest(point).distance / this->Edge);
        samples[color].push_back({ distance, length });
        missing += distance > 1.0 ? length : 0.0;
        if (distance > worst[color].greatest)
        {
          worst[color].greatest = distance;
          worst[color].farthest = point;
        }
      });
    this->MissingOfTrue.push_back(missing);
  }
  for (int color = 0; color < 2; ++color)
  {
    this->TrueCoverage[color] = Summarize(samples[color]);
    this->TrueCoverage[color].greatest = worst[color].greatest;
    this->TrueCoverage[color].farthest = worst[color].farthest;
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
    for (std::size_t f = 0; f < this->RidgeOfFound.size(); ++f)
    {
      if (this->RidgeOfFound[f] == static_cast<int>(r))
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
    const bool missing = this->MissingOfTrue[r] > 0.5 * length;
    this->MissingRidges += missing ? 1 : 0;
    if (count == 1 && same && this->MissingOfTrue[r] < 0.05 * length)
    {
      ++this->WholeRidges;
      continue;
    }
    std::snprintf(text, sizeof text,
      "  %-4s %-7s length %7.1f, missing %6.1f, at %.3f %.3f %.3f; found:",
      Colors[ridge.maximum ? 0 : 1], this->NameOfEnds(expected).c_str(), length / this->Edge,
      this->MissingOfTrue[r] / this->Edge, ridge.points[ridge.points.size() / 2].x(),
      ridge.points[ridge.points.size() / 2].y(), ridge.points[ridge.points.size() / 2].z());
    this->RidgeFaults.push_back(text + (pieces.empty() ? std::string(" nothing") : pieces));
  }
  for (std::size_t f = 0; f < this->RidgeOfFound.size(); ++f)
  {
    if (this->RidgeOfFound[f] < 0)
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
      const Coverage& coverage = (isFound ? this->FoundCoverage : this->TrueCoverage)[color];
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
void RidgeComparison::PrintLine(int eulerCharacteristic) const
{
  double indexSum = 0.0;
  for (const FoundUmbilic& umbilic : this->Found.umbilics)
  {
    indexSum += umbilic.index;
  }
  int right = 0;
  int joined = 0;
  double farthest = 0.0;
  for (std::size_t i = 0; i < this->FoundOfTrue.size(); ++i)
  {
    const int j = this->FoundOfTrue[i];
    if (j < 0)
    {
      continue;
    }
    const ExactUmbilic& umbilic = this->True.umbilics[i];
    const FoundUmbilic& found = this->Found.umbilics[j];
    farthest = std::max(farthest, (found.position - umbilic.position).norm() / this->Edge);
    right += found.index == umbilic.index && found.ridgeCount == umbilic.ridgeCount ? 1 : 0;
    joined +=
      this->EndsAt(j, true) == umbilic.ridgeCount && this->EndsAt(j, false) == umbilic.ridgeCount
      ? 1
      : 0;
  }
  const auto spurious = std::count(this->TrueOfFound.begin(), this->TrueOfFound.end(), -1);
  std::printf("umbilics %d/%zu right (+%d spurious, %d joined, off %.2f), index %g/%d; ridges "
              "%d/%zu whole, %d missing, %d spurious; 95%% %.3f %.3f max %.2f %.2f%s\n",
    right, this->True.umbilics.size(), static_cast<int>(spurious), joined, farthest, indexSum,
    eulerCharacteristic, this->WholeRidges, this->True.ridges.size(), this->MissingRidges,
    this->SpuriousRidges, this->FoundCoverage[0].percentile95, this->FoundCoverage[1].percentile95,
    this->FoundCoverage[0].greatest, this->FoundCoverage[1].greatest,
    DoubtsAbout(this->True.ridges, this->True.umbilics).empty() ? "" : " (reference in doubt)");
}

} // namespace testing
} // namespace ridges
