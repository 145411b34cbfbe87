// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CheckTable_h
#define CheckTable_h

#include "vtkTable.h"

#include <ostream>

namespace program
{

/// Prints the table of vtkRidgeCoherence, a line per check; one with offenders has two more, with
/// what was expected and with the place of its first offender.
void PrintChecks(std::ostream& os, vtkTable* checks);

/// Number of checks whose offenders neither noise nor a coarse mesh explains.
vtkIdType CountFailedChecks(vtkTable* checks);

/// Prints the table of vtkCertifiedRidges in the same way.
void PrintCertificate(std::ostream& os, vtkTable* certificate);

/// Number of hypotheses that could not be proved.
vtkIdType CountFailedHypotheses(vtkTable* certificate);

} // namespace program

#endif
