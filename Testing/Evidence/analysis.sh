#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Analysis by compilers, tools and sanitizers. Prints a line for each finding; a row with the result
# goes into the table in CONTRIBUTING.md. Without arguments the first three parts, in half an hour;
# the others build trees of their own.
#
#   Testing/Evidence/analysis.sh [PART]...
#
#   cppcheck     warnings, and what is slow or not portable, in Filters/
#   conversion   of numbers that may change their value, in the rooms of Filters/Core, by -Wconversion
#                and -Wsign-conversion of the compiler
#   coverage     lines of Filters/ that the tests with the labels core and filter run, by gcov, in
#                build-coverage/
#   address      these tests under the address and undefined behaviour sanitizers of clang, in
#                build-fuzz/
#   thread       these tests under the thread sanitizer, with seven of VTK's own threads, in
#                build-tsan/
#   tidy         clang-tidy over the sources that build/ compiles
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
parts=("$@")
[ ${#parts[@]} -gt 0 ] || parts=(cppcheck conversion coverage)

# row WHAT RESULT
row() {
  echo "| $1 | $(date +%F) | $2 |" |
    python3 Testing/Evidence/into_page.py CONTRIBUTING.md analysis --rows
}

run_cppcheck() {
  .ci/install.sh cppcheck
  local found
  found=$(cppcheck --language=c++ --std=c++17 --enable=warning,performance,portability --inline-suppr \
    --suppress=missingInclude --suppress=unknownMacro --quiet --template='{file}:{line}: {id}: {message}' \
    -I Filters/Core Filters 2>&1 | grep -v '^$' | sort -u || true)
  [ -z "$found" ] || echo "$found"
  row "cppcheck of \`Filters\`" "$(grep -c . <<<"$found" || true) findings"
}

run_conversion() {
  local flags=(-std=c++17 -fsyntax-only -Wconversion -Wsign-conversion -I Filters/Core
    -isystem /usr/include/eigen3)
  local found
  found=$(find Filters/Core -name '*.cxx' ! -name 'JetBatch*' ! -name 'NestedJet*' -print0 | sort -z |
    xargs -0 -P 2 -n 4 "${CXX:-c++}" "${flags[@]}" 2>&1 | grep 'warning:' | sort -u || true)
  [ -z "$found" ] || sed 's/ \[/\t[/' <<<"$found"
  row "\`-Wconversion\` in \`Filters/Core\`" \
    "$(grep -c '\[-Wconversion\]\|\[-Wfloat-conversion\]' <<<"$found" || true) that may change a value, $(
      grep -c 'Wsign-conversion' <<<"$found" || true) of sign"
}

run_coverage() {
  cmake --preset release -B build-coverage -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS="-O1 --coverage" \
    -DRIDGES_BUILD_PYTHON=OFF -DRIDGES_BUILD_PROGRAM=ON -DBUILD_TESTING=ON >/dev/null
  cmake --build build-coverage >&2
  ctest --test-dir build-coverage -L 'core|filter' --parallel "$(nproc)" >&2 || true
  local found
  found=$( (cd build-coverage && find Filters -name '*.gcda' -print0 | xargs -0 gcov -t -r -s "$root" 2>/dev/null) |
    python3 Testing/Evidence/coverage.py)
  echo "$found"
  row "line coverage of \`Filters\`" "$(sed -n 's/^coverage: //p' <<<"$found")"
}

# tests TREE: how many there are, how many failed, and how many reports of a sanitizer.
tests() {
  local log=$1/analysis.log
  ctest --test-dir "$1" -L 'core|filter' --parallel "$(nproc)" --output-on-failure --timeout 3000 >"$log" 2>&1 ||
    true
  grep -E 'Failed|Timeout' "$log" >&2 || true
  local counts='s/^[0-9]*% tests passed, \([0-9]*\) tests failed out of \([0-9]*\)$/\2 tests, \1 failed/p'
  echo "$(sed -n "$counts" "$log"), $(
    grep -c 'ERROR: AddressSanitizer\|runtime error:\|WARNING: ThreadSanitizer' "$log" || true) reports"
}

run_address() {
  .ci/install.sh clang
  cmake --preset fuzz -DRIDGES_BUILD_PROGRAM=ON -DBUILD_TESTING=ON >/dev/null
  cmake --build --preset fuzz >&2
  # Leaks are those of what VTK keeps to the end of the process.
  row "address and undefined behaviour sanitizers" "$(ASAN_OPTIONS=detect_leaks=0 tests build-fuzz)"
}

run_thread() {
  cmake --preset tsan -DRIDGES_BUILD_PROGRAM=OFF -DBUILD_TESTING=ON >/dev/null
  cmake --build --preset tsan >&2
  row "thread sanitizer, seven threads" \
    "$(VTK_SMP_BACKEND_IN_USE=STDThread VTK_SMP_MAX_THREADS=7 tests build-tsan)"
}

run_tidy() {
  .ci/install.sh clang-tidy
  local found
  found=$(.ci/tidy 2>/dev/null | grep -E 'warning:|error:' | sort -u || true)
  [ -z "$found" ] || echo "$found"
  row "clang-tidy, warnings as errors" "$(grep -c . <<<"$found" || true) findings"
}

for part in "${parts[@]}"; do
  "run_$part"
done
