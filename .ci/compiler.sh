#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Runs a command with Debian's gcc or clang as the compiler of new build trees.
#
#   .ci/compiler.sh gcc|clang COMMAND...
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case ${1:?usage: .ci/compiler.sh gcc|clang COMMAND...} in
  gcc)
    "$root/.ci/install.sh" gcc g++
    export CC=gcc CXX=g++
    ;;
  clang)
    "$root/.ci/install.sh" clang
    export CC=clang CXX=clang++
    ;;
  *)
    echo "$0: unknown compiler '$1'" >&2
    exit 2
    ;;
esac
shift
exec "$@"
