// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// AVX-512 (F, DQ and VL).
#ifdef __GNUC__

#define RIDGES_LANES 8
#include "Fit/Batch/JetBatchKernel.h"

namespace ridges
{

// See the files of these names.
void FitJetBatchErrorsAVX512(JetBatch& batch);
void FitJetBatchTiledAVX512(JetBatch& batch);

void FitJetBatchAVX512(JetBatch& batch);

void FitJetBatchAVX512(JetBatch& batch)
{
  if (batch.degree > 4)
  {
    FitJetBatchTiledAVX512(batch);
  }
  else if (batch.standardErrors)
  {
    FitJetBatchErrorsAVX512(batch);
  }
  else
  {
    FitLanes<false>(batch);
  }
}

} // namespace ridges

#endif
