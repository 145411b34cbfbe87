// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The instruction set that every machine of the architecture has: SSE2, NEON.
#ifdef __GNUC__

#define RIDGES_LANES 2
#include "Fit/Batch/JetBatchKernel.h"

namespace ridges
{

void FitJetBatchBaseline(JetBatch& batch);

void FitJetBatchBaseline(JetBatch& batch)
{
  FitLanes(batch);
}

} // namespace ridges

#endif
