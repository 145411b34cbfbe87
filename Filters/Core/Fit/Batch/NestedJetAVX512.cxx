// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// AVX-512.
#ifdef __GNUC__

#define RIDGES_LANES 8
#include "Fit/Batch/NestedJetKernel.h"

namespace ridges
{

void FitNestedJetsAVX512(NestedJetBatch& batch);
void BlendNestedJetsAVX512(NestedJetBatch& batch);

void FitNestedJetsAVX512(NestedJetBatch& batch)
{
  FitNested(batch);
}

void BlendNestedJetsAVX512(NestedJetBatch& batch)
{
  BlendNested(batch);
}

} // namespace ridges

#endif
