#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Builds the program vtkridges and draws the ridges of a mesh, of an example surface if none is
# given. "bunny" stands for the Stanford bunny that CGAL's Debian packages carry.
#
#   Examples/run.sh [MESH | bunny] [OPTION OF vtkridges]...
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
archive=/usr/share/doc/libcgal-dev/data.tar.gz
bunny=data/meshes/bunny00.off

name=example
mesh=()
if [ $# -gt 0 ] && [[ $1 != -* ]]; then
  name=$(basename "${1%.*}")
  mesh=("$1")
  shift
fi

"$root/.ci/prepare.sh" program

if [ "${mesh[*]}" = bunny ]; then
  "$root/.ci/install.sh" libcgal-demo
  mkdir -p "$root/build/meshes"
  tar -xzf "$archive" -C "$root/build/meshes" "$bunny"
  mesh=("$root/build/meshes/$bunny")
fi

output=$root/build/output
mkdir -p "$output"
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$root/build/bin/vtkridges" "${mesh[@]}" --output "$output/$name" "$@"

echo "Written:"
ls -1 "$output/$name"-ridges.vtp "$output/$name"-umbilics.vtp "$output/$name".png
