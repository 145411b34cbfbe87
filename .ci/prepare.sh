#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing (Debian packages), then configures and builds into build/.
#
#   .ci/prepare.sh [program] [python] [testing] [benchmarks]
#
# Each argument adds a part to the build, with the packages it needs. The first call decides what
# is left out; later ones only add.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

packages=(build-essential cmake ninja-build libvtk9-dev libeigen3-dev
  libboost-dev)
options=(-DPython3_EXECUTABLE=/usr/bin/python3)
if [ ! -f "$root/build/CMakeCache.txt" ]; then
  options+=(-DRIDGES_BUILD_PROGRAM=OFF -DRIDGES_BUILD_PYTHON=OFF -DBUILD_TESTING=OFF)
fi

for part in "$@"; do
  case $part in
    program)
      packages+=(libcli11-dev libgl1-mesa-dri xauth xvfb)
      options+=(-DRIDGES_BUILD_PROGRAM=ON)
      ;;
    python)
      packages+=(python3-numpy python3-vtk9)
      options+=(-DRIDGES_BUILD_PYTHON=ON)
      ;;
    testing)
      packages+=(libcgal-demo libcgal-dev libgtest-dev openmpi-bin)
      options+=(-DBUILD_TESTING=ON)
      ;;
    benchmarks)
      packages+=(libbenchmark-dev libcgal-demo libcgal-dev)
      options+=(-DRIDGES_BUILD_BENCHMARKS=ON)
      ;;
    *)
      echo "$0: unknown part '$part'" >&2
      exit 2
      ;;
  esac
done

"$root/.ci/install.sh" "${packages[@]}"

cd "$root"
cmake --preset release "${options[@]}"
cmake --build --preset release
