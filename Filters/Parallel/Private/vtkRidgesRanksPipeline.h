// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesRanksPipeline_h
#define vtkRidgesRanksPipeline_h

#include "vtkCompositeDataPipeline.h"
#include "vtkRidgesCompatibility.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
/**
 * Lets a filter run on all ranks, also on those where its input is missing, of another type, or
 * could not be made: others would wait for them. The filter has to find out what is wrong. Private
 * to the module.
 */
class vtkRidgesRanksPipeline : public vtkCompositeDataPipeline
{
public:
  static vtkRidgesRanksPipeline* New();
  vtkTypeMacro(vtkRidgesRanksPipeline, vtkCompositeDataPipeline);

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

  bool IsShared = false;
  bool HasFailed = false;
  vtkMTimeType FailedTime = 0; ///< TimeOfSource, as it failed.
};
VTK_ABI_NAMESPACE_END

#endif
