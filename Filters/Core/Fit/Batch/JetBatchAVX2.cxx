// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// AVX2 with fused multiply-add.
#ifdef __GNUC__

#define RIDGES_LANES 4
#include "Fit/Batch/JetBatchKernel.h"

namespace ridges
{

// See the files of these names.
void FitJetBatchErrorsAVX2(JetBatch& batch);
void FitJetBatchTiledAVX2(JetBatch& batch);

void FitJetBatchAVX2(JetBatch& batch);

void FitJetBatchAVX2(JetBatch& batch)
{
  if (batch.degree > 4)
  {
    FitJetBatchTiledAVX2(batch);
  }
  else if (batch.standardErrors)
  {
    FitJetBatchErrorsAVX2(batch);
  }
  else
  {
    FitLanes<false>(batch);
  }
}

} // namespace ridges

#endif
