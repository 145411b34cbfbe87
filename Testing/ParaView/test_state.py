# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Saved states: loaded again, with the plugin, they give the same."""

import os
import tempfile
import unittest
from pathlib import Path

import numpy as np
from paraview import simple
from ridges_paraview import arrays, delete_all, fetch, load_plugin

EXAMPLE = Path(__file__).resolve().parents[2] / "Examples" / "ParaView" / "ridges.pvsm"


def setUpModule():
    load_plugin()


class TestState(unittest.TestCase):
    def tearDown(self):
        for view in simple.GetViews():
            simple.Delete(view)
        delete_all()

    def test_a_saved_state_gives_the_same(self):
        whole = simple.RidgesAndUmbilics(
            registrationName="All", Input=simple.RidgeExampleSource(Frequency=16)
        )
        whole.Neighborhood = "Rings"
        whole.NumberOfRings = 4
        whole.MinimumSharpness = 5.0
        expected = arrays(fetch(whole))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "state.pvsm")
            simple.SaveState(path)
            delete_all()
            self.assertIsNone(simple.FindSource("All"))
            simple.LoadState(path)
        loaded = simple.FindSource("All")
        self.assertEqual(loaded.Neighborhood, "Rings")
        self.assertEqual(loaded.MinimumSharpness, 5.0)
        found = arrays(fetch(loaded))
        self.assertEqual(set(found), set(expected))
        for name, values in expected.items():
            np.testing.assert_array_equal(found[name], values, err_msg=name)

    def test_the_example_loads_and_runs(self):
        simple.LoadState(str(EXAMPLE))
        whole = simple.FindSource("RidgesAndUmbilics1")
        self.assertGreater(fetch(whole).GetNumberOfLines(), 10)
        self.assertEqual(fetch(whole, 1).GetNumberOfPoints(), 8)
        view = simple.GetActiveView()
        ridges = simple.GetDisplayProperties(simple.OutputPort(whole, 0), view)
        self.assertEqual(ridges.ColorArrayName[:], ["CELLS", "RidgeType"])
        self.assertEqual(ridges.Representation, "Lines In Front")
        umbilics = simple.GetDisplayProperties(simple.OutputPort(whole, 1), view)
        self.assertEqual(umbilics.Representation, "Balls")


if __name__ == "__main__":
    unittest.main(verbosity=2)
