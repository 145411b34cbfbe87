#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Builds the site in build-site/html with Doxygen: the pages, the gallery and the reference, with a
# search. Any warning is an error.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$root/.ci/install.sh" doxygen
cd "$root"
rm -rf build-site
mkdir -p build-site
RIDGES_VERSION=$(sed -n 's/^  VERSION \([0-9.]*\)$/\1/p' CMakeLists.txt)
export RIDGES_VERSION
doxygen Filters/Documentation/Doxyfile
# What the pages link to and Doxygen does not copy.
cp -r Examples LICENSE CITATION.cff build-site/html
echo "build-site/html/index.html"
