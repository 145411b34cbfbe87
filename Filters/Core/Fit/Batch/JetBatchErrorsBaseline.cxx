// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The instruction set that every machine of the architecture has: SSE2, NEON, degrees 2 to 4 with
// standard errors.
#ifdef __GNUC__

#define RIDGES_LANES 2
#include "Fit/Batch/JetBatchKernel.h"

namespace ridges
{

void FitJetBatchErrorsBaseline(JetBatch& batch);

void FitJetBatchErrorsBaseline(JetBatch& batch)
{
  FitLanes<true>(batch);
}

} // namespace ridges

#endif
