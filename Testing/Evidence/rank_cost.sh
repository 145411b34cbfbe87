#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Time and memory of one, two and four ranks, one thread each, on an ellipsoid with and without noise,
# written into Filters/Documentation/LargeData.md.
#
#   Testing/Evidence/rank_cost.sh [FREQUENCY]
#
# The ellipsoid has 10 FREQUENCY^2 + 2 points, 640,000 by default, and another one four times as many.
# Of three runs each, the one with the least CPU time outside of MPI is taken: ranks that wait ask again and
# again, in MPI, and whatever else the machine does makes all of it slower.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cmake --build "$root/build" --target RidgesRankCost >&2
program=$root/build/bin/RidgesRankCost
export VTK_SMP_MAX_THREADS=1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
# What waits lets others work.
export OMPI_MCA_mpi_yield_when_idle=1

frequency=${1:-253}
large=$((2 * frequency))
{
  echo "| filter | points | noise, edges | ranks | CPU outside of MPI, s | in MPI, s | peak of rank 0, MiB | of others |"
  echo "|--------|-------:|-------------:|------:|----------------------:|----------:|--------------------:|----------:|"
  for stage in jets ridges; do
    for mesh in "$frequency 0" "$large 0" "$frequency 0.001"; do
      for ranks in 1 2 4; do
        for _ in 1 2 3; do
          # shellcheck disable=SC2086 # two arguments
          mpirun -np $ranks "$program" $stage $mesh
        done | sort -t '|' -n -k 6 | head -n 1
      done
    done
  done | sed 's/^| jets/| `vtkPJetFitting`/; s/^| ridges/| `vtkPRidgesAndUmbilics`/'
} | python3 "$root/Testing/Evidence/into_page.py" "$root/Filters/Documentation/LargeData.md" "rank cost"
