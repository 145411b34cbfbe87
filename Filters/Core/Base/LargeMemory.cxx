// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/LargeMemory.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace ridges
{

// Aligned here and not by the library: GNU's takes aligned memory of this size from the system, new
// each time, but reuses other memory that was freed.
void* AllocateLarge(std::size_t bytes)
{
  constexpr std::size_t line = 64;
  std::size_t alignment = line;
  std::size_t size = bytes;
#ifdef __linux__
  constexpr std::size_t page = std::size_t(1) << 21;
  if (bytes >= LargeMemorySize)
  {
    // A page that is half used is better than hundreds of small ones.
    const std::size_t rest = bytes % page;
    size = rest >= LargeMemorySize ? bytes - rest + page : bytes;
    alignment = page;
  }
#endif
  char* whole = static_cast<char*>(std::malloc(size + line + alignment));
  if (!whole)
  {
    throw std::bad_alloc();
  }
  char* memory = whole + line;
  memory += alignment - reinterpret_cast<std::uintptr_t>(memory) % alignment;
#ifdef __linux__
  if (alignment == page)
  {
    // A hint; failure is harmless.
    madvise(memory, size, MADV_HUGEPAGE);
  }
#endif
  std::memcpy(memory - sizeof(whole), &whole, sizeof(whole));
  return memory;
}

void FreeLarge(void* memory)
{
  if (memory)
  {
    char* whole = nullptr;
    std::memcpy(&whole, static_cast<char*>(memory) - sizeof(whole), sizeof(whole));
    std::free(whole);
  }
}

void ReturnFreeMemory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

} // namespace ridges
