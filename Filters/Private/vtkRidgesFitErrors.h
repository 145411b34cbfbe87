// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesFitErrors_h
#define vtkRidgesFitErrors_h

#include "Core/Fit/FitErrors.h"

class vtkPolyData;

/// The arrays on a mesh that tell the errors of its fits, null where there are none; private to the
/// module. They have to be of double precision, as vtkJetFitting makes them.
ridges::FitErrorSource vtkRidgesFetchFitErrors(vtkPolyData* mesh);

#endif
