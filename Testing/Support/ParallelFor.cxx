// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ParallelFor.h"

#include <algorithm>
#include <future>
#include <thread>
#include <vector>

namespace ridges
{
namespace testing
{

void ParallelFor(std::size_t count, const std::function<void(std::size_t)>& body)
{
  const std::size_t threads = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::future<void>> parts;
  for (std::size_t part = 0; part < threads; ++part)
  {
    parts.push_back(std::async(std::launch::async,
      [=, &body]
      {
        for (std::size_t i = part; i < count; i += threads)
        {
          body(i);
        }
      }));
  }
  for (std::future<void>& part : parts)
  {
    part.get();
  }
}

} // namespace testing
} // namespace ridges
