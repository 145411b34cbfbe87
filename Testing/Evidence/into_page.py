# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a table into a page: COMMAND | python3 into_page.py PAGE NAME [--rows]

What is read from standard input replaces what is between the lines `<!-- NAME -->` and
`<!-- end of NAME -->` of the page, below the date and the kind of machine. It is printed, too.
With --rows each row replaces that with the same first cell, or is put behind the others; the date
and the kind of machine are up to the row.
"""

import datetime
import os
import re
import sys
from pathlib import Path


def kind_of_machine():
    cores = len(os.sched_getaffinity(0))
    numbers = {1: "one core", 2: "two cores", 4: "four cores", 8: "eight cores"}
    match = re.search(r"model name\s*:\s*(.*)", Path("/proc/cpuinfo").read_text(encoding="utf-8"))
    name = match.group(1).strip() if match else "unknown processor"
    article = "an" if name[:1] in "AEIOU" else "a"
    return f"{numbers.get(cores, f'{cores} cores')} of {article} {name}"


def replace(page, name, change):
    begin, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->\n"
    content = page.read_text(encoding="utf-8")
    if content.count(begin) != 1 or content.count(end) != 1:
        sys.exit(f"{page.name} has no place for {name}")
    before, rest = content.split(begin)
    old, after = rest.split(end)
    page.write_text(before + begin + change(old) + end + after, encoding="utf-8")


def first_cell(line):
    return line.split("|")[1].strip() if line.startswith("|") else None


def with_rows(old, rows):
    """The table with these rows in place of those with the same first cells."""
    lines = old.strip("\n").splitlines()
    for row in rows:
        places = [i for i, line in enumerate(lines) if first_cell(line) == first_cell(row)]
        at = places[0] if places else len(lines)
        lines[at : at + 1] = [row]
    return "\n" + "\n".join(lines) + "\n\n"


def main():
    page, name = Path(sys.argv[1]), sys.argv[2]
    table = sys.stdin.read().strip("\n")
    sys.stdout.write(table + "\n")
    if not table:
        sys.exit("there is no table")
    if "--rows" in sys.argv[3:]:
        replace(page, name, lambda old: with_rows(old, table.splitlines()))
        return
    head = f"Measured on {datetime.date.today()}, on {kind_of_machine()}."
    replace(page, name, lambda _: f"\n{head}\n\n{table}\n\n")


if __name__ == "__main__":
    main()
