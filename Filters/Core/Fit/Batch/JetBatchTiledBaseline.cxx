// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The instruction set that every machine of the architecture has: SSE2, NEON, degrees 5 to 8.
#ifdef __GNUC__

#define RIDGES_LANES 2
#include "Fit/Batch/JetBatchTiledKernel.h"

namespace ridges
{

void FitJetBatchTiledBaseline(JetBatch& batch);

void FitJetBatchTiledBaseline(JetBatch& batch)
{
  FitTiledLanes(batch);
}

} // namespace ridges

#endif
