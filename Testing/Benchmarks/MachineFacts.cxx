// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MachineFacts.h"

#include "Fit/Batch/JetBatch.h"

#include "vtkSMPTools.h"
#include "vtkVersion.h"

#include <CGAL/version.h>

#include <fstream>
#include <sstream>
#include <thread>

namespace benchmarks
{

namespace
{

// The value of a line "key : value" of Linux' description of the first processor.
std::string ProcessorFact(const std::string& key)
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
  {
    const std::size_t colon = line.find(": ");
    if (line.compare(0, key.size(), key) == 0 && colon != std::string::npos)
    {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

// Of the processor's flags, those that vector code is chosen by.
std::string VectorFlags()
{
  std::istringstream flags(ProcessorFact("flags"));
  std::string chosen;
  for (std::string flag; flags >> flag;)
  {
    if (flag == "fma" || flag.compare(0, 3, "avx") == 0)
    {
      chosen += (chosen.empty() ? "" : " ") + flag;
    }
  }
  return chosen;
}

} // namespace

std::vector<std::pair<std::string, std::string>> MachineFacts()
{
  std::string kernels;
  for (const ridges::JetBatchKernel& kernel : ridges::JetBatchKernels())
  {
    kernels += (kernels.empty() ? "" : ", ") + std::string(kernel.name);
  }
  return { { "processor",
             ProcessorFact("model name") + ", family " + ProcessorFact("cpu family") + " model " +
               ProcessorFact("model\t") },
    { "vector flags", VectorFlags() }, { "kernels, the first is used by the filters", kernels },
    { "hardware threads", std::to_string(std::thread::hardware_concurrency()) },
    { "SMP back end", vtkSMPTools::GetBackend() },
    { "compiler", RIDGES_COMPILER ", " RIDGES_COMPILER_FLAGS },
    { "VTK", vtkVersion::GetVTKVersion() }, { "CGAL", CGAL_VERSION_STR },
    { "seeds", "none, nothing is random" } };
}

} // namespace benchmarks
