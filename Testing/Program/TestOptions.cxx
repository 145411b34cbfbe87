// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace
{

using program::Filters;

void Parse(std::vector<std::string> arguments, Filters& filters)
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
  Parse({ "--umbilic-method", "minima", "--umbilic-significance", "4.5", "--patch-size", "3" },
    filters);
  EXPECT_EQ(filters.umbilics->GetMethod(), vtkUmbilicDetection::MINIMA);
  EXPECT_EQ(filters.umbilics->GetSignificance(), 4.5);
  EXPECT_EQ(filters.umbilics->GetPatchSize(), 3.0);
}

TEST(Options, SetRidgeExtraction)
{
  Filters filters;
  Parse({ "--extremality-rule", "gaussian", "--umbilic-joining", "triangles", "--loop-significance",
          "0", "--type-hysteresis", "2.5", "--type-rule", "third-order" },
    filters);
  EXPECT_EQ(filters.ridges->GetExtremalityRule(), vtkRidgeExtraction::GAUSSIAN);
  EXPECT_EQ(filters.ridges->GetUmbilicJoining(), vtkRidgeExtraction::TRIANGLES);
  EXPECT_EQ(filters.ridges->GetLoopSignificance(), 0.0);
  EXPECT_EQ(filters.ridges->GetTypeHysteresis(), 2.5);
  EXPECT_EQ(filters.ridges->GetTypeRule(), vtkRidgeExtraction::THIRD_ORDER);
}

} // namespace
