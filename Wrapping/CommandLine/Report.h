// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Report_h
#define Report_h

#include "Console.h"

#include "vtkPolyData.h"
#include "vtkTable.h"

#include <ostream>
#include <string>
#include <vector>

namespace program
{

/// What the job made.
struct Results
{
  std::string name;      ///< Of the mesh.
  vtkPolyData* mesh;     ///< With the arrays of the jet fitting and the umbilics.
  vtkPolyData* umbilics; ///< A vertex each.
  vtkPolyData* allRidges;
  vtkPolyData* ridges;      ///< Those that the filter kept.
  vtkTable* checks;         ///< Of all ridges, or null.
  std::size_t joinedPoints; ///< Points of the file that others at their place stand for.
};

/// Prints the table at the end of the job.
void PrintReport(std::ostream& os, const Results& results,
  const std::vector<Stages::Duration>& durations, const std::vector<std::string>& filesWritten);

} // namespace program

#endif
