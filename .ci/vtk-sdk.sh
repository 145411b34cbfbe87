#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Makes a VTK SDK: what a module is compiled with to work beside the vtk of PyPI.
#
#   .ci/vtk-sdk.sh DIRECTORY [PYTHON]
#
# PyPI's vtk has libraries only, and its vtk-sdk is not there for Linux. Headers, CMake files and
# wrapping tools of the same version come from Debian's packages of another suite (RIDGES_SDK_SUITE,
# forky if not set), unpacked and not installed; the libraries from PyPI, for PYTHON (python3),
# which has pip. Prints the version. A directory made before for the same interpreter is used again.
set -euo pipefail
directory=${1:?usage: .ci/vtk-sdk.sh DIRECTORY [PYTHON]}
python=${2:-python3}
suite=${RIDGES_SDK_SUITE:-forky}
keys=/usr/share/keyrings/debian-archive-keyring.gpg

tag=$("$python" -c 'import sys; print("cp%d%d" % sys.version_info[:2])')
if [ "$(cat "$directory/complete" 2>/dev/null)" = "$tag $suite" ]; then
  cat "$directory/version"
  exit
fi
rm -rf "$directory"
mkdir -p "$directory"
directory=$(cd "$directory" && pwd)

# ------------------------------------------------------------------------------- Debian's packages

# The same server as for the packages of this machine, with lists of its own.
site=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' | head -n 1)
mkdir -p "$directory"/apt/{state/lists/partial,cache/archives/partial,debs}
echo "deb [signed-by=$keys] ${site:?no package lists: apt-get update} $suite main" \
  >"$directory/apt/sources.list"
apt=(-qq -o "Dir::Etc::sourcelist=$directory/apt/sources.list" -o Dir::Etc::sourceparts=-
  -o Acquire::Check-Valid-Until=false # a mirror may be a snapshot
  -o "Dir::State=$directory/apt/state" -o "Dir::Cache=$directory/apt/cache" -o APT::Sandbox::User=root)
apt-get "${apt[@]}" update >&2
full=$(apt-cache "${apt[@]}" show libvtk9-dev | sed -n 's/^Version: //p' | head -n 1)
version=${full%%[+-]*} # 9.6.2
series=${version%.*}
cd "$directory/apt/debs"
apt-get "${apt[@]}" download libvtk9-dev vtk9 python3-vtk9 "libvtk$series" libc6 >&2

unpack() # PACKAGE PATTERN...
{
  local package=$1
  shift
  dpkg-deb --fsys-tarfile "$directory/apt/debs/$package"_*.deb | tar -x -C "$directory" --wildcards "$@"
}
unpack libvtk9-dev "./usr/include/vtk-$series" './usr/lib/*/cmake'
unpack vtk9 './usr/bin/*'
unpack python3-vtk9 './usr/bin/vtkWrap*'
unpack "libvtk$series" '*/libvtkWrappingTools*' './usr/lib/*/hierarchy'
unpack libc6 '*/ld-linux*' '*/libc.so.*' '*/libm.so.*'
rm -rf "$directory/apt"

# The tools want the C library that they were built with.
cd "$directory/usr"
libraries=$(cd lib/*-linux-gnu && pwd)
loader=$(find "$directory/usr" -name 'ld-linux*.so.*' -print -quit)
mkdir tools
for tool in bin/vtkWrap*; do
  mv "$tool" tools/
  cat >"$tool" <<END
#!/bin/sh
exec "$loader" --library-path "$libraries" "$directory/usr/tools/$(basename "$tool")" "\$@"
END
  chmod +x "$tool"
done

# ------------------------------------------------------------------------------ PyPI's libraries

"$python" -m pip download -q --disable-pip-version-check --no-deps --only-binary :all: \
  -d "$directory" "vtk==$version" >&2
"$python" -m zipfile -e "$directory"/vtk-"$version"-*.whl wheel
rm "$directory"/vtk-"$version"-*.whl

# Debian's names for the libraries, and the ones in the wheel.
core=$(basename wheel/vtkmodules/libvtkWrappingPythonCore*.so)
cd "$libraries/cmake/vtk-$series"
sed -i -E \
  -e "s#lib/[a-z0-9_]+-linux-gnu/libvtkWrappingPythonCore[0-9.]+-$series\.so[0-9.]*#wheel/vtkmodules/$core#" \
  -e "s#lib/[a-z0-9_]+-linux-gnu/(libvtk[A-Za-z0-9_]+)-$series\.so[0-9.]*#wheel/vtkmodules/\1.so#" \
  -e '/_cmake_import_check_files_for/d' \
  VTK-targets-*.cmake VTKPython-targets-*.cmake
sed -i -E 's/^( *set\("\$\{CMAKE_FIND_PACKAGE_NAME\}_PYTHONPATH") .*/\1 "wheel")/' vtk-config.cmake
# These are not linked, and Debian's packages of them are not here.
sed -i -E 's/^(set\("\$\{CMAKE_FIND_PACKAGE_NAME\}_HAS_(VISKORES|VTKm)") "ON"\)/\1 "OFF")/' vtk-config.cmake
sed -i -e '/^foreach *(_target "viskores::/s/"viskores::[a-z_]*"//g' \
  -e 's/nlohmann_json::nlohmann_json//' VTK-targets.cmake

# The wheel is for one interpreter, and not for Debian's.
sed -i -E "/find_package\(Python3/,/\)/s/^( *)3\.[0-9]+\$/\1${tag:2:1}.${tag:3}/" \
  VTK-vtk-module-find-packages.cmake

# What differs in how the two were configured: Debian has TBB.
sed -i -E \
  -e 's/^#define VTK_SMP_TBB$/#define VTK_SMP_Sequential/' \
  -e 's/^#define VTK_SMP_BACKEND "TBB"/#define VTK_SMP_BACKEND "Sequential"/' \
  -e 's/^(#define VTK_SMP_(ENABLE|DEFAULT_IMPLEMENTATION)_TBB) 1/\1 0/' \
  -e 's/^(#define VTK_SMP_DEFAULT_IMPLEMENTATION_SEQUENTIAL) 0/\1 1/' \
  "$directory/usr/include/vtk-$series/vtkSMP.h"

echo "$version" >"$directory/version"
echo "$tag $suite" >"$directory/complete"
echo "$version"
