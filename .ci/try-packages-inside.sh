#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Installs Debian packages of vtkRidges on a machine without them, uses, upgrades and removes them.
#
#   .ci/try-packages-inside.sh DIRECTORY
#
# DIRECTORY has the .deb files. For a machine that may be spoiled: see try-debian-packages.sh.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
packages=$(cd "$1" && pwd)
export DEBIAN_FRONTEND=noninteractive
apt=(apt-get -qq -y -o Dpkg::Use-Pty=0 -o APT::Sandbox::User=root)
display=(xvfb-run -a -s "-screen 0 1280x1024x24 -noreset")
vtk=(libvtkridges libvtkridges-dev python3-vtkridges vtkridges)

step() { printf '\n== %s\n' "$1"; }

# Removes packages with their settings, and finds nothing of them.
remove() # PACKAGE...
{
  "${apt[@]}" purge "$@" >/dev/null
  local left
  left=$(find / -xdev \( -path "$root" -o -path "$packages" -o -path /tmp \) -prune \
    -o -iname '*ridges*' -print)
  left+=$(dpkg-query -W -f='${Package}\n' '*ridges*' 2>/dev/null || true)
  if [ -n "$left" ]; then
    echo "$0: left behind: $left" >&2
    exit 1
  fi
}

"${apt[@]}" update
work=$(mktemp -d)
cd "$work"

# ------------------------------------------------------------------------------------------ VTK

step "install"
files=()
for package in "${vtk[@]}"; do
  files+=("$packages/${package}"_*.deb)
done
"${apt[@]}" install --no-install-recommends "${files[@]}" >/dev/null
"${apt[@]}" install --no-install-recommends cmake g++ libgl1-mesa-dri make xauth xvfb >/dev/null
dpkg-query -W "${vtk[@]}"

step "program"
"${display[@]}" vtkridges --output blend
ls -1 blend*

step "C++"
cmake -S "$root/Examples/Cxx" -B Cxx >/dev/null
cmake --build Cxx
ctest --test-dir Cxx --output-on-failure

step "Python"
if apt-cache policy python3-pyvista | grep -q 'Candidate: [0-9]'; then
  "${apt[@]}" install --no-install-recommends python3-pyvista >/dev/null
  "${display[@]}" python3 "$root/Examples/Python/pyvista_salient.py" --picture salient.png
fi
"${display[@]}" python3 -B -m unittest discover -s "$root/Testing/Python" 2>python.log ||
  { cat python.log; exit 1; }
tail -n 3 python.log
python3 "$root/Examples/Python/salient.py"

step "upgrade"
for package in "${vtk[@]}"; do
  dpkg-deb -R "$packages/${package}"_*.deb next
  sed -i -E 's/^Version: .*/&.1/; s/(libvtkridges \(= [^)]*)\)/\1.1)/' next/DEBIAN/control
  dpkg-deb -b --root-owner-group next "$package.deb" >/dev/null
  rm -r next
done
"${apt[@]}" install ./*.deb >/dev/null
dpkg-query -W "${vtk[@]}"
python3 -c "import vtkridges; print(vtkridges.__version__)"

step "remove"
remove "${vtk[@]}"

# ------------------------------------------------------------------------------------------ ParaView

step "ParaView"
"${apt[@]}" purge python3-vtk9 >/dev/null # which python3-paraview cannot be beside
"${apt[@]}" install --no-install-recommends python3-paraview \
  "$packages"/{paraview-ridges,libvtkridges,vtkridges}_*.deb >/dev/null
folder=$(dirname "$(dpkg -L paraview-ridges | grep '/Ridges.so$')")
PV_PLUGIN_PATH=$folder "${display[@]}" pvpython "$root/Examples/ParaView/ridges.py"
"${display[@]}" paraview-ridges --dr "--test-script=$root/Testing/ParaView/menu.xml" --exit

step "the folder of the plugin elsewhere"
mkdir moved
cp -r "$folder" "$folder/../ridges.plugins.xml" moved
"${apt[@]}" purge paraview-ridges >/dev/null
PV_PLUGIN_PATH=$work/moved/Ridges "${display[@]}" pvbatch "$root/Examples/ParaView/ridges.py"
PV_PLUGIN_CONFIG_FILE=$work/moved/ridges.plugins.xml \
  "${display[@]}" pvbatch "$root/Examples/ParaView/ridges.py"
"${apt[@]}" download libcgal-demo # for the bunny
dpkg-deb --fsys-tarfile libcgal-demo_*.deb | tar -xO --wildcards '*/data.tar.gz' |
  tar -xz --strip-components 2 data/meshes/bunny00.off
RIDGES_PLUGIN=$work/moved/Ridges/Ridges.so RIDGES_PROGRAM=/usr/bin/vtkridges \
  RIDGES_PVSERVER=/usr/bin/pvserver RIDGES_MESH_DIRECTORY=$work \
  PYTHONPATH=$root/Testing/ParaView python3 -B "$root/Testing/ParaView/test_client_and_server.py"

step "remove"
remove vtkridges libvtkridges
rm -r "$work"
