// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CheckTable.h"

#include "vtkDataArray.h"
#include "vtkRidgesArrayNames.h"
#include "vtkVariant.h"

#include <iomanip>
#include <string>

namespace names = vtkRidgesArrayNames;

namespace program
{
namespace
{

/// Values of the column Severity.
constexpr int Passed = 0;
constexpr int Wrong = 2;

int SeverityOf(vtkTable* checks, vtkIdType row)
{
  return checks->GetValueByName(row, names::Severity).ToInt();
}

void PrintCheck(std::ostream& os, vtkTable* checks, vtkIdType row)
{
  constexpr int nameWidth = 24;
  constexpr int sectionWidth = 13;
  constexpr int resultWidth = 11;
  const auto text = [&checks, &row](const char* column)
  { return std::string(checks->GetValueByName(row, column).ToString()); };
  const bool applies = checks->GetValueByName(row, names::Applies).ToInt() != 0;
  const int severity = SeverityOf(checks, row);
  const char* result = severity == Wrong ? "failed"
    : severity != Passed                 ? "uncertain"
    : applies                            ? "passed"
                                         : "-";
  os << "  " << std::left << std::setw(nameWidth) << text(names::Check) << std::setw(sectionWidth)
     << text(names::Section) << std::setw(resultWidth) << result
     << (applies ? text(names::Found) : std::string("does not apply")) << "\n";
  if (severity != Passed)
  {
    const std::string indent(2 + nameWidth + sectionWidth + resultWidth, ' ');
    const double* position =
      vtkDataArray::SafeDownCast(checks->GetColumnByName(names::OffenderPosition))->GetTuple(row);
    os << indent << "expected: " << text(names::Expected) << "\n"
       << indent << text(names::OffenderKind) << " " << text(names::Offenders) << " : at "
       << position[0] << " " << position[1] << " " << position[2] << "\n";
  }
}

void PrintHypothesis(std::ostream& os, vtkTable* certificate, vtkIdType row)
{
  constexpr int nameWidth = 24;
  constexpr int sectionWidth = 13;
  const auto text = [&certificate, &row](const char* column)
  { return std::string(certificate->GetValueByName(row, column).ToString()); };
  os << "  " << std::left << std::setw(nameWidth) << text(names::Check) << std::setw(sectionWidth)
     << text(names::Section) << text(names::Verdict) << "\n";
  if (certificate->GetValueByName(row, names::Passed).ToInt() == 0)
  {
    const std::string indent(2 + nameWidth + sectionWidth, ' ');
    const double* position =
      vtkDataArray::SafeDownCast(certificate->GetColumnByName(names::OffenderPosition))
        ->GetTuple(row);
    os << indent << "expected: " << text(names::Expected) << "\n"
       << indent << text(names::NumberOfOffenders) << " times, " << text(names::OffenderKind) << " "
       << text(names::Offenders) << " : at " << position[0] << " " << position[1] << " "
       << position[2] << "\n";
  }
}

} // namespace

void PrintCertificate(std::ostream& os, vtkTable* certificate)
{
  os << "\nhypotheses                section      verdict\n";
  for (vtkIdType row = 0; row < certificate->GetNumberOfRows(); ++row)
  {
    PrintHypothesis(os, certificate, row);
  }
}

vtkIdType CountFailedHypotheses(vtkTable* certificate)
{
  vtkIdType count = 0;
  for (vtkIdType row = 0; row < certificate->GetNumberOfRows(); ++row)
  {
    count += certificate->GetValueByName(row, names::Passed).ToInt() == 0 ? 1 : 0;
  }
  return count;
}

void PrintChecks(std::ostream& os, vtkTable* checks)
{
  os << "\nchecks                    section      result     found\n";
  bool isUncertain = false;
  for (vtkIdType row = 0; row < checks->GetNumberOfRows(); ++row)
  {
    PrintCheck(os, checks, row);
    isUncertain =
      isUncertain || (SeverityOf(checks, row) != Passed && SeverityOf(checks, row) != Wrong);
  }
  if (isUncertain)
  {
    os << "  uncertain: noise or a coarse mesh may be the cause, the result is consistent in "
          "itself\n";
  }
}

vtkIdType CountFailedChecks(vtkTable* checks)
{
  vtkIdType count = 0;
  for (vtkIdType row = 0; row < checks->GetNumberOfRows(); ++row)
  {
    count += SeverityOf(checks, row) == Wrong ? 1 : 0;
  }
  return count;
}

} // namespace program
