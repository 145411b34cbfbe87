#!/usr/bin/env bash
# Builds the benchmarks and runs them; a few minutes. See Filters/Documentation/Speed.md.
#
#   Testing/benchmark.sh [GOOGLE BENCHMARK OPTION]...
#
# For instance --benchmark_filter=40k runs those of that size only.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/.ci/prepare.sh" benchmarks
"$root/build/bin/RidgesBenchmarks" "$@"
"$root/build/bin/RidgesMemory"
