// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

// What Linux says that this process uses.

#ifndef RIDGES_TESTING_PROCESS_USE_H
#define RIDGES_TESTING_PROCESS_USE_H

#include <sys/resource.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace ridges
{
namespace testing
{

constexpr double BytesPerMiB = 1024.0 * 1024.0;

// A line "VmHWM:  123 kB" of the description of this process, in bytes.
inline double StatusBytes(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.compare(0, key.size(), key) == 0)
    {
      return 1024.0 * std::strtod(line.c_str() + key.size() + 1, nullptr);
    }
  }
  return 0.0;
}

inline double ResidentBytes()
{
  return StatusBytes("VmRSS");
}

// At its most, since it began or ForgetPeak.
inline double PeakBytes()
{
  return StatusBytes("VmHWM");
}

inline void ForgetPeak()
{
  std::ofstream("/proc/self/clear_refs") << "5\n";
}

// Of all threads, in the program and in the system for it.
inline double ProcessorSeconds()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time)
  { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

} // namespace testing
} // namespace ridges

#endif
