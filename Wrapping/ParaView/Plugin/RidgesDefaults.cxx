// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RidgesDefaults.h"

#include "RidgesSettings.h" // made of RidgesSettings.json

#include "vtkSMSettings.h"

void RidgesAddSettings()
{
  static bool isDone = false; // the plugin may be loaded again
  if (!isDone)
  {
    isDone = true;
    vtkSMSettings::GetInstance()->AddCollectionFromString(RidgesSettings, 0.0);
  }
}
