// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/Batch/JetBatch.h"

namespace ridges
{

// One translation unit each, compiled for its instruction set.
void FitJetBatchAVX512(JetBatch& batch);
void FitJetBatchAVX2(JetBatch& batch);
void FitJetBatchBaseline(JetBatch& batch);

const std::vector<JetBatchKernel>& JetBatchKernels()
{
  static const std::vector<JetBatchKernel> kernels = []
  {
    std::vector<JetBatchKernel> available;
#ifdef RIDGES_HAS_X86_KERNELS
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma"))
    {
      available.push_back({ "AVX-512", 8, FitJetBatchAVX512 });
    }
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    {
      available.push_back({ "AVX2", 4, FitJetBatchAVX2 });
    }
#endif
#ifdef __GNUC__
    available.push_back({ "baseline", 2, FitJetBatchBaseline });
#endif
    return available;
  }();
  return kernels;
}

} // namespace ridges
