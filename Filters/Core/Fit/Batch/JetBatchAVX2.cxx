// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// AVX2 with fused multiply-add.
#ifdef __GNUC__

#define RIDGES_LANES 4
#include "Fit/Batch/JetBatchKernel.h"

namespace ridges
{

void FitJetBatchAVX2(JetBatch& batch);

void FitJetBatchAVX2(JetBatch& batch)
{
  FitLanes(batch);
}

} // namespace ridges

#endif
