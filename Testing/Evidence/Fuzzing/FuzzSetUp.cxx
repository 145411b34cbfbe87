// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzTarget.h"

#include "vtkObject.h"
#include "vtkSMPTools.h"

#include <cstdlib>
#include <fstream>

// Called by libFuzzer. With RIDGES_FUZZ_SEEDS, a folder, only writes the seeds into it.
extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  vtkObject::GlobalWarningDisplayOff();
  vtkSMPTools::Initialize(1);
  if (const char* folder = std::getenv("RIDGES_FUZZ_SEEDS"))
  {
    int number = 0;
    for (const std::string& seed : FuzzSeeds())
    {
      const std::string path = std::string(folder) + "/seed" + std::to_string(number++);
      std::ofstream(path, std::ios::binary) << seed;
    }
    std::exit(0);
  }
  return 0;
}
