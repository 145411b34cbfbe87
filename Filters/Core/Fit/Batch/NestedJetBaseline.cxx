// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Any processor.
#ifdef __GNUC__

#define RIDGES_LANES 2
#include "Fit/Batch/NestedJetKernel.h"

namespace ridges
{

void FitNestedJetsBaseline(NestedJetBatch& batch);
void BlendNestedJetsBaseline(NestedJetBatch& batch);

void FitNestedJetsBaseline(NestedJetBatch& batch)
{
  FitNested(batch);
}

void BlendNestedJetsBaseline(NestedJetBatch& batch)
{
  BlendNested(batch);
}

} // namespace ridges

#endif
