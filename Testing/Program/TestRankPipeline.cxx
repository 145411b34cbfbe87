// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What is set on the stages reaches the filter that replaces them on several ranks: every property,
// by what the stages print of themselves.

#include "RankPipeline.h"

#include "vtkIndent.h"
#include "vtkNew.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesAndUmbilics.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>

namespace
{

/// The properties that an object prints, without those of all algorithms.
std::map<std::string, std::string> PropertiesOf(vtkAlgorithm* algorithm)
{
  const auto lines = [](vtkAlgorithm* printed)
  {
    std::ostringstream text;
    printed->PrintSelf(text, vtkIndent());
    std::map<std::string, std::string> values;
    std::istringstream stream(text.str());
    std::string line;
    while (std::getline(stream, line))
    {
      line.erase(0, line.find_first_not_of(' '));
      const std::size_t colon = line.find(": ");
      if (colon != std::string::npos)
      {
        values[line.substr(0, colon)] = line.substr(colon + 2);
      }
    }
    return values;
  };
  std::map<std::string, std::string> values = lines(algorithm);
  vtkNew<vtkPolyDataAlgorithm> any;
  for (const auto& [name, value] : lines(any))
  {
    values.erase(name);
  }
  return values;
}

/// What vtkRidgesAndUmbilics fixes, or has no output for. The program refuses the options.
const std::set<std::string> NotForwarded = { "MongeOrder", "ExtractMaximum", "ExtractMinimum",
  "ExtremalityRule", "FindPurplePoints" };

/// Of the extraction it is the selection that has it.
const std::string OfSelection = "CrestOnly";

void SetAll(vtkJetFitting* jets)
{
  jets->SetDegree(5);
  jets->SetNeighborhoodToRadius();
  jets->SetMinimumNumberOfPoints(41);
  jets->SetNumberOfRings(7);
  jets->SetRadius(0.125);
  jets->SetWeightingToGaussian();
  jets->SetBlendNoisyFits(false);
  jets->SetStandardErrors(true);
}

void SetAll(vtkUmbilicDetection* umbilics)
{
  umbilics->SetMethod(vtkUmbilicDetection::MINIMA);
  umbilics->SetSignificance(1.25);
  umbilics->SetPatchSize(3.5);
}

void SetAll(vtkRidgeExtraction* ridges)
{
  ridges->SetTypeRule(vtkRidgeExtraction::THIRD_ORDER);
  ridges->SetCrossingRule(ridges->GetCrossingRule() == vtkRidgeExtraction::FORM
      ? vtkRidgeExtraction::LINEAR
      : vtkRidgeExtraction::FORM);
  ridges->SetUmbilicJoining(ridges->GetUmbilicJoining() == vtkRidgeExtraction::PATCHES
      ? vtkRidgeExtraction::TRIANGLES
      : vtkRidgeExtraction::PATCHES);
  ridges->SetComputeFoldAngle(true);
  ridges->SetLoopSignificance(1.125);
  ridges->SetZoneSignificance(2.125);
  ridges->SetTypeSignificance(0.375);
  ridges->SetTypeHysteresis(0.625);
  ridges->SetModelSize(17.0);
  ridges->SetUmbilicCutOff(0.0625);
}

void SetAll(vtkRidgeSharpnessFilter* selection)
{
  selection->SetMinimumSharpness(1.5);
  selection->SetMinimumStrength(2.5);
  selection->SetMinimumLength(3.5);
  selection->SetKeepMaximumElliptic(false);
  selection->SetKeepMaximumHyperbolic(false);
  selection->SetKeepMinimumElliptic(false);
  selection->SetKeepMinimumHyperbolic(false);
  selection->SetKeepUndecided(false);
  selection->SetCrestOnly(true);
  selection->SetWholeRidges(!selection->GetWholeRidges());
  selection->SetMaximumNumber(9);
  selection->SetRankBy(selection->GetRankBy() == 0 ? 1 : 0);
}

/// Sets all properties of a stage; what of them the filter has, by their names.
template <typename Stage>
void ExpectForwarded(void (*set)(Stage*), vtkNew<Stage> program::Filters::*stage)
{
  const auto before = PropertiesOf(vtkNew<Stage>());
  program::Filters filters;
  vtkNew<vtkRidgesAndUmbilics> all;
  set(filters.*stage);
  program::SetProperties(filters, all);
  const auto expected = PropertiesOf(filters.*stage);
  EXPECT_GE(expected.size(), 3U);
  std::ostringstream printed;
  all->PrintSelf(printed, vtkIndent());
  for (const auto& [name, value] : expected)
  {
    const bool isOfExtraction = std::is_same_v<Stage, vtkRidgeExtraction>;
    if (NotForwarded.count(name) == 0 && !(isOfExtraction && name == OfSelection))
    {
      EXPECT_NE(value, before.at(name)) << name << ": to be set here, and to be forwarded";
      EXPECT_NE(printed.str().find(name + ": " + value + "\n"), std::string::npos)
        << name << " is not forwarded";
    }
  }
}

} // namespace

TEST(RankPipeline, ForwardsEveryPropertyOfTheStages)
{
  ExpectForwarded<vtkJetFitting>(SetAll, &program::Filters::jetFitting);
  ExpectForwarded<vtkUmbilicDetection>(SetAll, &program::Filters::umbilics);
  ExpectForwarded<vtkRidgeExtraction>(SetAll, &program::Filters::ridges);
  ExpectForwarded<vtkRidgeSharpnessFilter>(SetAll, &program::Filters::sharpness);
}
