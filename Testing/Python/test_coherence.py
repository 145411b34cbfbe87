# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The table of coherence through Python."""

import unittest

from vtkmodules.util.numpy_support import vtk_to_numpy

from vtkridges import (
    vtkJetFitting,
    vtkRidgeCoherence,
    vtkRidgeExampleSource,
    vtkRidgeExtraction,
    vtkUmbilicDetection,
)


def coherence_of_ellipsoid(frequency=16):
    source = vtkRidgeExampleSource()
    source.SetSurfaceToEllipsoid()
    source.SetFrequency(frequency)
    fitting = vtkJetFitting()
    umbilics = vtkUmbilicDetection()
    ridges = vtkRidgeExtraction()
    stages = [source, fitting, umbilics, ridges]
    for stage, following in zip(stages, stages[1:]):
        following.SetInputConnection(stage.GetOutputPort())
    coherence = vtkRidgeCoherence()
    coherence.SetInputConnection(0, umbilics.GetOutputPort(0))
    coherence.SetInputConnection(1, ridges.GetOutputPort(0))
    coherence.SetInputConnection(2, umbilics.GetOutputPort(1))
    coherence.Update()
    return umbilics.GetOutput(1), ridges.GetOutput(), coherence


def rows(coherence):
    """The table as a dictionary of dictionaries, by the name of the check."""
    table = coherence.GetOutput()
    names = [table.GetColumnName(column) for column in range(table.GetNumberOfColumns())]
    return {
        table.GetValueByName(row, "Check").ToString(): {
            name: table.GetValueByName(row, name).ToString() for name in names
        }
        for row in range(table.GetNumberOfRows())
    }


class TestCoherence(unittest.TestCase):
    def test_ellipsoid_passes(self):
        _, _, coherence = coherence_of_ellipsoid()
        passed = vtk_to_numpy(coherence.GetOutput().GetColumnByName("Passed"))
        self.assertEqual(len(passed), 14)
        self.assertTrue(passed.all())
        self.assertEqual(rows(coherence)["index sum"]["Found"], "2")

    def test_a_failed_check_tells_the_place(self):
        umbilics, _, coherence = coherence_of_ellipsoid()
        umbilics.GetPointData().GetArray("RidgeCount").SetValue(3, 3)
        coherence.SetInputDataObject(2, umbilics)
        coherence.Update()
        row = rows(coherence)["ridges at umbilics"]
        self.assertEqual((row["Passed"], row["OffenderKind"], row["Offenders"]), ("0", "umbilic", "3"))
        self.assertEqual(row["Severity"], "1")
        positions = vtk_to_numpy(coherence.GetOutput().GetColumnByName("OffenderPosition"))
        self.assertEqual(tuple(positions[2]), umbilics.GetPoint(3))

    def test_defaults_and_documentation(self):
        self.assertEqual(vtkRidgeCoherence().GetRightAngleCosine(), 0.001)
        self.assertIn("consistent", vtkRidgeCoherence.__doc__)


if __name__ == "__main__":
    unittest.main()
