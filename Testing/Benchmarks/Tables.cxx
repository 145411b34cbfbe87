// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tables.h"

#include <cstdio>
#include <ostream>

namespace benchmarks
{

namespace
{

std::string Cell(double value, const char* format)
{
  if (!(value > 0.0))
  {
    return " - |";
  }
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return std::string(" ") + text + " |";
}

// Of the sizes of one shape, the smallest comes first.
double Growth(const StageRow& row)
{
  const std::string shape = row.mesh.substr(0, row.mesh.find(' '));
  for (const StageRow& other : StageTable())
  {
    if (other.stage == row.stage && other.mesh.substr(0, other.mesh.find(' ')) == shape)
    {
      return row.oneThread / other.oneThread;
    }
  }
  return 0.0;
}

} // namespace

std::vector<StageRow>& StageTable()
{
  static std::vector<StageRow> rows;
  return rows;
}

std::vector<KernelRow>& KernelTable()
{
  static std::vector<KernelRow> rows;
  return rows;
}

std::vector<DegreeRow>& DegreeTable()
{
  static std::vector<DegreeRow> rows;
  return rows;
}

namespace
{

void PrintDegrees(std::ostream& out)
{
  if (!DegreeTable().empty())
  {
    out
      << "\n| fit | degree | points at least | us/point | with errors | ratio | weighted, us/point "
         "| with errors | ratio | CGAL, us/point | CGAL / us/point |\n"
         "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
  }
  for (const DegreeRow& row : DegreeTable())
  {
    out << "| " << row.mesh << " |" << Cell(row.degree, "%.0f") << Cell(row.numberOfPoints, "%.0f")
        << Cell(row.plain, "%.3f") << Cell(row.errors, "%.3f")
        << Cell(row.errors / row.plain, "%.2f") << Cell(row.weighted, "%.3f")
        << Cell(row.weightedErrors, "%.3f") << Cell(row.weightedErrors / row.weighted, "%.2f")
        << Cell(row.cgal, "%.1f") << Cell(row.cgal / row.plain, "%.0f") << "\n";
  }
}

} // namespace

void PrintTables(std::ostream& out)
{
  if (!StageTable().empty())
  {
    out << "\n| stage | mesh | points | 1 thread, us/point | Mpoints/s | growth "
           "| 2 threads, us/point | speed-up | of sines | CGAL, us/point | CGAL / 1 thread "
           "| vtkCurvatures, us/point |\n"
           "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
  }
  for (const StageRow& row : StageTable())
  {
    out << "| " << row.stage << " | " << row.mesh << " |" << Cell(row.points, "%.0f")
        << Cell(row.oneThread, "%.3f") << Cell(1.0 / row.oneThread, "%.2f")
        << Cell(Growth(row), "%.2f") << Cell(row.twoThreads, "%.3f") << Cell(row.speedUp, "%.2f")
        << Cell(row.arithmeticSpeedUp, "%.2f") << Cell(row.cgal, "%.2f")
        << Cell(row.cgal / row.oneThread, "%.1f") << Cell(row.vtk, "%.3f") << "\n";
  }
  PrintDegrees(out);
  if (!KernelTable().empty())
  {
    out
      << "\n| kernel | mesh | gather, us/point | fill | fit | all | CGAL, us/point | CGAL / all |\n"
         "|---|---|---:|---:|---:|---:|---:|---:|\n";
  }
  for (const KernelRow& row : KernelTable())
  {
    const double all = row.gather + row.fill + row.fit;
    out << "| " << row.kernel << " | " << row.mesh << " |" << Cell(row.gather, "%.3f")
        << Cell(row.fill, "%.3f") << Cell(row.fit, "%.3f") << Cell(all, "%.3f")
        << Cell(row.cgal, "%.2f") << Cell(row.cgal / all, "%.0f") << "\n";
  }
}

} // namespace benchmarks
