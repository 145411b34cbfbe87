#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# How soon filters end that are aborted, written into Filters/Documentation/Evidence.md; forty minutes at
# the default size, two at 100.
#
#   Testing/Evidence/abort.sh [FREQUENCY]
#
# On an ellipsoid of 10 FREQUENCY^2 + 2 points, 2.6 million by default, and noise of 0.01 edges.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cmake --build "$root/build" --target RidgesAbort >&2
VTK_SMP_MAX_THREADS=1 "$root/build/bin/RidgesAbort" "${1:-510}" |
  python3 "$root/Testing/Evidence/into_page.py" "$root/Filters/Documentation/Evidence.md" abort
