// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesRanksPipeline_h
#define vtkRidgesRanksPipeline_h

#include "vtkRidgesCompatibility.h"

#include <string>

// ParaView keeps the pipeline of a filter only if it is of this kind.
#ifdef RIDGES_FOR_PARAVIEW
#include "vtkPVCompositeDataPipeline.h"
using vtkRidgesAnyPipeline = vtkPVCompositeDataPipeline;
#else
#include "vtkCompositeDataPipeline.h"
using vtkRidgesAnyPipeline = vtkCompositeDataPipeline;
#endif

VTK_ABI_NAMESPACE_BEGIN
/**
 * Lets a filter run on all ranks, also on those where its input is missing, of another type, or
 * could not be made: others would wait for them. The filter has to find out what is wrong. Private
 * to the module.
 *
 * An input could not be made where what is before the filter says so, or has reported an error
 * meanwhile: readers do this, and go on with what they have.
 */
class vtkRidgesRanksPipeline : public vtkRidgesAnyPipeline
{
public:
  static vtkRidgesRanksPipeline* New();
  vtkTypeMacro(vtkRidgesRanksPipeline, vtkRidgesAnyPipeline);

  /// Whether there are other ranks. If not, it is as any pipeline.
  void SetIsShared(bool isShared) { this->IsShared = isShared; }

  /// Why there is no input, as far as the filter cannot see it.
  std::string GetFault() const;

protected:
  int ForwardUpstream(vtkInformation* request) override;
  int InputTypeIsValid(int port, int index, vtkInformationVector** inputs) override;
  void ExecuteSimpleAlgorithm(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs, int port) override;

private:
  using Superclass::ForwardUpstream;
  using Superclass::InputTypeIsValid;

  vtkMTimeType TimeOfSource();
  int ForwardAndListen(vtkInformation* request);
  void Hear(vtkObject* reporter, unsigned long event, void* text);

  bool IsShared = false;
  bool HasFailed = false;
  std::string Heard;           ///< The first error that was reported meanwhile.
  vtkMTimeType FailedTime = 0; ///< TimeOfSource, as it failed.
};
VTK_ABI_NAMESPACE_END

#endif
