#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing (Debian packages), then configures and builds the ParaView plugin into
# build-paraview/.
#
#   .ci/prepare-paraview.sh [testing]
#
# python3-vtk9 stays if it is there: see paraview-prefix.sh.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

packages=(build-essential cmake ninja-build libboost-dev libeigen3-dev
  paraview paraview-dev libopenmpi-dev libqt5svg5 libutfcpp-dev python3-numpy)
options=(-DPython3_EXECUTABLE=/usr/bin/python3)
if [ ! -f "$root/build-paraview/CMakeCache.txt" ]; then
  options+=(-DBUILD_TESTING=OFF)
fi
if [ "${1:-}" = testing ]; then
  packages+=(libcgal-demo libgl1-mesa-dri openmpi-bin xauth xvfb)
  options+=(-DBUILD_TESTING=ON)
fi
"$root/.ci/install.sh" "${packages[@]}"

prefix=$("$root/.ci/paraview-prefix.sh" "$root/build-paraview/prefix")
paraview=("$prefix"/lib/*/cmake/paraview-*)
cd "$root"
cmake --preset paraview "-DParaView_DIR=${paraview[0]}" "${options[@]}"
cmake --build --preset paraview
