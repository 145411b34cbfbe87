#!/usr/bin/env bash
# Builds everything and runs the tests.
#
#   Testing/run.sh [CTEST OPTION]...
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/.ci/prepare.sh" program python testing
exec ctest --test-dir "$root/build" --output-on-failure "$@"
