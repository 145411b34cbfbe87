// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RIDGES_BENCHMARKS_MACHINE_FACTS_H
#define RIDGES_BENCHMARKS_MACHINE_FACTS_H

#include <string>
#include <utility>
#include <vector>

namespace benchmarks
{

// What times depend on: processor, compiler, libraries; name and value.
std::vector<std::pair<std::string, std::string>> MachineFacts();

} // namespace benchmarks

#endif
