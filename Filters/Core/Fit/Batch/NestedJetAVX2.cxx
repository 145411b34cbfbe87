// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// AVX2 with fused multiply-add.
#ifdef __GNUC__

#define RIDGES_LANES 4
#include "Fit/Batch/NestedJetKernel.h"

namespace ridges
{

void FitNestedJetsAVX2(NestedJetBatch& batch);
void BlendNestedJetsAVX2(NestedJetBatch& batch);

void FitNestedJetsAVX2(NestedJetBatch& batch)
{
  FitNested(batch);
}

void BlendNestedJetsAVX2(NestedJetBatch& batch)
{
  BlendNested(batch);
}

} // namespace ridges

#endif
