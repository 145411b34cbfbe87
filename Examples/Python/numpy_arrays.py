# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""From numpy arrays to numpy arrays: vertices and triangles in, polylines with their types out."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import vtkridges


def ridges_of(vertices, triangles):
    """A list of (type, points) for vertices (n, 3) and triangles (m, 3)."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(vertices, dtype=float), deep=True))
    cells = vtkCellArray()
    corners = np.asarray(triangles, dtype=np.int64).ravel()
    cells.SetData(3, numpy_to_vtkIdTypeArray(corners, deep=True))
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(cells)

    jets = vtkridges.vtkJetFitting()
    jets.SetInputData(mesh)
    extraction = vtkridges.vtkRidgeExtraction()
    extraction.SetInputConnection(jets.GetOutputPort())
    extraction.Update()
    lines = extraction.GetOutput()
    if lines.GetNumberOfLines() == 0:
        return []
    positions = vtk_to_numpy(lines.GetPoints().GetData())
    ids = vtk_to_numpy(lines.GetLines().GetConnectivityArray())
    starts = vtk_to_numpy(lines.GetLines().GetOffsetsArray())[1:-1]
    types = vtk_to_numpy(lines.GetCellData().GetArray("RidgeType"))
    return [(int(kind), positions[run]) for kind, run in zip(types, np.split(ids, starts))]


# A wavy sheet as a grid of n by n points, shaken a little.
n = 60
x, y = np.meshgrid(np.linspace(-2.0, 2.0, n), np.linspace(-2.0, 2.0, n))
x, y = np.array([x.ravel(), y.ravel()]) + np.random.default_rng(1).uniform(-0.01, 0.01, (2, n * n))
sheet = np.column_stack([x, y, np.sin(2.0 * x) * np.cos(y) + 0.1 * x * y])
corner = np.add.outer(n * np.arange(n - 1), np.arange(n - 1)).ravel()
lower = np.column_stack([corner, corner + 1, corner + n + 1])
upper = np.column_stack([corner, corner + n + 1, corner + n])

NAMES = ["undecided", "max. elliptic", "max. hyperbolic", "min. elliptic", "min. hyperbolic"]
ridges = ridges_of(sheet, np.vstack([lower, upper]))
for ridge_type, line in sorted(ridges, key=lambda ridge: -len(ridge[1]))[:10]:
    print(f"{len(line):4} points, {line[0].round(2)} to {line[-1].round(2)}: {NAMES[ridge_type]}")
