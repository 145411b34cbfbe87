// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_LargeMemory_h
#define ridges_LargeMemory_h

#include <cstddef>

namespace ridges
{

/// Less memory than this is not worth a large page.
constexpr std::size_t LargeMemorySize = std::size_t(1) << 20;

/**
 * Memory that begins with a cache line. From LargeMemorySize on it is asked for in pages of two
 * megabytes, on systems that know them: making new memory available in pages of four kilobytes
 * takes a fifth of the time of a whole pipeline. Throws std::bad_alloc.
 */
void* AllocateLarge(std::size_t bytes);

/// Gives back what AllocateLarge gave.
void FreeLarge(void* memory);

/**
 * Gives memory that was freed back to the system, where the C library can. Otherwise much of it
 * stays with the process, in pieces too small for what comes next: a call between steps that take
 * much memory each. Takes milliseconds, and a page that is needed again some hundred nanoseconds.
 */
void ReturnFreeMemory();

} // namespace ridges

#endif
