# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ridges on several ranks of MPI, which mpirun starts."""

import importlib.util
import os
import unittest

from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData

import vtkridges

if importlib.util.find_spec("vtkridges.parallel") is None:
    raise unittest.SkipTest("the vtk of PyPI has no MPI, and its wheel of vtkridges no such module")
from vtkridges.parallel import use_mpi, vtkPRidgesAndUmbilics

CONTROLLER = use_mpi()
BY_MPIRUN = "OMPI_COMM_WORLD_SIZE" in os.environ or "PMI_SIZE" in os.environ


def ellipsoid():
    source = vtkridges.vtkRidgeExampleSource()
    source.SetSurfaceToEllipsoid()
    source.SetFrequency(16)
    source.Update()
    return source.GetOutput()


def piece(mesh, rank, ranks):
    """Every so many-th triangle, with its points."""
    part = vtkPolyData()
    part.SetPoints(mesh.GetPoints())
    part.AllocateEstimate(mesh.GetNumberOfPolys(), 3)
    ids = vtkIdList()
    for cell in range(rank, mesh.GetNumberOfCells(), ranks):
        mesh.GetCellPoints(cell, ids)
        part.InsertNextCell(mesh.GetCellType(cell), ids)
    clean = vtkCleanPolyData()
    clean.SetInputData(part)
    clean.PointMergingOff()
    clean.Update()
    return clean.GetOutput()


class TestParallel(unittest.TestCase):
    @unittest.skipUnless(BY_MPIRUN, "not started by mpirun")
    def test_the_ranks_are_those_of_mpi(self):
        self.assertEqual(vtkPRidgesAndUmbilics().GetController(), CONTROLLER)
        self.assertGreater(CONTROLLER.GetNumberOfProcesses(), 1)

    def test_ridges_are_those_of_one_rank(self):
        mesh = ellipsoid()
        rank = CONTROLLER.GetLocalProcessId()
        ridges = vtkPRidgesAndUmbilics()
        ridges.SetInputData(piece(mesh, rank, CONTROLLER.GetNumberOfProcesses()))
        ridges.Update()
        found = ridges.GetOutput(), ridges.GetOutput(1)
        if rank > 0:
            self.assertEqual([data.GetNumberOfCells() for data in found], [0, 0])
            return
        serial = vtkridges.vtkRidgesAndUmbilics()
        serial.SetInputData(mesh)
        serial.Update()
        for data, expected in zip(found, (serial.GetOutput(), serial.GetOutput(1))):
            self.assertGreater(expected.GetNumberOfCells(), 0)
            self.assertEqual(data.GetNumberOfCells(), expected.GetNumberOfCells())
            self.assertEqual(data.GetNumberOfPoints(), expected.GetNumberOfPoints())
            for i in range(expected.GetNumberOfPoints()):
                self.assertEqual(data.GetPoint(i), expected.GetPoint(i))


if __name__ == "__main__":
    unittest.main()
