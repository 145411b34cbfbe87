#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Builds everything and runs the tests, those of the ParaView plugin as well unless it is left out.
#
#   Testing/run.sh [--no-paraview] [CTEST OPTION]...
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

trees=(build)
if [ "${1:-}" = --no-paraview ]; then
  shift
else
  trees+=(build-paraview)
fi

"$root/.ci/prepare.sh" program python testing
if [ ${#trees[@]} -gt 1 ]; then
  "$root/.ci/prepare-paraview.sh" testing
fi

status=0
for tree in "${trees[@]}"; do
  ctest --test-dir "$root/$tree" --parallel "$(nproc)" --output-on-failure "$@" || status=$?
done
exit $status
