// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CheckTable.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkRidgesArrayNames.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace names = vtkRidgesArrayNames;

namespace
{

/// One check of each severity, and one that does not apply.
vtkSmartPointer<vtkTable> Table()
{
  auto table = vtkSmartPointer<vtkTable>::New();
  for (const char* name : { names::Check, names::Section, names::Expected, names::Found,
         names::OffenderKind, names::Offenders })
  {
    vtkNew<vtkStringArray> column;
    column->SetName(name);
    for (const char* row : { "good", "noisy", "bad", "idle" })
    {
      column->InsertNextValue(std::string(row) + name);
    }
    table->AddColumn(column);
  }
  const std::pair<const char*, std::array<int, 4>> numbers[] = { { names::Applies, { 1, 1, 1, 0 } },
    { names::Severity, { 0, 1, 2, 0 } } };
  for (const auto& [name, values] : numbers)
  {
    vtkNew<vtkIntArray> column;
    column->SetName(name);
    for (const int value : values)
    {
      column->InsertNextValue(value);
    }
    table->AddColumn(column);
  }
  vtkNew<vtkDoubleArray> position;
  position->SetName(names::OffenderPosition);
  position->SetNumberOfComponents(3);
  position->SetNumberOfTuples(4);
  position->Fill(0.5);
  table->AddColumn(position);
  return table;
}

TEST(CheckTable, CountsOnlyWhatNoiseDoesNotExplain)
{
  EXPECT_EQ(program::CountFailedChecks(Table()), 1);
}

TEST(CheckTable, PrintsTheResultOfEachCheckAndWhereItIsNot)
{
  std::ostringstream os;
  program::PrintChecks(os, Table());
  const std::string text = os.str();
  for (const char* expected : { "goodSection  passed     goodFound\n",
         "noisySection uncertain  noisyFound\n", "badSection   failed     badFound\n",
         "idleSection  -          does not apply\n", "expected: noisyExpected\n",
         "badOffenderKind badOffenders : at 0.5 0.5 0.5\n", "uncertain: noise" })
  {
    EXPECT_NE(text.find(expected), std::string::npos) << expected << "is missing in" << text;
  }
  EXPECT_EQ(text.find("goodExpected"), std::string::npos);
}

} // namespace
