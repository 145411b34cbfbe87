#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Runs the meshes that CGAL is distributed with (Debian: libcgal-demo) through all filters, and writes
# the table into Filters/Documentation/Evidence.md; two minutes.
#
#   Testing/Evidence/corpus.sh              with the build in build/
#   Testing/Evidence/corpus.sh --sanitize   with that in build-fuzz/, which needs clang; the table is
#                                           printed only
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
meshes=/usr/share/doc/libcgal-dev/data.tar.gz
corpus=(python3 "$root/Testing/Evidence/corpus.py")
if [ "${1:-}" = --sanitize ]; then
  "$root/.ci/install.sh" clang
  cd "$root"
  cmake --preset fuzz -DRIDGES_BUILD_PROGRAM=ON -DBUILD_TESTING=ON >/dev/null
  cmake --build --preset fuzz --target RidgesCorpus
  # Leaks are those of what VTK keeps to the end of the process.
  exec env ASAN_OPTIONS=detect_leaks=0 "${corpus[@]}" build-fuzz/bin/RidgesCorpus "$meshes" --brief
fi
cmake --build "$root/build" --target RidgesCorpus >&2
"${corpus[@]}" "$root/build/bin/RidgesCorpus" "$meshes" |
  python3 "$root/Testing/Evidence/into_page.py" "$root/Filters/Documentation/Evidence.md" corpus
