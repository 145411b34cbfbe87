// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// AVX2 with fused multiply-add, degrees 2 to 4 with standard errors.
#ifdef __GNUC__

#define RIDGES_LANES 4
#include "Fit/Batch/JetBatchKernel.h"

namespace ridges
{

void FitJetBatchErrorsAVX2(JetBatch& batch);

void FitJetBatchErrorsAVX2(JetBatch& batch)
{
  FitLanes<true>(batch);
}

} // namespace ridges

#endif
