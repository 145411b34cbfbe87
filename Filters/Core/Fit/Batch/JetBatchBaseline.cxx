// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The instruction set that every machine of the architecture has: SSE2, NEON.
#ifdef __GNUC__

#define RIDGES_LANES 2
#include "Fit/Batch/JetBatchKernel.h"

namespace ridges
{

// See the files of these names.
void FitJetBatchErrorsBaseline(JetBatch& batch);
void FitJetBatchTiledBaseline(JetBatch& batch);

void FitJetBatchBaseline(JetBatch& batch);

void FitJetBatchBaseline(JetBatch& batch)
{
  if (batch.degree > 4)
  {
    FitJetBatchTiledBaseline(batch);
  }
  else if (batch.standardErrors)
  {
    FitJetBatchErrorsBaseline(batch);
  }
  else
  {
    FitLanes<false>(batch);
  }
}

} // namespace ridges

#endif
