// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesFitSettings_h
#define vtkRidgesFitSettings_h

#include "vtkJetFitting.h"
#include "vtkRidgesFitPoints.h"

#include "Core/Fit/JetSelection.h"

#include <vector>

// What the properties of vtkJetFitting mean, private to the module.

/// As far as they are about a single fit, and nothing is chosen yet.
vtkRidgesFitPoints::Settings vtkRidgesFitSettings(vtkJetFitting* filter);

/// The same after a choice: of one fit, or of all those that are blended.
std::vector<vtkRidgesFitPoints::Settings> vtkRidgesFitSettings(
  vtkJetFitting* filter, const ridges::JetChoice& choice);

/// The highest order of the Monge forms that come out.
int vtkRidgesFitOrder(vtkJetFitting* filter);

/// A property that cannot be used; empty if all can.
std::string vtkRidgesFitSettingsFault(vtkJetFitting* filter);

#endif
