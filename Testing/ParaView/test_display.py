# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Display defaults of the outputs: representation, arrays, colors, legend and sizes."""

import os
import unittest

from paraview import simple
from ridges_paraview import delete_all, load_plugin


def setUpModule():
    load_plugin()


class TestDisplay(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.view = simple.CreateRenderView(ViewSize=[400, 300])
        cls.whole = simple.RidgesAndUmbilics(Input=simple.RidgeExampleSource(Frequency=32))
        cls.displays = [
            simple.Show(simple.OutputPort(cls.whole, port), cls.view) for port in range(3)
        ]

    @classmethod
    def tearDownClass(cls):
        simple.Delete(cls.view)
        delete_all()

    def test_ridges_are_colored_by_type_and_umbilics_by_index(self):
        ridges, umbilics, mesh = self.displays
        self.assertEqual(ridges.ColorArrayName[:], ["CELLS", "RidgeType"])
        self.assertEqual(umbilics.ColorArrayName[:], ["POINTS", "Index"])
        self.assertEqual(mesh.ColorArrayName[1], "")

    def test_the_stages_are_shown_alike(self):
        jets = simple.JetFitting(Input=simple.RidgeExampleSource(Frequency=16))
        umbilics = simple.UmbilicDetection(Input=jets)
        ridges = simple.RidgeExtraction(Input=umbilics)
        lines = simple.PrincipalFoliation(Input=umbilics)
        for proxy, port, array in (
            (ridges, 0, "RidgeType"),
            (umbilics, 1, "Index"),
            (lines, 0, "PrincipalDirection"),
        ):
            display = simple.Show(simple.OutputPort(proxy, port), self.view)
            self.assertEqual(display.ColorArrayName[1], array)
            simple.Hide(simple.OutputPort(proxy, port), self.view)

    def test_purple_points_are_balls_of_their_own_color(self):
        jets = simple.JetFitting(Input=simple.RidgeExampleSource(Frequency=16))
        ridges = simple.RidgeExtraction(Input=jets, FindPurplePoints=1)
        display = simple.Show(simple.OutputPort(ridges, 1), self.view)
        self.assertEqual(display.ColorArrayName[1], "")
        self.assertEqual(display.Representation, "Balls")
        self.assertEqual(max(display.DiffuseColor), display.DiffuseColor[2])
        simple.Hide(simple.OutputPort(ridges, 1), self.view)

    def test_lines_are_thick_and_points_are_balls(self):
        ridges, umbilics, mesh = self.displays
        self.assertEqual(ridges.Representation, "Lines In Front")
        self.assertGreater(ridges.LineWidth, 2)
        self.assertEqual(umbilics.Representation, "Balls")
        self.assertGreater(umbilics.PointSize, 10)
        self.assertEqual(mesh.Representation, "Surface")
        self.assertEqual(mesh.LineWidth, 1)  # nothing else is changed

    def test_types_are_categories_with_names(self):
        table = simple.GetColorTransferFunction("RidgeType")
        self.assertEqual(table.InterpretValuesAsCategories, 1)
        self.assertEqual(
            table.Annotations[:],
            "1,maximum elliptic,2,maximum hyperbolic,3,minimum elliptic,4,minimum hyperbolic".split(
                ","
            ),
        )
        blue, green, red, yellow = (table.IndexedColors[3 * i : 3 * i + 3] for i in range(4))
        self.assertEqual(max(blue), blue[2])
        self.assertEqual(max(green), green[1])
        self.assertEqual(max(red), red[0])
        self.assertTrue(min(yellow[:2]) > 0.5 > yellow[2])

    def test_the_legend_has_a_title(self):
        self.displays[0].SetScalarBarVisibility(self.view, True)
        bar = simple.GetScalarBar(simple.GetColorTransferFunction("RidgeType"), self.view)
        self.assertEqual(bar.Title, "Ridge type")

    def test_presets_can_be_imported_and_applied(self):
        simple.ImportPresets(filename=os.environ["RIDGES_PRESETS"])
        table = simple.GetColorTransferFunction("SomethingElse")
        # Not rescaled: then the names come along.
        self.assertTrue(table.ApplyPreset("Ridge types", False))
        self.assertEqual(table.InterpretValuesAsCategories, 1)
        self.assertEqual(table.Annotations[1], "maximum elliptic")


if __name__ == "__main__":
    unittest.main(verbosity=2)
