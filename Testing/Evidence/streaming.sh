#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Time and memory of a mesh that one rank takes piece by piece, written into
# Filters/Documentation/LargeData.md.
#
#   Testing/Evidence/streaming.sh [FREQUENCY]
#
# On an ellipsoid of 10 FREQUENCY^2 + 2 points, 2.6 million by default, and one thread. The digests
# have to be the same in all rows of a filter.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cmake --build "$root/build" --target RidgesStreaming >&2
frequency=${1:-510}
directory=$(mktemp -d)
trap 'rm -r "$directory"' EXIT
program=$root/build/bin/RidgesStreaming
export VTK_SMP_MAX_THREADS=1
"$program" write "$frequency" "$directory"
{
  echo "$((10 * frequency * frequency + 2)) points:"
  echo
  echo "| filter | pieces | CPU, s | input, MiB | peak beyond it, MiB | digest |"
  echo "|--------|-------:|-------:|-----------:|--------------------:|--------|"
  for stage in jets ridges; do
    "$program" $stage "$directory/mesh.vtp" 1
    "$program" $stage "$directory/mesh-8.pvtp" 8
    "$program" $stage "$directory/mesh-64.pvtp" 64
  done | sed 's/^| jets/| `vtkPJetFitting`/; s/^| ridges/| `vtkPRidgesAndUmbilics`/'
} | python3 "$root/Testing/Evidence/into_page.py" "$root/Filters/Documentation/LargeData.md" streaming
