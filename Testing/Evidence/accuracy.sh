#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Writes the tables of errors into Filters/Documentation/Accuracy.md; a few minutes. Needs CGAL.
#
#   Testing/Evidence/accuracy.sh             beside CGAL and vtkCurvatures
#   Testing/Evidence/accuracy.sh --others    beside libigl and PyMeshLab, too, from PyPI, in a virtual
#                                            environment in build/
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
here=$root/Testing/Evidence
page=$root/Filters/Documentation/Accuracy.md
cmake --build "$root/build" --target RidgesAccuracy >&2
meshes=$(mktemp -d)
trap 'rm -rf "$meshes"' EXIT
"$root/build/bin/RidgesAccuracy" --write "$meshes" | python3 "$here/into_page.py" "$page" accuracy
if [ "${1:-}" = --others ]; then
  environment=$root/build/evidence-environment
  [ -d "$environment" ] || python3 -m venv "$environment"
  "$environment/bin/pip" install --quiet libigl numpy pymeshlab
  "$environment/bin/python" "$here/accuracy_of_others.py" "$meshes" |
    python3 "$here/into_page.py" "$page" accuracy-of-others
fi
