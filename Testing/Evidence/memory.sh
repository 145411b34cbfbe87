#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Peak memory per point by the number of threads, written into Filters/Documentation/Evidence.md.
#
#   Testing/Evidence/memory.sh [FREQUENCY [NOISE]]
#
# On an ellipsoid of 10 FREQUENCY^2 + 2 points, 2.6 million by default, and noise of 0.01 edges.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
"$root/.ci/install.sh" libbenchmark-dev libcgal-demo libcgal-dev
cmake -S "$root" -B "$root/build" -DRIDGES_BUILD_BENCHMARKS=ON >/dev/null
cmake --build "$root/build" --target RidgesMemory >&2
{
  frequency=${1:-510}
  echo "$((10 * frequency * frequency + 2)) points, noise of ${2:-0.01} edges:"
  echo
  echo "| threads | stage | peak | kept |"
  echo "|---------|-------|------|------|"
  for threads in 1 2 7 64; do
    # More threads than processors: with VTK's own.
    VTK_SMP_BACKEND_IN_USE=STDThread VTK_SMP_MAX_THREADS=$threads \
      "$root/build/bin/RidgesMemory" "${1:-510}" "${2:-0.01}" |
      sed -n "s/^| \(vtk[A-Za-z]*\) |/| $threads | \1 |/p"
  done
} | python3 "$root/Testing/Evidence/into_page.py" "$root/Filters/Documentation/Evidence.md" memory
