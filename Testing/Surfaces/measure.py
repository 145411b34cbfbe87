# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""RidgesTruth on ten surfaces, summed: python3 measure.py PROGRAM [option ...]

PROGRAM is build/bin/RidgesTruth; the options are handed on to it, as --points 5000, --noise 0.01,
--exact or --cache DIRECTORY. Prints a line for each surface and one for all of them: umbilics right
(and spurious), ridges found whole, missing and spurious, lines of one type of how many there are,
and the share of the length with the wrong type, in the mean over the surfaces.

Not run by ctest: true ridges take minutes, unless they are cached.
"""

import re
import subprocess
import sys

SURFACES = ["ellipsoid", "blend", "sphere", "sphere:2", "torus", "torus:2", "double torus", "blob", "blob:7",
            "metaballs"]

LINE = re.compile(
    r"umbilics (\d+)/(\d+) right \(\+(\d+) spurious.*ridges (\d+)/(\d+) whole, (\d+) missing, (\d+) spurious; "
    r"typed lines (\d+)/(\d+), wrong type ([\d.]+) %")


def text_of(counts, wrong):
    return ("umbilics {}/{} (+{}), ridges {}/{}, missing {}, spurious {}, lines {}/{}".format(*counts) +
            f", wrong type {wrong:.2f} %")


def main():
    program, *options = sys.argv[1:]
    sums = [0] * 9
    wrong = 0.0
    for surface in SURFACES:
        output = subprocess.run([program, surface, "--brief", *options], check=True, capture_output=True,
                                text=True).stdout
        found = LINE.search(output).groups()
        counts = [int(count) for count in found[:9]]
        fit = re.search("fit: (.*)", output)
        print(f"{surface:12}", text_of(counts, float(found[9])), "-", fit.group(1) if fit else "", flush=True)
        sums = [a + b for a, b in zip(sums, counts)]
        wrong += float(found[9]) / len(SURFACES)
    print("all         ", text_of(sums, wrong))


if __name__ == "__main__":
    main()
