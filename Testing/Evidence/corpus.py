# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every mesh of an archive or folder through all filters: python3 corpus.py PROGRAM MESHES [option ...]

PROGRAM is bin/RidgesCorpus of a build, MESHES the archive of the meshes of CGAL
(/usr/share/doc/libcgal-dev/data.tar.gz) or a folder. Each mesh has a process of its own and 60
seconds. Prints a table with a row for each mesh, and a summary; the exit code is 0 if there was no
crash, no NaN or infinity, no wrong sum of indices, no failed guarantee and no process out of time.

  --smallest N    only the N smallest meshes
  --seconds N     in place of 60
  --jobs N        processes at a time, 1
  --brief         only rows with something wrong, and the summary
"""

import argparse
import concurrent.futures
import os
import signal
import subprocess
import sys
import tarfile
import tempfile
import time
from pathlib import Path

COLUMNS = (
    ("mesh", "mesh"),
    ("points", "points"),
    ("border", "border"),
    ("few", "few"),
    ("ill", "ill"),
    ("invalid", "invalid"),
    ("folded", "folded"),
    ("umbilics", "umbilics"),
    ("sum", "index sum"),
    ("euler", "Euler"),
    ("ridges", "ridges"),
    ("salient", "salient"),
    ("seconds", "s"),
    ("outcome", "outcome"),
)


def read(path):
    """The content of the archive's or folder's meshes, in a folder."""
    if path.is_dir():
        return path
    folder = tempfile.TemporaryDirectory()  # pylint: disable=consider-using-with
    read.folders.append(folder)
    with tarfile.open(path) as archive:
        members = [m for m in archive.getmembers() if m.isfile() and "/meshes/" in m.name]
        archive.extractall(folder.name, members=members)
    return Path(folder.name)


read.folders = []


def outcome_of(code, facts, error):
    if code < 0:
        return f"CRASH: {signal.Signals(-code).name}"
    if "outcome" not in facts:
        last = [line for line in error.splitlines() if line.strip()][-1:]
        return f"CRASH: exit code {code}, {last}"
    return facts["outcome"]


def measure(program, path, seconds):
    begin = time.monotonic()
    with subprocess.Popen(
        [program, path], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace"
    ) as process:
        try:
            output, error = process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            process.kill()
            output, error = process.communicate()
            facts = {"outcome": f"HANGS: not done in {seconds} s"}
        else:
            facts = dict(line.split("\t", 1) for line in output.splitlines() if "\t" in line)
            facts["outcome"] = outcome_of(process.returncode, facts, error)
    facts["mesh"] = path.name
    facts["seconds"] = f"{time.monotonic() - begin:.1f}"
    facts["outcome"] = facts["outcome"].replace(str(path.parent) + os.sep, "")
    return facts


def is_refused(facts):
    return facts["outcome"].startswith("refused")


def is_wrong(facts):
    return not is_refused(facts) and facts["outcome"] != "done"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("meshes", type=Path)
    parser.add_argument("--smallest", type=int)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--brief", action="store_true")
    options = parser.parse_args()
    if not options.meshes.exists():
        print(f"Skipped: there is no {options.meshes}")
        return 0
    files = sorted(file for file in read(options.meshes).rglob("*") if file.is_file())
    if options.smallest:
        files = sorted(files, key=lambda file: file.stat().st_size)[: options.smallest]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        rows = list(pool.map(lambda file: measure(options.program, file, options.seconds), files))
    print("| " + " | ".join(title for _, title in COLUMNS) + " |")
    print("|" + "---|" * len(COLUMNS))
    for facts in rows:
        if is_wrong(facts) or not options.brief:
            print("| " + " | ".join(facts.get(name, "") for name, _ in COLUMNS) + " |")
    done = [facts for facts in rows if facts["outcome"] == "done"]
    closed = [facts for facts in done if facts["euler"]]
    points = sum(int(facts["points"]) for facts in done)
    print(
        f"\n{len(rows)} meshes: {len(done)} done ({points} points; {len(closed)} of them closed, with the index "
        f"sum of their topology), {sum(map(is_refused, rows))} refused with a reason, "
        f"{sum(map(is_wrong, rows))} wrong; the slowest took "
        f"{max(float(facts['seconds']) for facts in rows):.1f} s"
    )
    return 1 if any(map(is_wrong, rows)) else 0


if __name__ == "__main__":
    sys.exit(main())
