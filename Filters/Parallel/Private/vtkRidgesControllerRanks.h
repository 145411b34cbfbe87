// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesControllerRanks_h
#define vtkRidgesControllerRanks_h

#include "Base/Ranks.h"
#include "vtkRidgesCompatibility.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;
VTK_ABI_NAMESPACE_END

/// The processes of a controller, for the numerics, and what a filter needs to run on all of them.
/// Private to the module.
class vtkRidgesControllerRanks : public ridges::Ranks
{
public:
  /// The pipeline of the filter is a vtkRidgesRanksPipeline.
  explicit vtkRidgesControllerRanks(vtkAlgorithm* filter)
    : Filter(filter)
  {
  }

  /// Who calls this keeps the controller.
  void SetController(vtkMultiProcessController* controller);

  int Rank() const override;
  int Size() const override;
  std::string Fault() const override;
  std::vector<ridges::Bytes> Exchange(std::vector<ridges::Bytes> messages) override;
  std::vector<ridges::Bytes> GatherAll(ridges::Bytes message) override;

private:
  void Send(const ridges::Bytes& message, int rank);
  void Receive(ridges::Bytes& message, int rank);

  vtkAlgorithm* Filter;
  vtkMultiProcessController* Controller = nullptr;
};

#endif
