# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin against the program, on a scan."""

import unittest

from program import AgainstProgram
from ridges_paraview import load_plugin


def setUpModule():
    load_plugin()


class TestAgainstProgram(AgainstProgram):
    def test_defaults(self):
        self.compare([])

    def test_what_suits_a_scan(self):
        self.compare(
            ["--minimum-number-of-points", "200", "--minimum-sharpness", "300"],
            Neighborhood="Point Count",
            MinimumNumberOfPoints=200,
            MinimumSharpness=300.0,
        )


del AgainstProgram  # not a test by itself

if __name__ == "__main__":
    unittest.main(verbosity=2)
