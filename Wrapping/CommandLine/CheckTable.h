// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CheckTable_h
#define CheckTable_h

#include "vtkTable.h"

#include <ostream>

namespace program
{

/// Prints the table of vtkRidgeCoherence, a line per check; a failed one has two more, with what
/// was expected and with the place of its first offender.
void PrintChecks(std::ostream& os, vtkTable* checks);

vtkIdType CountFailedChecks(vtkTable* checks);

} // namespace program

#endif
