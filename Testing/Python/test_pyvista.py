# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista's meshes in, PyVista's meshes out; skipped where there is no PyVista."""

import doctest
import subprocess
import sys
import unittest

import numpy as np

import vtkridges

try:
    import pyvista
except ImportError:
    pyvista = None

if pyvista:
    import vtkridges.pyvista as ridges


@unittest.skipUnless(pyvista, "needs PyVista")
class TestFunctions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh = pyvista.Icosphere(nsub=5).scale([3.0, 2.0, 1.0], inplace=False)

    def test_salient_lines_have_the_colors_of_their_types(self):
        lines = ridges.salient(self.mesh)
        self.assertIsInstance(lines, pyvista.PolyData)
        self.assertGreater(lines.n_cells, 0)
        self.assertEqual(lines.active_scalars_name, "RidgeType_rgb")
        np.testing.assert_array_equal(lines["RidgeType_rgb"], [[217, 13, 13]] * lines.n_cells)

    def test_extracted_lines_are_those_of_arrays(self):
        lines = ridges.extract(self.mesh, minimum_sharpness=1.0)
        found = vtkridges.ridges(
            self.mesh.points, self.mesh.faces.reshape(-1, 4)[:, 1:], minimum_sharpness=1.0
        )
        np.testing.assert_array_equal(lines.points, found.points)
        np.testing.assert_array_equal(lines["RidgeType"], found.type)

    def test_a_fit_is_used_by_what_follows(self):
        fitted = ridges.fit(self.mesh, degree=6)
        self.assertEqual(fitted.n_points, self.mesh.n_points)
        lines = ridges.extract(fitted)
        np.testing.assert_array_equal(lines.points, ridges.extract(self.mesh, degree=6).points)
        self.assertFalse(np.array_equal(lines.points, ridges.extract(self.mesh).points))
        with self.assertRaisesRegex(TypeError, "unknown property 'degree'"):
            ridges.extract(fitted, degree=4)

    def test_umbilics(self):
        points = ridges.umbilics(self.mesh)
        np.testing.assert_array_equal(points["Index"], [0.5] * 4)
        np.testing.assert_array_equal(points["Index_rgb"], [[0, 0, 0]] * 4)
        self.assertEqual(points.active_scalars_name, "Index_rgb")

    def test_the_mesh_is_left_as_it_was(self):
        before = self.mesh.copy()
        ridges.extract(self.mesh)
        ridges.fit(self.mesh)
        self.assertEqual(self.mesh, before)

    def test_a_plane_has_no_lines(self):
        self.assertEqual(ridges.salient(pyvista.Plane().triangulate()).n_cells, 0)

    def test_other_data_is_an_error_that_says_what_to_do(self):
        with self.assertRaisesRegex(TypeError, "not on ImageData.*extract_surface"):
            ridges.salient(pyvista.ImageData(dimensions=(3, 3, 3)))

    def test_examples_in_the_docstrings(self):
        result = doctest.testmod(ridges)
        self.assertEqual((result.failed, result.attempted > 0), (0, True))


@unittest.skipUnless(hasattr(pyvista, "register_dataset_accessor"), "needs PyVista 0.48")
class TestAccessor(unittest.TestCase):
    def test_methods_are_the_functions(self):
        mesh = pyvista.Icosphere(nsub=4).scale([3.0, 2.0, 1.0], inplace=False)
        for name in ("salient", "extract", "fit", "umbilics"):
            with self.subTest(name):
                self.assertEqual(getattr(mesh.ridges, name)(), getattr(ridges, name)(mesh))
        self.assertGreater(mesh.ridges.fit(degree=6).ridges.extract().n_cells, 0)

    def test_an_installed_wheel_is_found_by_pyvista(self):
        from importlib.metadata import entry_points

        if "ridges" not in {each.name for each in entry_points(group="pyvista.accessors")}:
            self.skipTest("vtkridges is not installed as a wheel")
        code = "import pyvista; print(pyvista.Sphere().ridges.fit().n_points)"
        run = subprocess.run([sys.executable, "-B", "-c", code], capture_output=True, text=True)
        self.assertEqual(run.stdout.strip(), str(pyvista.Sphere().n_points), run.stderr)


if __name__ == "__main__":
    unittest.main()
