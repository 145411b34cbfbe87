// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkJetFunction.h"

vtkJetFunction::vtkJetFunction() = default;
vtkJetFunction::~vtkJetFunction() = default;
