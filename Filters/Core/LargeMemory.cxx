// SPDX-License-Identifier: BSD-3-Clause
#include "LargeMemory.h"

#include <algorithm>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace ridges
{

void* AllocateLarge(std::size_t bytes)
{
  void* memory = nullptr;
#ifdef __linux__
  constexpr std::size_t page = std::size_t(1) << 21;
  if (bytes >= LargeMemorySize)
  {
    // A page that is half used is better than hundreds of small ones.
    const std::size_t rest = bytes % page;
    const std::size_t rounded = rest >= page / 2 ? bytes - rest + page : bytes;
    if (posix_memalign(&memory, page, rounded) != 0)
    {
      throw std::bad_alloc();
    }
    // An advice: it does not matter if it is not taken.
    madvise(memory, rounded, MADV_HUGEPAGE);
    return memory;
  }
#endif
  memory = std::malloc(std::max<std::size_t>(bytes, 1));
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

} // namespace ridges
