// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRidgesRanks.h
 * What filters call the processes that have the other pieces of a mesh, and what they find out
 * together: private to the modules of vtkRidges, whose filters hand them to those that they derive
 * from.
 */
#ifndef vtkRidgesRanks_h
#define vtkRidgesRanks_h

namespace ridges
{
class MeshPart;
class Ranks;
struct SharedSurface;
}
class vtkRidgesStreamedFit; // of pieces that one rank asks for, one after the other

#endif
// VTK-HeaderTest-Exclude: vtkRidgesRanks.h
