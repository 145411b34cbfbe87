// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesSharedFit_h
#define vtkRidgesSharedFit_h

#include "vtkRidgesCompatibility.h"
#include "vtkRidgesRanks.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkInformationVector;
class vtkJetFitting;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * What vtkJetFitting does where each rank has a piece of the mesh, private to the module. All ranks
 * have to call it. The output is this rank's piece, with the values that the points have in the
 * whole mesh. The result is that of RequestData, the same on all ranks.
 *
 * Points are owned by ranks: each rank fits those that it owns, on a share of the mesh that goes as
 * many rings farther as the fits look at. Where a fit has looked farther than that, it is done
 * again on a larger share. The surface, if wanted, is what was seen meanwhile.
 */
int vtkRidgesSharedFit(vtkJetFitting* filter, ridges::Ranks& ranks, vtkInformationVector* input,
  vtkPolyData* output, ridges::SharedSurface* surface);

#endif
