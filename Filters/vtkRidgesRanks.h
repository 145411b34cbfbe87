// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRidgesRanks.h
 * What filters call the processes that have the other pieces of a mesh: private to the modules of
 * vtkRidges, whose parallel filters hand them to those that they derive from.
 */
#ifndef vtkRidgesRanks_h
#define vtkRidgesRanks_h

namespace ridges
{
class Ranks;
}

#endif
// VTK-HeaderTest-Exclude: vtkRidgesRanks.h
