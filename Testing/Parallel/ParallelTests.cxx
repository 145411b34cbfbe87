// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// All ranks run all tests; a rank that fails makes the others fail, too. Rank 0 prints, and whoever
// fails.

#include "vtkMPIController.h"

#include "vtkNew.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

namespace
{

/// Says what has failed, and where.
class FailurePrinter : public testing::EmptyTestEventListener
{
public:
  explicit FailurePrinter(int rank)
    : Rank(rank)
  {
  }

  void OnTestPartResult(const testing::TestPartResult& result) override
  {
    if (result.failed())
    {
      std::fprintf(stderr, "rank %d: %s:%d: %s\n", this->Rank,
        result.file_name() ? result.file_name() : "", result.line_number(), result.message());
    }
  }

private:
  int Rank;
};

} // namespace

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  testing::InitGoogleTest(&argc, argv);
  if (controller->GetLocalProcessId() > 0)
  {
    testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FailurePrinter(controller->GetLocalProcessId()));
  }
  const int failed = RUN_ALL_TESTS() != 0 ? 1 : 0;
  int anyFailed = 0;
  controller->AllReduce(&failed, &anyFailed, 1, vtkCommunicator::MAX_OP);
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return anyFailed != 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
