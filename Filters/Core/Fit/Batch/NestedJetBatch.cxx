// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/Batch/NestedJetBatch.h"

namespace ridges
{

// One translation unit each, compiled for its instruction set.
void FitNestedJetsAVX512(NestedJetBatch& batch);
void FitNestedJetsAVX2(NestedJetBatch& batch);
void FitNestedJetsBaseline(NestedJetBatch& batch);
void BlendNestedJetsAVX512(NestedJetBatch& batch);
void BlendNestedJetsAVX2(NestedJetBatch& batch);
void BlendNestedJetsBaseline(NestedJetBatch& batch);

const std::vector<NestedJetKernel>& NestedJetKernels()
{
  // Of the same instruction sets as the other kernels.
  static const std::vector<NestedJetKernel> kernels = []
  {
    std::vector<NestedJetKernel> available;
    for (const JetBatchKernel& kernel : JetBatchKernels())
    {
      switch (kernel.lanes)
      {
#ifdef RIDGES_HAS_X86_KERNELS
        case 8:
          available.push_back({ kernel.name, 8, FitNestedJetsAVX512, BlendNestedJetsAVX512 });
          break;
        case 4:
          available.push_back({ kernel.name, 4, FitNestedJetsAVX2, BlendNestedJetsAVX2 });
          break;
#endif
#ifdef __GNUC__
        case 2:
          available.push_back({ kernel.name, 2, FitNestedJetsBaseline, BlendNestedJetsBaseline });
          break;
#endif
        default:
          break;
      }
    }
    return available;
  }();
  return kernels;
}

} // namespace ridges
