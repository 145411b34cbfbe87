# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Through Python: short arrays, float arrays, chosen arrays, ghost cells and composite data."""

import unittest

import numpy as np
from test_bad_input import Recorder, fitted_mesh
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkDataObject,
    vtkDataSetAttributes,
    vtkMultiBlockDataSet,
    vtkPolyData,
)

from vtkridges import (
    vtkJetFitting,
    vtkPrincipalFoliation,
    vtkRidgeExtraction,
    vtkRidgesAndUmbilics,
    vtkUmbilicDetection,
)

MONGE = [
    "MaximumCurvature",
    "MinimumCurvature",
    "MaximumDirection",
    "MinimumDirection",
    "ThirdOrder",
    "FourthOrder",
]


def copy_of(data):
    copy = vtkPolyData()
    copy.DeepCopy(data)
    return copy


def values_of(mesh, name):
    return vtk_to_numpy(mesh.GetPointData().GetArray(name))


def add(data, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    data.AddArray(array)


class TestInputs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.fitted = fitted_mesh()

    def number_of_lines(self, mesh, choose=lambda algorithm: None):
        umbilics = vtkUmbilicDetection()
        umbilics.SetInputData(mesh)
        ridges = vtkRidgeExtraction()
        ridges.SetInputConnection(umbilics.GetOutputPort())
        for algorithm in (umbilics, ridges):
            choose(algorithm)
        ridges.Update()
        return ridges.GetOutput().GetNumberOfLines()

    def test_short_arrays_are_errors_with_both_numbers(self):
        count = self.fitted.GetNumberOfPoints()
        for kind in (vtkUmbilicDetection, vtkRidgeExtraction, vtkPrincipalFoliation):
            for name in MONGE:
                if kind is vtkPrincipalFoliation and "Order" in name:
                    continue
                with self.subTest(f"{kind.__name__}: {name}"):
                    mesh = copy_of(self.fitted)
                    add(mesh.GetPointData(), name, values_of(self.fitted, name)[:50])
                    algorithm = kind()
                    recorder = Recorder(algorithm)
                    algorithm.SetInputData(mesh)
                    algorithm.Update()
                    self.assertEqual(len(recorder.errors), 1)
                    self.assertIn(f"{name} has 50 tuples, not {count}", recorder.errors[0])
                    self.assertEqual(algorithm.GetOutput().GetNumberOfCells(), 0)

    def test_float_arrays_are_accepted(self):
        mesh = copy_of(self.fitted)
        for name in MONGE:
            add(mesh.GetPointData(), name, values_of(self.fitted, name).astype(np.float32))
        self.assertGreater(self.number_of_lines(mesh), 0)

    def test_arrays_can_be_chosen(self):
        mesh = copy_of(self.fitted)
        for name in MONGE:
            add(mesh.GetPointData(), "my " + name, values_of(self.fitted, name))
            mesh.GetPointData().RemoveArray(name)

        def choose(algorithm):
            for index, name in enumerate(MONGE):
                algorithm.SetInputArrayToProcess(
                    index, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "my " + name
                )

        expected = self.number_of_lines(self.fitted)
        self.assertGreater(expected, 0)
        self.assertEqual(self.number_of_lines(mesh, choose), expected)

    def test_hidden_cells_have_no_ridges(self):
        mesh = copy_of(self.fitted)
        flags = np.full(mesh.GetNumberOfCells(), vtkDataSetAttributes.HIDDENCELL, np.uint8)
        add(mesh.GetCellData(), "vtkGhostType", flags)
        jets = vtkJetFitting()
        recorder = Recorder(jets)
        jets.SetInputData(mesh)
        jets.Update()
        self.assertEqual(recorder.errors + recorder.warnings, [])
        self.assertTrue(np.all(values_of(jets.GetOutput(), "FitStatus") & vtkJetFitting.FIT_INVALID))
        self.assertEqual(self.number_of_lines(mesh), 0)

    def test_blocks_are_processed_one_by_one(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, copy_of(self.fitted))
        blocks.SetBlock(2, copy_of(self.fitted))
        ridges = vtkRidgesAndUmbilics()
        ridges.SetInputData(blocks)
        ridges.Update()
        for port in range(3):
            output = ridges.GetOutputDataObject(port)
            self.assertIsNone(output.GetBlock(1))
            self.assertGreater(output.GetBlock(0).GetNumberOfCells(), 0)
            self.assertEqual(
                output.GetBlock(0).GetNumberOfCells(), output.GetBlock(2).GetNumberOfCells()
            )


if __name__ == "__main__":
    unittest.main()
