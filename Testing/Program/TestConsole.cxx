// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Console.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRidgeSharpnessFilter.h"
#include "vtkSetGet.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

using program::PlainMessage;

TEST(Console, StripsMessagesOfVTKsPrefixes)
{
  EXPECT_EQ(PlainMessage("ERROR: In /a/b.cxx, line 12\nvtkThing (0x55aa): It is\n broken.\n\n"),
    "It is broken");
  EXPECT_EQ(
    PlainMessage("Warning: In b.cxx, line 1\nvtkThing (0x1): Value (a): 3.\n"), "Value (a): 3");
  EXPECT_EQ(PlainMessage("just a text"), "just a text");
  EXPECT_EQ(PlainMessage("a text (0x12): in parentheses"), "a text (0x12): in parentheses");
  EXPECT_EQ(PlainMessage(""), "");
}

TEST(Console, EndsAStageAtTheFirstErrorOfVTK)
{
  program::Stages stages(true);
  try
  {
    stages.Run("stage", "do that", nullptr,
      []
      {
        vtkGenericWarningMacro("a warning");
        vtkNew<vtkPolyData> object;
        vtkErrorWithObjectMacro(object, "the first");
        vtkErrorWithObjectMacro(object, "the second");
      });
    FAIL() << "no failure";
  }
  catch (const program::Failure& failure)
  {
    EXPECT_STREQ(failure.what(), "stage failed: the first : do that");
  }
  // And leaves none for the next.
  EXPECT_NO_THROW(stages.Run("next", "", nullptr, [] {}));
}

TEST(Console, PutsTheProgramsOptionsInPlaceOfVtksClasses)
{
  program::Stages stages(true);
  stages.SetHint("vtkCleanPolyData", "--merge joins them");
  try
  {
    stages.Run(
      "stage", [] { return std::string("do that"); }, nullptr,
      []
      {
        vtkNew<vtkPolyData> object;
        vtkErrorWithObjectMacro(
          object, "2 points (a few) coincide (vtkCleanPolyData merges them); 3 not");
      });
    FAIL() << "no failure";
  }
  catch (const program::Failure& failure)
  {
    EXPECT_STREQ(failure.what(),
      "stage failed: 2 points (a few) coincide (--merge joins them); 3 not : do that");
  }
}

TEST(Console, EndsAStrictStageAtAWarning)
{
  program::Stages stages(true);
  EXPECT_THROW(stages.RunStrictly("stage", "do that", [] { vtkGenericWarningMacro("a warning"); }),
    program::Failure);
}

TEST(Console, HoldsWarningsUntilTheyAreWanted)
{
  program::Stages stages(false);
  testing::internal::CaptureStderr();
  stages.HoldWarnings();
  stages.Warn("first", "do that");
  stages.ReleaseWarnings(false);
  stages.HoldWarnings();
  stages.Warn("second", "do that");
  stages.ReleaseWarnings(true);
  stages.Warn("third", "do that");
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
    "vtkridges: warning, second : do that\nvtkridges: warning, third : do that\n");
}

TEST(Console, MeasuresStages)
{
  program::Stages stages(true);
  stages.Run("one", "", nullptr, [] {});
  stages.Run("two", "", nullptr, [] {});
  ASSERT_EQ(stages.GetDurations().size(), 2U);
  EXPECT_EQ(stages.GetDurations()[0].first, "one");
  EXPECT_EQ(stages.GetDurations()[1].first, "two");
  EXPECT_GE(stages.GetDurations()[1].second, 0.0);
}

} // namespace
