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
