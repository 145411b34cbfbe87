#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Writes the statistics of umbilics into Filters/Documentation/Evidence.md; two minutes.
#
#   Testing/Evidence/statistics.sh [OPTION OF RidgesCensus]...
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cmake --build "$root/build" --target RidgesCensus >&2
"$root/build/bin/RidgesCensus" "$@" |
  python3 "$root/Testing/Evidence/into_page.py" "$root/Filters/Documentation/Evidence.md" statistics
