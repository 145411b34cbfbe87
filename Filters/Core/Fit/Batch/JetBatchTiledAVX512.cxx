// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// AVX-512 (F, DQ and VL), degrees 5 to 8.
#ifdef __GNUC__

#define RIDGES_LANES 8
#include "Fit/Batch/JetBatchTiledKernel.h"

namespace ridges
{

void FitJetBatchTiledAVX512(JetBatch& batch);

void FitJetBatchTiledAVX512(JetBatch& batch)
{
  FitTiledLanes(batch);
}

} // namespace ridges

#endif
