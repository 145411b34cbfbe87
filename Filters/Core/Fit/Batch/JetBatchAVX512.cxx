// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// AVX-512 (F, DQ and VL).
#ifdef __GNUC__

#define RIDGES_LANES 8
#include "Fit/Batch/JetBatchKernel.h"

namespace ridges
{

void FitJetBatchAVX512(JetBatch& batch);

void FitJetBatchAVX512(JetBatch& batch)
{
  FitLanes(batch);
}

} // namespace ridges

#endif
