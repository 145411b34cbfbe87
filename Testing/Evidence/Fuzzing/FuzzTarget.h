// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What each target defines besides LLVMFuzzerTestOneInput.

#ifndef RIDGES_FUZZ_TARGET_H
#define RIDGES_FUZZ_TARGET_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// To be changed by the fuzzer, or replayed as they are.
std::vector<std::string> FuzzSeeds();

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

#endif
