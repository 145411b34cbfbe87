// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What was measured, as Markdown, at the end of a run.

#ifndef RIDGES_BENCHMARKS_TABLES_H
#define RIDGES_BENCHMARKS_TABLES_H

#include <iosfwd>
#include <string>
#include <vector>

namespace benchmarks
{

// A stage on a mesh; microseconds per point, 0 where not measured.
struct StageRow
{
  std::string stage;
  std::string mesh;
  double points = 0.0;
  double oneThread = 0.0;
  double twoThreads = 0.0; // of wall time; the others of the time of the thread
  double speedUp = 0.0;    // of wall time
  double cgal = 0.0;
  double vtk = 0.0;
  double arithmeticSpeedUp = 0.0; // of sines, in the same run
};

// A kernel on a mesh; microseconds per point.
struct KernelRow
{
  std::string kernel;
  std::string mesh;
  double gather = 0.0;
  double fill = 0.0;
  double fit = 0.0; // and taking out what it found
  double cgal = 0.0;
};

// A fit by the filter on one thread; microseconds per point, and ratios to plain fits.
struct DegreeRow
{
  std::string mesh;
  int degree = 0;
  int numberOfPoints = 0;
  double plain = 0.0;
  double errors = 0.0;
  double weighted = 0.0;
  double weightedErrors = 0.0;
  double cgal = 0.0;
};

std::vector<StageRow>& StageTable();
std::vector<DegreeRow>& DegreeTable();
std::vector<KernelRow>& KernelTable();

void PrintTables(std::ostream& out);

} // namespace benchmarks

#endif
