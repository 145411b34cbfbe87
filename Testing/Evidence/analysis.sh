#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Analysis of Filters/, by compilers and tools. A line for each finding, and a summary.
#
#   Testing/Evidence/analysis.sh [cppcheck] [conversion] [coverage]
#
#   cppcheck     warnings, and what is slow or not portable
#   conversion   of numbers that may change their value, in the rooms of Filters/Core, by -Wconversion
#                and -Wsign-conversion of the compiler
#   coverage     lines of Filters/ that the tests with the labels core and filter run, by gcov, in
#                build-coverage/
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
parts=("$@")
[ ${#parts[@]} -gt 0 ] || parts=(cppcheck conversion coverage)

run_cppcheck() {
  .ci/install.sh cppcheck
  local found
  found=$(cppcheck --language=c++ --std=c++17 --enable=warning,performance,portability --inline-suppr \
    --suppress=missingInclude --suppress=unknownMacro --quiet --template='{file}:{line}: {id}: {message}' \
    -I Filters/Core Filters 2>&1 | grep -v '^$' | sort -u || true)
  [ -z "$found" ] || echo "$found"
  echo "cppcheck: $(grep -c . <<<"$found" || true) findings"
}

run_conversion() {
  local flags=(-std=c++17 -fsyntax-only -Wconversion -Wsign-conversion -I Filters/Core
    -isystem /usr/include/eigen3)
  local found
  found=$(find Filters/Core -name '*.cxx' ! -name 'JetBatch*' -print0 | sort -z |
    xargs -0 -P 2 -n 4 "${CXX:-c++}" "${flags[@]}" 2>&1 | grep 'warning:' | sort -u || true)
  [ -z "$found" ] || sed 's/ \[/\t[/' <<<"$found"
  echo "conversion: $(grep -c '\[-Wconversion\]\|\[-Wfloat-conversion\]' <<<"$found" || true)" \
    "that may change a value, $(grep -c 'Wsign-conversion' <<<"$found" || true) of sign"
}

run_coverage() {
  cmake --preset release -B build-coverage -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS="-O1 --coverage" \
    -DRIDGES_BUILD_PYTHON=OFF -DRIDGES_BUILD_PROGRAM=ON -DBUILD_TESTING=ON >/dev/null
  cmake --build build-coverage >&2
  ctest --test-dir build-coverage -L 'core|filter' --parallel "$(nproc)" >&2
  (cd build-coverage && find Filters -name '*.gcda' -print0 | xargs -0 gcov -t -r -s "$root" 2>/dev/null) |
    python3 Testing/Evidence/coverage.py
}

for part in "${parts[@]}"; do
  "run_$part"
done
