// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "CheckTable.h"
#include "Picture.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>

namespace names = vtkRidgesArrayNames;

namespace program
{
namespace
{

template <typename... Arguments>
std::string Format(const char* format, Arguments... arguments)
{
  char text[256];
  std::snprintf(text, sizeof(text), format, arguments...);
  return text;
}

std::string Count(vtkIdType number, const char* noun)
{
  return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

void PrintRow(std::ostream& os, const char* title, const std::string& text)
{
  os << Format("%-9s", title) << text << "\n";
}

vtkIdType CountIf(vtkDataArray* array, const std::function<bool(double)>& condition)
{
  vtkIdType count = 0;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    count += condition(array->GetTuple1(i)) ? 1 : 0;
  }
  return count;
}

double FieldValue(vtkPolyData* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetTuple1(0) : 0.0;
}

/// Halves as such: "2", "-1/2", "5/2".
std::string Halves(double value)
{
  const long twice = std::lround(2.0 * value);
  return twice % 2 == 0 ? std::to_string(twice / 2) : std::to_string(twice) + "/2";
}

void PrintMesh(std::ostream& os, const Results& results, const MeshCounts& counts)
{
  PrintRow(os, "mesh",
    results.name + ": " + Count(counts.points, "point") + ", " +
      Count(counts.triangles, "triangle") + ", " +
      (counts.IsClosed() ? std::string("closed") : std::string()) +
      (counts.borderEdges > 0 ? "with a border of " + Count(counts.borderEdges, "edge")
                              : std::string()) +
      (counts.borderEdges > 0 && counts.nonManifoldEdges > 0 ? ", " : "") +
      (counts.nonManifoldEdges > 0
          ? Count(counts.nonManifoldEdges, "edge") + " of more than two triangles"
          : std::string()));
  if (results.joinedPoints > 0)
  {
    const auto joined = static_cast<vtkIdType>(results.joinedPoints);
    PrintRow(os, "joined",
      Count(joined, "point") + " at the same place as others (--no-merge keeps them apart)");
  }
  constexpr std::array<const char*, 4> degraded = { "on the border", "with too few neighbours",
    "ill conditioned", "without any fit" };
  std::string text;
  for (std::size_t i = 0; i < degraded.size(); ++i)
  {
    if (counts.degraded[i] > 0)
    {
      text += (text.empty() ? "" : ", ") + std::to_string(counts.degraded[i]) + " " + degraded[i];
    }
  }
  if (!text.empty())
  {
    PrintRow(os, "degraded", "points " + text);
  }
  if (!results.lineChoice.empty())
  {
    PrintRow(os, "lines", results.lineChoice);
  }
  if (!results.selectedFit.empty())
  {
    PrintRow(os, "fit", results.selectedFit);
  }
}

/// Where a quantity is within its errors of 0: the triangles of the zones, and what that means.
void PrintZones(
  std::ostream& os, long long count, long long all, const char* quantity, const char* meaning)
{
  if (count > 0)
  {
    PrintRow(os, "",
      std::string(quantity) + " is " +
        (count == all ? "nowhere significant"
                      : "not significant in " +
              Format("%.2g", 100.0 * static_cast<double>(count) / static_cast<double>(all)) +
              " % of the triangles") +
        ": " + meaning);
  }
}

void PrintUmbilics(std::ostream& os, const Results& results, const MeshCounts& counts)
{
  vtkDataArray* index = results.umbilics->GetPointData()->GetArray(names::Index);
  PrintRow(os, "umbilics",
    Format("+1/2: %lld, -1/2: %lld",
      static_cast<long long>(CountIf(index, [](double value) { return value > 0.0; })),
      static_cast<long long>(CountIf(index, [](double value) { return value < 0.0; }))));
  const double sum = FieldValue(results.mesh, names::UmbilicIndexSum);
  const double characteristic = FieldValue(results.mesh, names::EulerCharacteristic);
  std::string text = "index sum " + Halves(sum);
  if (sum == characteristic)
  {
    text += " = Euler characteristic";
  }
  else
  {
    text += ", Euler characteristic " + Halves(characteristic);
    text += counts.IsClosed() ? ": they differ, some umbilics are missed or false"
                              : ": they may differ, as the mesh has a border";
  }
  PrintRow(os, "", text);
  PrintZones(os, counts.umbilicZone, counts.triangles, "k1 - k2", "umbilics there mean nothing");
}

struct LineTotals
{
  long long count = 0;
  double length = 0.0;
};

/// Of the lines that are meant, by their numbers.
LineTotals TotalsOf(vtkPolyData* lines, const std::function<bool(vtkIdType)>& isMeant)
{
  vtkDataArray* length = lines->GetCellData()->GetArray(names::Length);
  LineTotals totals;
  for (vtkIdType i = 0; length && i < lines->GetNumberOfCells(); ++i)
  {
    if (isMeant(i))
    {
      ++totals.count;
      totals.length += length->GetTuple1(i);
    }
  }
  return totals;
}

void PrintRidges(std::ostream& os, const Results& results, const MeshCounts& counts)
{
  vtkCellData* data = results.ridges->GetCellData();
  vtkDataArray* type = data->GetArray(names::RidgeType);
  vtkDataArray* crest = data->GetArray(names::Crest);
  os << "\n" << Format("%-30s %8s %12s\n", "ridges", "lines", "length");
  const auto row = [&results, &os](const char* name, const char* color,
                     const std::function<bool(vtkIdType)>& isMeant)
  {
    const LineTotals totals = TotalsOf(results.ridges, isMeant);
    if (totals.count > 0 || *name != 'u')
    {
      os << Format("  %-20s %-7s %8lld %12.5g\n", name, color, totals.count, totals.length);
    }
  };
  for (const RidgeStyle& style : RidgeStyles)
  {
    row(style.name, style.colorName,
      [type, &style](vtkIdType i)
      { return type && static_cast<int>(type->GetTuple1(i)) == style.type; });
  }
  row("of them crest lines", "",
    [&crest](vtkIdType i) { return crest && crest->GetTuple1(i) != 0.0; });
  const vtkIdType left = results.allRidges->GetNumberOfCells() - results.ridges->GetNumberOfCells();
  if (left > 0)
  {
    os << "  " << Count(left, "more line") << " the filter left out\n";
  }
  PrintZones(os, counts.ridgeZone[0], counts.triangles, "b0", "maximum ridges there were left out");
  PrintZones(os, counts.ridgeZone[1], counts.triangles, "b3", "minimum ridges there were left out");
}

void PrintSalient(std::ostream& os, vtkPolyData* lines)
{
  vtkCellData* data = lines->GetCellData();
  vtkDataArray* type = data->GetArray(names::RidgeType);
  vtkDataArray* fold = data->GetArray(names::FoldAngle);
  os << "\n" << Format("%-30s %8s %12s %14s\n", "salient lines", "lines", "length", "largest fold");
  for (const RidgeStyle& style : RidgeStyles)
  {
    if (!*style.salientName)
    {
      continue;
    }
    double largest = 0.0;
    const LineTotals totals = TotalsOf(lines,
      [type, fold, &style, &largest](vtkIdType i)
      {
        const bool isMeant = static_cast<int>(type->GetTuple1(i)) == style.type;
        largest = isMeant ? std::max(largest, fold->GetTuple1(i)) : largest;
        return isMeant;
      });
    os << Format("  %-20s %-7s %8lld %12.5g %10.3g deg\n", style.salientName, style.colorName,
      totals.count, totals.length, largest);
  }
}

} // namespace

void PrintReport(std::ostream& os, const Results& results, const MeshCounts& counts,
  const std::vector<Stages::Duration>& durations, const std::vector<std::string>& filesWritten)
{
  PrintMesh(os, results, counts);
  PrintUmbilics(os, results, counts);
  if (results.areSalient)
  {
    PrintSalient(os, results.ridges);
  }
  else
  {
    PrintRidges(os, results, counts);
  }
  if (results.certificate)
  {
    PrintCertificate(os, results.certificate);
  }
  if (results.checks)
  {
    PrintChecks(os, results.checks);
  }
  os << "\n";
  std::string text;
  for (const auto& [name, seconds] : durations)
  {
    text += (text.empty() ? "" : ", ") + name + Format(" %.2f", seconds);
  }
  PrintRow(os, "seconds", text);
  const char* title = "written";
  for (const std::string& file : filesWritten)
  {
    PrintRow(os, title, file);
    title = "";
  }
}

} // namespace program
