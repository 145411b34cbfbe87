// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// AVX-512 (F, DQ and VL), degrees 2 to 4 with standard errors.
#ifdef __GNUC__

#define RIDGES_LANES 8
#include "Fit/Batch/JetBatchKernel.h"

namespace ridges
{

void FitJetBatchErrorsAVX512(JetBatch& batch);

void FitJetBatchErrorsAVX512(JetBatch& batch)
{
  FitLanes<true>(batch);
}

} // namespace ridges

#endif
