#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Prints the prefix where ParaView with its Python modules is found.
#
#   .ci/paraview-prefix.sh DIRECTORY
#
# find_package(ParaView) wants the Python modules beside the libraries, but Debian's python3-paraview
# cannot be installed next to python3-vtk9. Where it is not installed, its files are unpacked into
# DIRECTORY, with links to the installed ones around them; else the prefix is /usr.
set -euo pipefail

if dpkg-query -W -f='${db:Status-Abbrev}' python3-paraview 2>/dev/null | grep -q '^ii'; then
  echo /usr
  exit
fi

mkdir -p "$1"
prefix=$(cd "$1" && pwd)/usr
if [ ! -e "$prefix/complete" ]; then
  rm -rf "$prefix"
  cd "$1"
  rm -f python3-paraview_*.deb
  if ! apt-cache show python3-paraview >/dev/null 2>&1; then
    as_root=()
    [ "$(id -u)" -eq 0 ] || as_root=(sudo)
    "${as_root[@]}" apt-get update -qq >&2
  fi
  apt-get download -qq python3-paraview >&2
  dpkg-deb -x python3-paraview_*.deb .
  rm python3-paraview_*.deb
  # Links lead CMake back to /usr, which is why its own files are copied.
  dpkg -L paraview paraview-dev | grep -E '^/usr/(bin|lib)/' | while read -r file; do
    if [ -d "$file" ]; then
      mkdir -p ".$file"
    elif [[ $file == */cmake/* ]]; then
      cp "$file" ".$file"
    else
      ln -sf "$file" ".$file"
    fi
  done
  # find_package(ParaView) looks for modules without the suffix that Debian 13 gives them.
  find usr/lib/python3/dist-packages -name '*.cpython-*.so' | while read -r file; do
    ln -s "$(basename "$file")" "${file%.cpython-*}.so"
  done
  mkdir -p usr/include
  ln -s /usr/include/paraview-* usr/include/
  touch "$prefix/complete"
fi
echo "$prefix"
