#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Makes Debian packages for this release of Debian, 12 or 13, in build-debian/ : libvtkridges,
# libvtkridges-dev, python3-vtkridges, vtkridges and paraview-ridges.
#
#   .ci/debian-packages.sh [REVISION]
#
# REVISION, 1 if not given, is Debian's part of the version. lintian has to find no errors.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
revision=${1:-1}
work=$root/build-debian

"$root/.ci/install.sh" build-essential cmake dpkg-dev file gzip libboost-dev libcli11-dev libeigen3-dev libopenmpi-dev \
  libqt5svg5 libutfcpp-dev libvtk9-dev lintian ninja-build paraview paraview-dev python3-numpy python3-vtk9

options=(-G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr -DBUILD_TESTING=OFF
  -DPython3_EXECUTABLE=/usr/bin/python3 -DRIDGES_DEBIAN_PACKAGES=ON
  "-DRIDGES_DEBIAN_REVISION=$revision")
prefix=$("$root/.ci/paraview-prefix.sh" "$work/prefix")
paraview=("$prefix"/lib/*/cmake/paraview-*)

# Where the linker looks anyway: policy wants no RPATH to that. The plugin has a folder of its own.
cmake -S "$root" -B "$work/vtk" "${options[@]}" -DCMAKE_SKIP_INSTALL_RPATH=ON
cmake -S "$root" -B "$work/paraview" "${options[@]}" -DRIDGES_BUILD_PARAVIEW=ON \
  "-DParaView_DIR=${paraview[0]}"
rm -f "$work"/*.deb
for tree in vtk paraview; do
  cmake --build "$work/$tree"
  (cd "$work/$tree" && cpack -B "$work/cpack-$tree" && mv "$work/cpack-$tree"/*.deb "$work")
done

lintian --fail-on error "$work"/*.deb
ls -1sh "$work"/*.deb
