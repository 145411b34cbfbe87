# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Share of the lines of Filters that were run: gcov -t ... | python3 coverage.py

A line is run if it is so in any object file. Prints the ten files with the most lines that are not,
and the share of all.
"""

import collections
import re
import sys

LINE = re.compile(r"\s*([^:]+):\s*(\d+):")


def main():
    lines = collections.defaultdict(dict)
    file = ""
    for text in sys.stdin:
        match = LINE.match(text)
        if not match:
            continue
        count, number = match.group(1).strip(), int(match.group(2))
        if number == 0:
            if ":Source:" in text:
                file = text.split(":Source:")[1].strip()
            continue
        if count != "-" and "Filters/" in file:
            lines[file][number] = lines[file].get(number, False) or not count.startswith(("#", "="))
    missing = {name: sum(not run for run in of.values()) for name, of in lines.items()}
    for name in sorted(missing, key=missing.get, reverse=True)[:10]:
        print(f"{name}: {missing[name]} of {len(lines[name])} lines not run")
    total = sum(map(len, lines.values()))
    run = total - sum(missing.values())
    print(f"coverage: {run} of {total} lines, {100 * run / max(total, 1):.1f} %")


if __name__ == "__main__":
    main()
