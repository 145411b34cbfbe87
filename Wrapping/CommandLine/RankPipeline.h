// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RankPipeline_h
#define RankPipeline_h

#include "Options.h"
#include "OutputFiles.h"
#include "Ranks.h"
#include "Report.h"

namespace program
{

/// What RunFilters does where there are several ranks, all of which have to call this. Of the
/// results, the mesh is a rank's piece; lines and umbilics are those of the first rank. Throws
/// Failure, the same on all.
void RunOnRanks(
  const Options& options, Filters& filters, const Ranks& ranks, Stages& stages, Results& results);

/// Sets the properties of the stages, from fit to filter, on the filter that replaces them there.
void SetProperties(Filters& filters, vtkRidgesAndUmbilics* all);

/// Ports and choice of fit of this filter become the results.
void TakeResults(vtkRidgesAndUmbilics* all, Results& results);

/// The name of the file for a rank's piece of a mesh in a .pvtp of this name.
std::string NameOfPiece(const std::string& fileName, int rank);

/// The text of a .pvtp that names the pieces of all ranks, with arrays as in this one.
std::string TextOfPieces(vtkPolyData* piece, const std::string& fileName, int ranks);

} // namespace program

#endif
