#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Makes the Debian packages of a release and tries them, in clean chroots.
#
#   .ci/try-debian-packages.sh SUITE [DIRECTORY]
#
# SUITE is bookworm or trixie. Under DIRECTORY, base is what debootstrap makes, build the chroot
# where the packages are made, and use a new one where they are installed, used, upgraded and removed:
# see try-packages-inside.sh. base and build are used again. Needs root and debootstrap. If CCACHE_DIR
# is set, ccache is used, with that directory.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
suite=${1:?usage: .ci/try-debian-packages.sh SUITE [DIRECTORY]}
directory=${2:-/var/tmp/vtkridges-packages-$suite}

# In a namespace of its own: with this script, however it ends, go its mounts and all it has started.
if [ -z "${RIDGES_IN_NAMESPACE:-}" ]; then
  RIDGES_IN_NAMESPACE=1 exec unshare --mount --pid --fork --kill-child "${BASH_SOURCE[0]}" "$@"
fi

mkdir -p "$directory"
[ -e "$directory/base/etc/debian_version" ] ||
  debootstrap --variant=minbase "$suite" "$directory/base" >"$directory/base.log"
# Chroots need not outlive a power failure.
echo force-unsafe-io >"$directory/base/etc/dpkg/dpkg.cfg.d/unsafe-io"
[ -e "$directory/build" ] || cp -a "$directory/base" "$directory/build"
rm -rf --one-file-system "$directory/use"
cp -a "$directory/base" "$directory/use"

variables=(HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin)
for chroot in build use; do
  for system in sys dev; do
    mount --rbind "/$system" "$directory/$chroot/$system"
  done
  mount -t proc proc "$directory/$chroot/proc"
  # Its build directory stays, for the next time.
  mkdir -p "$directory/$chroot/vtkridges"
  git -C "$root" -c tar.umask=0022 archive HEAD | tar -x -m -C "$directory/$chroot/vtkridges"
done
compilers=(${CMAKE_BUILD_PARALLEL_LEVEL:+"CMAKE_BUILD_PARALLEL_LEVEL=$CMAKE_BUILD_PARALLEL_LEVEL"})
if [ -n "${CCACHE_DIR:-}" ]; then
  mkdir -p "$directory/build/ccache"
  mount --bind "$CCACHE_DIR" "$directory/build/ccache"
  compilers+=(CCACHE_DIR=/ccache CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache)
  env -i "${variables[@]}" chroot "$directory/build" /vtkridges/.ci/install.sh ccache
fi

env -i "${variables[@]}" "${compilers[@]}" \
  chroot "$directory/build" /vtkridges/.ci/debian-packages.sh
mkdir -p "$directory/use/packages"
cp "$directory"/build/vtkridges/build-debian/*.deb "$directory/use/packages"
env -i "${variables[@]}" chroot "$directory/use" /vtkridges/.ci/try-packages-inside.sh /packages
echo "$suite: packages made, installed, used, upgraded and removed"
