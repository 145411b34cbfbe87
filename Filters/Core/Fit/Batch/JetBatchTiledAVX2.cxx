// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// AVX2 with fused multiply-add, degrees 5 to 8.
#ifdef __GNUC__

#define RIDGES_LANES 4
#include "Fit/Batch/JetBatchTiledKernel.h"

namespace ridges
{

void FitJetBatchTiledAVX2(JetBatch& batch);

void FitJetBatchTiledAVX2(JetBatch& batch)
{
  FitTiledLanes(batch);
}

} // namespace ridges

#endif
