# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Failure through Python: errors are told once, nothing is stale, nothing crashes."""

import math
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from vtkridges import (
    vtkJetFitting,
    vtkPrincipalFoliation,
    vtkRidgeExampleSource,
    vtkRidgeExtraction,
    vtkRidgesAndUmbilics,
    vtkRidgeSharpnessFilter,
    vtkUmbilicDetection,
)

FILTERS = [
    vtkJetFitting,
    vtkUmbilicDetection,
    vtkRidgeExtraction,
    vtkRidgeSharpnessFilter,
    vtkPrincipalFoliation,
    vtkRidgesAndUmbilics,
]


class Recorder:
    """Collects the messages of a filter and of its executive, which would be printed."""

    def __init__(self, algorithm: vtkAlgorithm):
        self.errors = []
        self.warnings = []
        self.executive_errors = []
        self._observe(algorithm, "ErrorEvent", self.errors)
        self._observe(algorithm, "WarningEvent", self.warnings)
        self._observe(algorithm.GetExecutive(), "ErrorEvent", self.executive_errors)

    @staticmethod
    def _observe(caller, event, texts):
        def record(_caller, _event, text):
            texts.append(text)

        record.CallDataType = "string0"
        caller.AddObserver(event, record)


def example_mesh(frequency=8):
    source = vtkRidgeExampleSource()
    source.SetSurfaceToEllipsoid()
    source.SetFrequency(frequency)
    source.Update()
    return source.GetOutput()


def fitted_mesh():
    jets = vtkJetFitting()
    jets.SetInputData(example_mesh())
    jets.Update()
    return jets.GetOutput()


class TestBadInput(unittest.TestCase):
    def assert_empty(self, algorithm):
        for port in range(algorithm.GetNumberOfOutputPorts()):
            output = algorithm.GetOutput(port)
            self.assertEqual(output.GetNumberOfPoints(), 0)
            self.assertEqual(output.GetNumberOfCells(), 0)

    def test_no_input(self):
        for kind in FILTERS:
            with self.subTest(kind.__name__):
                algorithm = kind()
                recorder = Recorder(algorithm)
                algorithm.Update()
                self.assertIn("0 connections", "".join(recorder.executive_errors))
                self.assert_empty(algorithm)

    def test_empty_input(self):
        for kind in FILTERS:
            with self.subTest(kind.__name__):
                algorithm = kind()
                recorder = Recorder(algorithm)
                algorithm.SetInputData(vtkPolyData())
                algorithm.Update()
                self.assertEqual(recorder.errors + recorder.warnings, [])
                self.assertEqual(recorder.executive_errors, [])
                self.assert_empty(algorithm)

    def test_missing_arrays_are_named_at_once_and_nothing_is_stale(self):
        for kind in (vtkUmbilicDetection, vtkRidgeExtraction):
            with self.subTest(kind.__name__):
                algorithm = kind()
                recorder = Recorder(algorithm)
                algorithm.SetInputData(fitted_mesh())
                algorithm.Update()
                self.assertGreater(algorithm.GetOutput().GetNumberOfPoints(), 0)
                algorithm.SetInputData(example_mesh())
                algorithm.Update()
                self.assertEqual(len(recorder.errors), 1)
                self.assertIn(
                    "MaximumCurvature, MinimumCurvature, MaximumDirection, MinimumDirection, "
                    "ThirdOrder",
                    recorder.errors[0],
                )
                self.assert_empty(algorithm)

    def test_lines_without_arrays(self):
        algorithm = vtkRidgeSharpnessFilter()
        recorder = Recorder(algorithm)
        algorithm.SetInputData(example_mesh())
        algorithm.SetMinimumSharpness(1.0)
        algorithm.Update()
        self.assertEqual(len(recorder.errors), 1)
        self.assertIn("RidgeType, Sharpness", recorder.errors[0])
        self.assert_empty(algorithm)

    def test_radius_has_to_be_positive(self):
        for radius in (0.0, -1.0, math.nan, math.inf):
            with self.subTest(radius):
                jets = vtkJetFitting()
                recorder = Recorder(jets)
                jets.SetInputData(example_mesh())
                jets.SetNeighborhoodToRadius()
                jets.SetRadius(radius)
                jets.Update()
                self.assertEqual(len(recorder.errors), 1)
                self.assertIn("Radius is", recorder.errors[0])
                self.assert_empty(jets)

    def test_wrong_types_are_refused(self):
        with self.assertRaises(TypeError):
            vtkJetFitting().SetDegree("four")
        with self.assertRaises(TypeError):
            vtkRidgeExampleSource().SetSemiAxes(1.0, 2.0)

    def test_isolated_point_is_flagged_and_counted(self):
        mesh = example_mesh()
        points = vtkPoints()
        points.DeepCopy(mesh.GetPoints())
        isolated = points.InsertNextPoint(50.0, 0.0, 0.0)
        mesh.SetPoints(points)
        jets = vtkJetFitting()
        recorder = Recorder(jets)
        jets.SetInputData(mesh)
        jets.Update()
        self.assertEqual(recorder.errors, [])
        self.assertEqual(len(recorder.warnings), 1)
        self.assertIn("1 points have no fit", recorder.warnings[0])
        status = vtk_to_numpy(jets.GetOutput().GetPointData().GetArray("FitStatus"))
        invalid = np.flatnonzero(status & vtkJetFitting.FIT_INVALID)
        np.testing.assert_array_equal(invalid, [isolated])


if __name__ == "__main__":
    unittest.main()
