// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RidgesDefaults_h
#define RidgesDefaults_h

/// Called as the plugin is loaded: makes RidgesSettings.json the default of what it names. Settings
/// of the user come first.
void RidgesAddSettings();

#endif
