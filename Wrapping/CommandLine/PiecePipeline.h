// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PiecePipeline_h
#define PiecePipeline_h

#include "Options.h"
#include "Report.h"

namespace program
{

/// What RunFilters does where a .pvtp is taken in parts, one after the other (--pieces). Of the
/// results, the mesh is the part of it in which umbilics and ridges may be. Throws Failure.
void RunInPieces(const Options& options, Filters& filters, Stages& stages, Results& results);

} // namespace program

#endif
