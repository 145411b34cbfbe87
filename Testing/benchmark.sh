#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Builds the benchmarks and runs them; a few minutes. See Filters/Documentation/Speed.md.
#
#   Testing/benchmark.sh [GOOGLE BENCHMARK OPTION]...
#
# For instance --benchmark_filter=40k runs those of that size only, --benchmark_filter=noise1% those
# with noise of 1 % of an edge.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/.ci/prepare.sh" benchmarks
"$root/build/bin/RidgesBenchmarks" "$@"
"$root/build/bin/RidgesMemory"
