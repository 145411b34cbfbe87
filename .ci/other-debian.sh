#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Runs the two commands of the README on another release of Debian, in a clean chroot.
#
#   .ci/other-debian.sh SUITE [DIRECTORY]
#
# SUITE is bookworm or trixie. DIRECTORY becomes the chroot; one that is there already is used as it
# is, but always with a new clone of HEAD. Needs root and debootstrap. If CCACHE_DIR is set, ccache
# is used, with that directory.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
suite=${1:?usage: .ci/other-debian.sh SUITE [DIRECTORY]}
directory=${2:-/var/tmp/vtkridges-$suite}

# In a namespace of its own: with this script, however it ends, go its mounts and all it has started.
if [ -z "${RIDGES_IN_NAMESPACE:-}" ]; then
  RIDGES_IN_NAMESPACE=1 exec unshare --mount --pid --fork --kill-child "${BASH_SOURCE[0]}" "$@"
fi

[ -e "$directory/etc/debian_version" ] ||
  debootstrap --variant=minbase "$suite" "$directory" >"$directory.log"
for system in sys dev; do
  mount --rbind "/$system" "$directory/$system"
done
mount -t proc proc "$directory/proc"

rm -rf "$directory/vtkridges"
git clone --quiet --no-hardlinks "$root" "$directory/vtkridges"

variables=(HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin)
if [ -n "${CCACHE_DIR:-}" ]; then
  mkdir -p "$directory/ccache"
  mount --bind "$CCACHE_DIR" "$directory/ccache"
  variables+=(CCACHE_DIR=/ccache CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache)
  env -i "${variables[@]}" chroot "$directory" /vtkridges/.ci/install.sh ccache
fi

for command in Examples/run.sh Testing/run.sh; do
  SECONDS=0
  env -i "${variables[@]}" chroot "$directory" "/vtkridges/$command"
  echo "$suite: $command took $((SECONDS / 60)) min $((SECONDS % 60)) s"
done
