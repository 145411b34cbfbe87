# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters through Python: pipeline, numpy access, properties, documentation."""

import unittest

import numpy as np
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkridges
from vtkridges import (
    vtkJetFitting,
    vtkRidgeExampleSource,
    vtkRidgeExtraction,
    vtkRidgesAndUmbilics,
    vtkRidgeSharpnessFilter,
    vtkUmbilicDetection,
)


class Chain:
    """Example surface, fit, umbilics, ridges and selection, with default ports."""

    def __init__(self, surface, frequency):
        self.source = vtkRidgeExampleSource()
        self.source.SetSurface(surface)
        self.source.SetFrequency(frequency)
        self.jets = vtkJetFitting()
        self.umbilics = vtkUmbilicDetection()
        self.ridges = vtkRidgeExtraction()
        self.sharpness = vtkRidgeSharpnessFilter()
        self.sharpness.SetMinimumSharpness(10.0)
        stages = [self.source, self.jets, self.umbilics, self.ridges, self.sharpness]
        for stage, following in zip(stages, stages[1:]):
            following.SetInputConnection(stage.GetOutputPort())
        self.sharpness.Update()


def point_array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def cell_array(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


class TestPackage(unittest.TestCase):
    def test_exports_every_class(self):
        expected = {
            "vtkJetFitting",
            "vtkPrincipalFoliation",
            "vtkRidgeExampleSource",
            "vtkRidgeExtraction",
            "vtkRidgeSharpnessFilter",
            "vtkRidgesAndUmbilics",
            "vtkSalientRidges",
            "vtkMongeSmoothing",
            "vtkUmbilicDetection",
        }
        self.assertLessEqual(expected, set(vtkridges.__all__))

    def test_has_a_version(self):
        self.assertRegex(vtkridges.__version__, r"^\d+\.\d+\.\d+$")

    def test_documentation_comes_along(self):
        for name in vtkridges.__all__:
            self.assertGreater(len(getattr(vtkridges, name).__doc__), 100, name)
        self.assertIn("ThirdOrder", vtkJetFitting.__doc__)
        text = " ".join(vtkJetFitting.SetMinimumNumberOfPoints.__doc__.split())
        self.assertIn("Default 18", text)


class TestProperties(unittest.TestCase):
    def test_enumerations(self):
        jets = vtkJetFitting()
        jets.SetNeighborhood(vtkJetFitting.BY_RINGS)
        self.assertEqual(jets.GetNeighborhoodAsString(), "Rings")
        jets.SetNeighborhoodToRadius()
        self.assertEqual(jets.GetNeighborhood(), vtkJetFitting.BY_RADIUS)
        jets.SetNeighborhood(vtkJetFitting.AUTOMATIC)
        self.assertEqual(jets.GetNeighborhoodAsString(), "Automatic")
        jets.SetWeighting(vtkJetFitting.GAUSSIAN)
        self.assertEqual(jets.GetWeightingAsString(), "Gaussian")
        self.assertEqual(vtkJetFitting.FIT_INVALID, 8)
        self.assertEqual(vtkRidgeExtraction.MINIMUM_HYPERBOLIC, 4)
        umbilics = vtkUmbilicDetection()
        self.assertEqual(umbilics.GetMethod(), vtkUmbilicDetection.INDICES)
        umbilics.SetMethodToMinima()
        self.assertEqual(umbilics.GetMethod(), vtkUmbilicDetection.MINIMA)
        extraction = vtkRidgeExtraction()
        self.assertEqual(extraction.GetUmbilicJoining(), vtkRidgeExtraction.PATCHES)
        extraction.SetUmbilicJoiningToTriangles()
        self.assertEqual(extraction.GetUmbilicJoining(), vtkRidgeExtraction.TRIANGLES)

    def test_booleans(self):
        jets = vtkJetFitting()
        jets.StandardErrorsOn()
        self.assertIs(jets.GetStandardErrors(), True)
        extraction = vtkRidgeExtraction()
        extraction.SetCrestOnly(True)
        self.assertIs(extraction.GetCrestOnly(), True)
        extraction.CrestOnlyOff()
        self.assertIs(extraction.GetCrestOnly(), False)

    def test_numbers_are_clamped(self):
        jets = vtkJetFitting()
        jets.SetDegree(17)
        self.assertEqual(jets.GetDegree(), 8)

    def test_vectors(self):
        source = vtkRidgeExampleSource()
        source.SetSemiAxes((3.0, 2.0, 1.0))
        self.assertEqual(source.GetSemiAxes(), (3.0, 2.0, 1.0))

    def test_printing_tells_the_properties(self):
        self.assertIn("PatchSize: 2", str(vtkUmbilicDetection()))


class TestEllipsoid(unittest.TestCase):
    a, b, c = 1.4, 1.0, 0.6

    @classmethod
    def setUpClass(cls):
        cls.chain = Chain(vtkRidgeExampleSource.ELLIPSOID, 32)

    def test_curvatures_lie_between_those_at_the_tips(self):
        fitted = self.chain.jets.GetOutput()
        k1 = point_array(fitted, "MaximumCurvature")
        k2 = point_array(fitted, "MinimumCurvature")
        # Largest and smallest normal curvature; the fit is right to 3e-4 at this resolution.
        self.assertGreater(k2.min(), -self.a / self.c**2 - 1e-3)
        self.assertLess(k1.max(), -self.c / self.a**2 + 1e-3)
        self.assertTrue(np.all(k1 >= k2))

    def test_umbilics_are_at_their_places(self):
        umbilics = self.chain.umbilics.GetOutput(1)
        self.assertEqual(umbilics.GetNumberOfPoints(), 4)
        np.testing.assert_array_equal(point_array(umbilics, "Index"), 0.5)
        a2, b2, c2 = self.a**2, self.b**2, self.c**2
        x = self.a * np.sqrt((a2 - b2) / (a2 - c2))
        z = self.c * np.sqrt((b2 - c2) / (a2 - c2))
        points = np.abs(vtk_to_numpy(umbilics.GetPoints().GetData()))
        # Within the mean edge length of the mesh.
        np.testing.assert_allclose(points, [[x, 0.0, z]] * 4, atol=0.035)

    def test_ridges_lie_in_the_planes_of_symmetry(self):
        ridges = self.chain.ridges.GetOutput()
        self.assertEqual(ridges.GetNumberOfLines(), 6)
        points = vtk_to_numpy(ridges.GetPoints().GetData())
        # A third of the mean edge length.
        self.assertLess(np.abs(points).min(axis=1).max(), 0.012)
        self.assertEqual(sorted(cell_array(ridges, "RidgeType")), [1, 2, 2, 3, 4, 4])

    def test_numpy_interface_reads_the_arrays(self):
        adapted = dataset_adapter.WrapDataObject(self.chain.umbilics.GetOutput(0))
        self.assertEqual(adapted.PointData["ThirdOrder"].shape, (10242, 4))
        self.assertEqual(adapted.FieldData["UmbilicIndexSum"][0], 2.0)
        self.assertEqual(adapted.FieldData["EulerCharacteristic"][0], 2)
        self.assertEqual(set(adapted.CellData["UmbilicPatch"]), {-1, 0, 1, 2, 3})

    def test_automatic_scale_and_standard_errors(self):
        source = vtkRidgeExampleSource()
        source.SetSurfaceToEllipsoid()
        source.SetFrequency(16)
        jets = vtkJetFitting()
        jets.SetInputConnection(source.GetOutputPort())
        jets.SetNeighborhoodToAutomatic()
        jets.StandardErrorsOn()
        jets.Update()
        field = jets.GetOutput().GetFieldData()
        # Without noise a high degree, few rings, and nothing to average.
        self.assertGreaterEqual(field.GetArray("SelectedDegree").GetValue(0), 6)
        self.assertLess(field.GetArray("SelectedNumberOfRings").GetValue(0), 6)
        self.assertEqual(field.GetArray("SelectedNumberOfAverages").GetValue(0), 0)
        self.assertLess(field.GetArray("EstimatedNoise").GetValue(0), 1e-6)
        self.assertEqual(point_array(jets.GetOutput(), "ThirdOrderError").shape, (2562, 4))
        self.assertGreater(point_array(jets.GetOutput(), "FitScale").min(), 0.0)


class TestBlend(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.chain = Chain(vtkRidgeExampleSource.BLEND, 63)

    def test_six_and_two_umbilics(self):
        index = point_array(self.chain.umbilics.GetOutput(1), "Index")
        self.assertEqual(sorted(index), [-0.5] * 2 + [0.5] * 6)

    def test_ridge_points_lie_on_their_edges(self):
        ridges = self.chain.ridges.GetOutput()
        mesh = vtk_to_numpy(self.chain.source.GetOutput().GetPoints().GetData())
        p = point_array(ridges, "EdgePoint0")
        q = point_array(ridges, "EdgePoint1")
        t = point_array(ridges, "EdgeParameter")[:, np.newaxis]
        on_edge = p >= 0
        expected = (1 - t) * mesh[p] + t * mesh[q]
        points = vtk_to_numpy(ridges.GetPoints().GetData())
        # Round-off of coordinates below 0.4.
        np.testing.assert_allclose(points[on_edge], expected[on_edge], rtol=0, atol=1e-15)
        umbilic = point_array(ridges, "Umbilic")
        turning = point_array(ridges, "TurningPoint")
        self.assertEqual(sorted(umbilic[umbilic >= 0]), list(range(8)))
        # Inside triangles there are umbilics and turning points only.
        np.testing.assert_array_equal(~on_edge, (umbilic >= 0) | (~on_edge & (turning == 1)))
        self.assertGreater(np.count_nonzero(~on_edge), 8)

    def test_minima_and_indices_find_the_same_umbilics(self):
        umbilics = vtkUmbilicDetection()
        umbilics.SetInputConnection(self.chain.jets.GetOutputPort())
        umbilics.SetMethodToMinima()
        umbilics.Update()
        minima = vtk_to_numpy(umbilics.GetOutput(1).GetPoints().GetData())
        indices = vtk_to_numpy(self.chain.umbilics.GetOutput(1).GetPoints().GetData())
        self.assertEqual(sorted(map(tuple, minima)), sorted(map(tuple, indices)))

    def test_patterns(self):
        umbilics = self.chain.umbilics.GetOutput(1)
        star = point_array(umbilics, "Pattern") == 3
        np.testing.assert_array_equal(star, point_array(umbilics, "Index") < 0)
        np.testing.assert_array_equal(point_array(umbilics, "TouchesBorder"), 0)

    def test_one_filter_does_it_all(self):
        whole = vtkRidgesAndUmbilics()
        whole.SetInputConnection(self.chain.source.GetOutputPort())
        whole.SetMinimumSharpness(10.0)
        whole.Update()
        by_hand = [
            self.chain.sharpness.GetOutput(),
            self.chain.umbilics.GetOutput(1),
            self.chain.ridges.GetOutput(2),
        ]
        for port, expected in enumerate(by_hand):
            output = whole.GetOutput(port)
            np.testing.assert_array_equal(
                vtk_to_numpy(output.GetPoints().GetData()),
                vtk_to_numpy(expected.GetPoints().GetData()),
            )
            for data, its in (
                (output.GetPointData(), expected.GetPointData()),
                (output.GetCellData(), expected.GetCellData()),
            ):
                self.assertEqual(data.GetNumberOfArrays(), its.GetNumberOfArrays())
                for i in range(its.GetNumberOfArrays()):
                    np.testing.assert_array_equal(
                        vtk_to_numpy(data.GetArray(its.GetArrayName(i))),
                        vtk_to_numpy(its.GetArray(i)),
                    )
        self.assertIn("Which ridges are kept", vtkRidgesAndUmbilics.SetMinimumSharpness.__doc__)

    def test_selection_keeps_what_is_sharp(self):
        sharp = cell_array(self.chain.sharpness.GetOutput(), "Sharpness")
        every = cell_array(self.chain.ridges.GetOutput(), "Sharpness")
        np.testing.assert_array_equal(sharp, every[every >= 10.0])
        self.assertTrue(0 < len(sharp) < len(every))


if __name__ == "__main__":
    unittest.main()
