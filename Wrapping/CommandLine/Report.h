// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Report_h
#define Report_h

#include "Console.h"
#include "MeshCounts.h"

#include "vtkPolyData.h"
#include "vtkTable.h"

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace program
{

/// The results of the job.
struct Results
{
  std::string name;                 ///< Of the mesh.
  vtkPolyData* mesh = nullptr;      ///< With the arrays of the jet fitting and the umbilics.
  vtkPolyData* umbilics = nullptr;  ///< A vertex each.
  vtkPolyData* allRidges = nullptr; ///< Before the filter.
  vtkPolyData* ridges = nullptr;    ///< After it.
  vtkTable* checks = nullptr;       ///< Of all ridges, or null.
  vtkTable* certificate = nullptr;  ///< Of a surface given by a formula, or null.
  bool isInsideOut = false;         ///< Whether the normals of a closed mesh point inwards.
  bool areSalient = false;          ///< Whether the ridges are salient lines.
  std::string lineChoice;           ///< Which lines the data decided for, and why; or empty.
  std::size_t joinedPoints = 0;     ///< Points of the file that became one with others.
  std::string selectedFit;          ///< What the fit chose; empty if it did not choose.
  std::optional<MeshCounts> counts; ///< Where the mesh is only a part of what was read.
};

/// Prints the table at the end of the job.
void PrintReport(std::ostream& os, const Results& results, const MeshCounts& counts,
  const std::vector<Stages::Duration>& durations, const std::vector<std::string>& filesWritten);

} // namespace program

#endif
