# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""From numpy arrays to numpy arrays."""

import doctest
import unittest
import warnings

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkridges
import vtkridges.arrays

SEMI_AXES = (3.0, 2.0, 1.0)


def ellipsoid():
    source = vtkridges.vtkRidgeExampleSource()
    source.SetSurface(vtkridges.vtkRidgeExampleSource.ELLIPSOID)
    source.SetSemiAxes(SEMI_AXES)
    source.SetFrequency(32)
    source.Update()
    mesh = source.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    return mesh, points, vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)


class TestArrays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh, cls.points, cls.triangles = ellipsoid()

    def test_ridges_are_those_of_the_filters(self):
        stages = vtkridges.vtkRidgesAndUmbilics()
        stages.SetInputData(self.mesh)
        stages.SetMinimumSharpness(1.0)
        stages.Update()
        lines = stages.GetOutput()
        found = vtkridges.ridges(self.points, self.triangles, minimum_sharpness=1.0)
        self.assertGreater(len(found), 0)
        self.assertEqual(len(found), lines.GetNumberOfLines())
        np.testing.assert_array_equal(found.points, vtk_to_numpy(lines.GetPoints().GetData()))
        for name in ("RidgeType", "RidgeId", "Sharpness", "Strength", "Length", "Crest", "Closed"):
            attribute = {"RidgeType": "type", "RidgeId": "ridge_id"}.get(name, name.lower())
            np.testing.assert_array_equal(
                getattr(found, attribute), vtk_to_numpy(lines.GetCellData().GetArray(name)), name
            )
        ids = np.concatenate(found.lines)
        expected = vtk_to_numpy(lines.GetLines().GetConnectivityArray())
        np.testing.assert_array_equal(ids, expected)
        self.assertIsNone(found.fold_angle)

    def test_lengths_are_those_of_the_positions(self):
        found = vtkridges.ridges(self.points, self.triangles)
        for line, length in enumerate(found.length):
            steps = np.diff(found.positions(line), axis=0)
            # Sums in another order: round-off only.
            self.assertAlmostEqual(np.linalg.norm(steps, axis=1).sum(), length, places=12)

    def test_salient_ridges(self):
        found = vtkridges.salient_ridges(self.points, self.triangles, fold_angle=10.0)
        fewer = vtkridges.salient_ridges(self.points, self.triangles, fold_angle=170.0)
        self.assertGreater(len(found), 0)
        self.assertEqual(set(found.type), {3})
        self.assertGreaterEqual(found.fold_angle.min(), 10.0)
        self.assertLess(len(fewer), len(found))

    def test_umbilics_of_the_ellipsoid(self):
        a, b, c = SEMI_AXES
        found = vtkridges.umbilics(self.points, self.triangles)
        x = a * np.sqrt((a * a - b * b) / (a * a - c * c))
        z = c * np.sqrt((b * b - c * c) / (a * a - c * c))
        np.testing.assert_array_equal(found.index, [0.5] * 4)
        np.testing.assert_array_equal(found.ridge_count, [1] * 4)
        # Each is in the triangle whose index it is, or in one beside it: within an edge, 0.12.
        np.testing.assert_allclose(np.abs(found.points), [[x, 0.0, z]] * 4, atol=0.12)

    def test_curvature_of_the_ellipsoid(self):
        squares = np.square(SEMI_AXES)
        gradient = self.points / squares
        gaussian = 1.0 / (np.prod(squares) * np.sum(gradient**2, axis=1) ** 2)
        normals = gradient / np.linalg.norm(gradient, axis=1, keepdims=True)
        found = vtkridges.curvature(self.points, self.triangles, degree=6)
        self.assertTrue((found.minimum <= found.maximum).all())
        # Of a polynomial of degree 6 over three rings: largest at the tips, where the radius of
        # curvature, 0.33, is hardly that of the neighbourhood.
        np.testing.assert_allclose(found.maximum * found.minimum, gaussian, rtol=1e-3)
        np.testing.assert_allclose(found.normals, normals, atol=1e-4)
        frame = np.cross(found.maximum_direction, found.minimum_direction)
        np.testing.assert_allclose(frame, found.normals, atol=1e-12)
        self.assertEqual(found.third_order.shape, (len(self.points), 4))
        self.assertFalse(found.status.any())

    def test_other_types_and_orders_of_memory(self):
        plain = vtkridges.curvature(self.points, self.triangles)
        other = vtkridges.curvature(np.asfortranarray(self.points), self.triangles.tolist())
        np.testing.assert_array_equal(plain.maximum, other.maximum)

    def test_results_outlive_the_filters(self):
        points = vtkridges.ridges(self.points, self.triangles).points
        copy = points.copy()
        for _ in range(3):
            vtkridges.ridges(self.points, self.triangles)
        np.testing.assert_array_equal(points, copy)

    def test_nothing_in_nothing_out(self):
        for points in (np.empty((0, 3)), self.points):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # points without triangles
                found = vtkridges.ridges(points, np.empty((0, 3), dtype=int))
                self.assertEqual((len(found), found.points.shape), (0, (0, 3)))
                self.assertEqual(vtkridges.umbilics(points, []).points.shape, (0, 3))

    def test_invalid_input_is_an_error_that_names_it(self):
        cases = [
            (self.points[:, :2], self.triangles, r"\(n, 3\), not"),
            (self.points, self.triangles[:, :2], r"\(m, 3\), not"),
            (self.points, self.triangles.astype(float), "indices of points, not float64"),
            (self.points, self.triangles + 1, f"there are {len(self.points)} points"),
            (self.points, self.triangles - 1, "indices -1 to"),
        ]
        for points, triangles, message in cases:
            with self.subTest(message), self.assertRaisesRegex(ValueError, message):
                vtkridges.ridges(points, triangles)

    def test_invalid_properties_are_errors_that_list_the_valid_ones(self):
        with self.assertRaisesRegex(TypeError, "unknown property 'sharpness'.*minimum_sharpness"):
            vtkridges.ridges(self.points, self.triangles, sharpness=1.0)
        with self.assertRaisesRegex(ValueError, "neighborhood='best'.*Automatic"):
            vtkridges.curvature(self.points, self.triangles, neighborhood="best")
        with self.assertRaisesRegex(ValueError, "numbers only"):
            vtkridges.curvature(self.points, self.triangles, degree="six")

    def test_values_of_enumerations_by_name(self):
        by_name = vtkridges.curvature(self.points, self.triangles, neighborhood="rings")
        rings = vtkridges.vtkJetFitting.BY_RINGS
        by_number = vtkridges.curvature(self.points, self.triangles, neighborhood=rings)
        np.testing.assert_array_equal(by_name.maximum, by_number.maximum)
        vtkridges.curvature(self.points, self.triangles, neighborhood="point count")

    def test_errors_of_the_filters_are_raised(self):
        with self.assertRaisesRegex(RuntimeError, "ThirdOrder"):
            vtkridges.ridges(self.points, self.triangles, monge_order=2)

    def test_warnings_of_the_filters_are_warnings(self):
        inside_out = self.triangles[:, ::-1]
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            vtkridges.salient_ridges(self.points, inside_out)
        self.assertEqual([each.category for each in caught], [RuntimeWarning])
        self.assertNotIn("0x", str(caught[0].message))
        self.assertEqual(caught[0].filename, __file__)

    def test_examples_in_the_docstrings(self):
        result = doctest.testmod(vtkridges.arrays)
        self.assertEqual((result.failed, result.attempted > 0), (0, True))


if __name__ == "__main__":
    unittest.main()
