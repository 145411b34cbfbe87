# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Curvature lines through Python: pipeline, numpy access, properties."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from vtkridges import (
    vtkJetFitting,
    vtkPrincipalFoliation,
    vtkRidgeExampleSource,
    vtkUmbilicDetection,
)


def foliation_of_ellipsoid(frequency=16):
    source = vtkRidgeExampleSource()
    source.SetSurfaceToEllipsoid()
    source.SetFrequency(frequency)
    foliation = vtkPrincipalFoliation()
    stages = [source, vtkJetFitting(), vtkUmbilicDetection(), foliation]
    for stage, following in zip(stages, stages[1:]):
        following.SetInputConnection(stage.GetOutputPort())
    return foliation


def cell_array(foliation, name):
    return vtk_to_numpy(foliation.GetOutput().GetCellData().GetArray(name))


class TestFoliation(unittest.TestCase):
    def test_lines_lie_on_the_ellipsoid(self):
        foliation = foliation_of_ellipsoid()
        foliation.SetDirectionToBoth()
        foliation.Update()
        points = vtk_to_numpy(foliation.GetOutput().GetPoints().GetData())
        # Inside by no more than the triangles are: an edge of 0.08, curvatures up to 3.9.
        level = np.sum((points / [1.4, 1.0, 0.6]) ** 2, axis=1)
        self.assertLess(level.max(), 1.0 + 1e-12)
        self.assertGreater(level.min(), 1.0 - 0.02)

    def test_arrays(self):
        foliation = foliation_of_ellipsoid()
        foliation.SetDirectionToMinimum()
        foliation.Update()
        count = foliation.GetOutput().GetNumberOfLines()
        self.assertGreater(count, 30)
        self.assertEqual(set(cell_array(foliation, "PrincipalDirection")), {1})
        self.assertEqual(set(cell_array(foliation, "Closed")), {0, 1})
        self.assertGreater(cell_array(foliation, "Length").min(), 2 * 0.05 * 1.39)
        curvature = vtk_to_numpy(foliation.GetOutput().GetPointData().GetArray("Curvature"))
        self.assertLess(curvature.max(), 0.0)

    def test_wider_apart_there_are_fewer(self):
        foliation = foliation_of_ellipsoid()
        foliation.Update()
        length = cell_array(foliation, "Length").sum()
        foliation.SetSeparation(2 * foliation.GetSeparation())
        foliation.Update()
        self.assertAlmostEqual(cell_array(foliation, "Length").sum() / length, 0.5, delta=0.1)

    def test_defaults_and_documentation(self):
        foliation = vtkPrincipalFoliation()
        self.assertEqual(foliation.GetDirection(), vtkPrincipalFoliation.MAXIMUM)
        self.assertEqual(foliation.GetSeparation(), 0.05)
        self.assertTrue(foliation.GetStopAtUmbilicPatches())
        self.assertIn("curvature lines", vtkPrincipalFoliation.__doc__)

    def test_missing_arrays_are_named_at_once(self):
        source = vtkRidgeExampleSource()
        source.SetFrequency(8)
        foliation = vtkPrincipalFoliation()
        errors = []

        def record(_caller, _event, text):
            errors.append(text)

        record.CallDataType = "string0"
        foliation.AddObserver("ErrorEvent", record)
        foliation.SetInputConnection(source.GetOutputPort())
        foliation.Update()
        self.assertEqual(len(errors), 1)
        self.assertIn(
            "MaximumCurvature, MinimumCurvature, MaximumDirection, MinimumDirection.", errors[0]
        )
        self.assertEqual(foliation.GetOutput().GetNumberOfCells(), 0)


if __name__ == "__main__":
    unittest.main()
