// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RIDGES_TESTING_PARALLEL_FOR_H
#define RIDGES_TESTING_PARALLEL_FOR_H

#include <cstddef>
#include <functional>

namespace ridges
{
namespace testing
{

// Calls body(i) for all i in [0, count), by several threads: exact Monge forms are slow. The bodies
// write to places of their own. The first exception is thrown on.
void ParallelFor(std::size_t count, const std::function<void(std::size_t)>& body);

} // namespace testing
} // namespace ridges

#endif
