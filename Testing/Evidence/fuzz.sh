#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Fuzzes the readers of the program and the filters with libFuzzer, under the address and undefined
# behaviour sanitizers, in build-fuzz/.
#
#   Testing/Evidence/fuzz.sh [SECONDS [TARGET]...]
#
# So long for each target (default 1800, and all targets), one after the other. What is found is kept
# in build-fuzz/corpus/TARGET, and goes on from there the next time; an input that fails is in
# build-fuzz/TARGET-crash-... or so, to be given to the target as its argument. The exit code says
# whether there is one; a row for each target goes into Filters/Documentation/Evidence.md.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
seconds=${1:-1800}
shift || true
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=(FuzzFilters FuzzFormulas FuzzReader-{obj,off,ply,stl,vtk,vtp})

"$root/.ci/install.sh" clang
cd "$root"
cmake --preset fuzz -DRIDGES_BUILD_PROGRAM=ON -DBUILD_TESTING=ON >/dev/null
cmake --build --preset fuzz --target "${targets[@]}" >&2

# Leaks are those of what VTK keeps to the end of the process. Memory is limited, so that a false
# count in a file is found that asks for gigabytes.
export ASAN_OPTIONS=detect_leaks=0
status=0
for target in "${targets[@]}"; do
  corpus=build-fuzz/corpus/$target
  log=build-fuzz/$target.log
  mkdir -p "$corpus"
  RIDGES_FUZZ_SEEDS=$corpus "build-fuzz/bin/$target"
  outcome=clean
  TIMEFORMAT=%U
  { time "build-fuzz/bin/$target" "$corpus" -max_total_time="$seconds" -timeout=120 -rss_limit_mb=2048 \
    -max_len=4096 -print_final_stats=1 -artifact_prefix="build-fuzz/$target-" >"$log" 2>&1; } \
    2>"$log.time" || {
    outcome=$(grep -m 1 -E 'ERROR|SUMMARY|runtime error|not finite' "$log" | cut -c 1-120)
    status=1
  }
  tried=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  kept=$(find "$corpus" -type f | wc -l)
  echo "| $target | $(date +%F) | $seconds | $(cat "$log.time") | ${tried:-?} | $kept | ${outcome:-failed} |" |
    flock build-fuzz python3 Testing/Evidence/into_page.py Filters/Documentation/Evidence.md fuzz --rows
done
exit $status
