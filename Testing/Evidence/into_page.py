# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a table into a page: COMMAND | python3 into_page.py PAGE NAME

What is read from standard input replaces what is between the lines `<!-- NAME -->` and
`<!-- end of NAME -->` of the page, below the date and the kind of machine. It is printed, too.
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


def replace(page, name, text):
    begin, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->\n"
    content = page.read_text(encoding="utf-8")
    if content.count(begin) != 1 or content.count(end) != 1:
        sys.exit(f"{page.name} has no place for {name}")
    before, rest = content.split(begin)
    after = rest.split(end)[1]
    page.write_text(before + begin + text + end + after, encoding="utf-8")


def main():
    page, name = Path(sys.argv[1]), sys.argv[2]
    table = sys.stdin.read().strip("\n")
    sys.stdout.write(table + "\n")
    if not table:
        sys.exit("there is no table")
    replace(page, name, f"\nMeasured on {datetime.date.today()}, on {kind_of_machine()}.\n\n{table}\n\n")


if __name__ == "__main__":
    main()
