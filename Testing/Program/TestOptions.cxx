// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace
{

using program::Filters;

program::Options Parse(std::vector<std::string> arguments, Filters& filters)
{
  arguments.insert(arguments.begin(), "vtkridges");
  std::vector<char*> argv;
  argv.reserve(arguments.size());
  for (std::string& argument : arguments)
  {
    argv.push_back(argument.data());
  }
  program::Options options;
  EXPECT_EQ(program::ParseCommandLine(static_cast<int>(argv.size()), argv.data(), options, filters),
    std::nullopt);
  return options;
}

TEST(Options, LeaveTheDefaultsOfTheFilters)
{
  const Filters untouched;
  Filters filters;
  Parse({}, filters);
  EXPECT_EQ(filters.umbilics->GetMethod(), untouched.umbilics->GetMethod());
  EXPECT_EQ(filters.umbilics->GetSignificance(), untouched.umbilics->GetSignificance());
  EXPECT_EQ(filters.umbilics->GetPatchSize(), untouched.umbilics->GetPatchSize());
  EXPECT_EQ(filters.ridges->GetTypeRule(), untouched.ridges->GetTypeRule());
  EXPECT_EQ(filters.ridges->GetExtremalityRule(), untouched.ridges->GetExtremalityRule());
  EXPECT_EQ(filters.ridges->GetUmbilicJoining(), untouched.ridges->GetUmbilicJoining());
  EXPECT_EQ(filters.ridges->GetLoopSignificance(), untouched.ridges->GetLoopSignificance());
  EXPECT_EQ(filters.ridges->GetTypeHysteresis(), untouched.ridges->GetTypeHysteresis());
}

TEST(Options, SetUmbilicDetection)
{
  Filters filters;
  Parse({ "--umbilic-method", "indices", "--umbilic-significance", "4.5", "--patch-size", "3" },
    filters);
  EXPECT_EQ(filters.umbilics->GetSignificance(), 4.5);
  EXPECT_EQ(filters.umbilics->GetPatchSize(), 3.0);
  Parse({ "--umbilic-method", "minima" }, filters);
  EXPECT_EQ(filters.umbilics->GetMethod(), vtkUmbilicDetection::MINIMA);
}

TEST(Options, SetRidgeExtraction)
{
  Filters filters;
  Parse({ "--umbilic-joining", "triangles", "--loop-significance", "0", "--zone-significance", "2",
          "--type-hysteresis", "2.5", "--type-rule", "third-order", "--degree", "3" },
    filters);
  EXPECT_EQ(filters.ridges->GetUmbilicJoining(), vtkRidgeExtraction::TRIANGLES);
  EXPECT_EQ(filters.ridges->GetLoopSignificance(), 0.0);
  EXPECT_EQ(filters.ridges->GetZoneSignificance(), 2.0);
  EXPECT_EQ(filters.ridges->GetTypeHysteresis(), 2.5);
  EXPECT_EQ(filters.ridges->GetTypeRule(), vtkRidgeExtraction::THIRD_ORDER);
  Parse({ "--extremality-rule", "gaussian" }, filters);
  EXPECT_EQ(filters.ridges->GetExtremalityRule(), vtkRidgeExtraction::GAUSSIAN);
}

TEST(Options, SetSalientRidges)
{
  Filters filters;
  const auto options =
    Parse({ "mesh.off", "--fold-angle", "25", "--relative-scale", "0.005", "--hysteresis", "0.4",
            "--longest-gap", "2", "--least-mass", "0.1", "--noise-factor", "0", "--line-smoothing",
            "0.5", "--not-crest-only" },
      filters);
  EXPECT_EQ(options.lines, program::Lines::Salient);
  EXPECT_EQ(filters.salient->GetFoldAngle(), 25.0);
  EXPECT_EQ(filters.salient->GetRelativeScale(), 0.005);
  EXPECT_EQ(filters.salient->GetHysteresis(), 0.4);
  EXPECT_EQ(filters.salient->GetLongestGap(), 2.0);
  EXPECT_EQ(filters.salient->GetLeastMass(), 0.1);
  EXPECT_EQ(filters.salient->GetLineSmoothing(), 0.5);
  EXPECT_EQ(filters.salient->GetNoiseFactor(), 0.0);
  EXPECT_FALSE(filters.salient->GetCrestOnly());
}

TEST(Options, DecideWhichLinesAreWanted)
{
  const std::vector<std::pair<std::vector<std::string>, program::Lines>> cases{
    { {}, program::Lines::Complete },
    { { "--salient" }, program::Lines::Salient },
    { { "mesh.off" }, program::Lines::ByData },
    { { "mesh.off", "--write-mesh", "--view", "1,0,0" }, program::Lines::ByData },
    { { "mesh.off", "--complete" }, program::Lines::Complete },
    { { "mesh.off", "--salient" }, program::Lines::Salient },
    { { "mesh.off", "--crest-only" }, program::Lines::Complete },
    { { "mesh.off", "--check" }, program::Lines::Complete },
  };
  for (const auto& [arguments, lines] : cases)
  {
    Filters filters;
    EXPECT_EQ(Parse(arguments, filters).lines, lines) << testing::PrintToString(arguments);
  }
}

TEST(Options, RejectEmptyNames)
{
  for (std::string text : { "vtkridges", "vtkridges -o" })
  {
    std::string option = "-o";
    std::string empty;
    std::vector<char*> argv{ text.data() };
    if (text != "vtkridges")
    {
      argv.push_back(option.data());
    }
    argv.push_back(empty.data());
    Filters filters;
    program::Options options;
    EXPECT_EQ(
      program::ParseCommandLine(static_cast<int>(argv.size()), argv.data(), options, filters),
      program::ExitMisused);
  }
}

TEST(Options, SetRepair)
{
  const std::pair<std::vector<std::string>, program::Joining> joinings[] = {
    { { "m.off" }, program::Joining::Borders }, { { "m.off", "--merge" }, program::Joining::All },
    { { "m.off", "--no-merge" }, program::Joining::None }
  };
  for (const auto& [arguments, joining] : joinings)
  {
    Filters filters;
    const program::Options options = Parse(arguments, filters);
    EXPECT_EQ(options.repair.joining, joining);
    EXPECT_FALSE(options.repair.orient);
  }
  Filters filters;
  EXPECT_TRUE(Parse({ "m.off", "--orient" }, filters).repair.orient);
}

TEST(Options, SetTypesToKeepInAnyOrderAndCase)
{
  Filters filters;
  Parse({ "--keep", "Red,blue" }, filters);
  EXPECT_TRUE(filters.sharpness->GetKeepMaximumElliptic());
  EXPECT_TRUE(filters.sharpness->GetKeepMinimumElliptic());
  EXPECT_FALSE(filters.sharpness->GetKeepMaximumHyperbolic());
  EXPECT_FALSE(filters.sharpness->GetKeepMinimumHyperbolic());
  EXPECT_FALSE(filters.sharpness->GetKeepUndecided());
}

} // namespace
