#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Ridges and umbilics on 1, 2, 3, 4 and 7 ranks against those of one, byte for byte: seven meshes, cut
# into strips, dealt at random, and by ParaView's Redistribute DataSet. Written into
# Filters/Documentation/LargeData.md; the comparisons one by one are printed. Fails where any differs.
#
#   Testing/Evidence/ranks.sh
#
# RedistributeDataSet is left out where there is no pvbatch.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cmake --build "$root/build" --target RidgesParallelTests >&2
RIDGES_DIRECTORY=$(mktemp -d)
trap 'rm -r "$RIDGES_DIRECTORY"' EXIT
export RIDGES_DIRECTORY VTK_SMP_MAX_THREADS=1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
tests=$root/build/bin/RidgesParallelTests
rows=$RIDGES_DIRECTORY/rows.md

# run RANKS TEST
run() {
  mpirun -np "$1" "$tests" "--gtest_filter=LargeMeshes.DISABLED_$2" --gtest_also_run_disabled_tests
}

prefix=
if command -v pvbatch >/dev/null; then
  prefix=$("$root/.ci/paraview-prefix.sh" "$root/build-paraview/prefix")
  run 1 AreWritten >&2
fi
for ranks in 1 2 3 4 7; do
  run $ranks GiveTheBytesOfOneRank || true # the table says what is not the same, or missing
  if [ -n "$prefix" ]; then
    PYTHONPATH=$prefix/lib/python3/dist-packages mpirun -np $ranks \
      pvbatch "$root/Testing/Evidence/redistribute.py" "$RIDGES_DIRECTORY"/*.vtp >&2
    run $ranks GiveTheBytesOfOneRankAfterRedistributeDataSet || true
  fi
done | tee /dev/stderr | grep '^| ' >"$rows"

# A row per mesh, a column per partition: on which numbers of ranks it is the same.
python3 - "$rows" <<'END' | python3 "$root/Testing/Evidence/into_page.py" \
  "$root/Filters/Documentation/LargeData.md" ranks
import sys

rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in open(sys.argv[1])]
partitions = list(dict.fromkeys(row[3] for row in rows))
print("| mesh | points | " + " | ".join(partitions) + " |")
print("|------|-------:|" + "---|" * len(partitions))
bad = False
for mesh, points in dict.fromkeys((row[0], row[1]) for row in rows):
    cells = []
    for partition in partitions:
        found = {row[2]: row[4] for row in rows if row[0] == mesh and row[3] == partition}
        same = [ranks for ranks in "12347" if found.get(ranks) == "identical"]
        other = [ranks for ranks in "12347" if found.get(ranks) != "identical"]
        cells.append(", ".join(same) + (f" **not {', '.join(other)}**" if other else ""))
        bad = bad or bool(other)
    print(f"| {mesh} | {points} | " + " | ".join(cells) + " |")
sys.exit(bad)
END
