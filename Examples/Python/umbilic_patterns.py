# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Lemon, monstar and stars: how curvature lines and ridges meet at an umbilic.

    python3 umbilic_patterns.py [--picture FILE.png]

Each surface is the graph of a paraboloid of revolution plus a cubic form, with the umbilic in the
middle. All four forms are b0 x³ + 3 b2 x y², up to a turn of the mesh.
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkDelaunay2D

import vtkridges

PATTERNS = {1: "lemon", 2: "monstar", 3: "star"}
CURVATURE = -0.1
FORMS = [(0.4, 0.08), (0.4, 0.32), (0.25, 0.4), (0.3, -0.3)]  # b0, b2


def graph(b0, b2):
    """The surface over a disk that is a bit larger than what is drawn of it."""
    steps = np.arange(-60, 61)
    i, j = (grid.ravel() for grid in np.meshgrid(steps, steps))
    turn = np.exp(0.3j)
    flat = turn * ((i + 0.21) + (j + 0.13) * np.exp(1j * np.pi / 3)) / 45.0  # even triangles
    flat = flat[np.abs(flat) < 1.3]
    x, y = flat.real, flat.imag
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.column_stack([x, y, 0.0 * x]), deep=True))
    disk = vtkPolyData()
    disk.SetPoints(points)
    triangles = vtkDelaunay2D()
    triangles.SetInputData(disk)
    triangles.Update()
    mesh = triangles.GetOutput()
    z = CURVATURE / 2 * (x**2 + y**2) + (b0 * x**3 + 3 * b2 * x * y**2) / 6
    vtk_to_numpy(mesh.GetPoints().GetData())[:, 2] = z
    mesh.GetPoints().Modified()
    return mesh


def stages_of(mesh):
    jets = vtkridges.vtkJetFitting()
    jets.SetInputData(mesh)
    umbilics = vtkridges.vtkUmbilicDetection()
    umbilics.SetInputConnection(jets.GetOutputPort())
    ridges = vtkridges.vtkRidgeExtraction()
    ridges.SetInputConnection(umbilics.GetOutputPort())
    lines = vtkridges.vtkPrincipalFoliation()
    lines.SetInputConnection(umbilics.GetOutputPort())
    lines.SetSeparation(0.07)
    lines.SetLeastDistance(0.3)  # longer lines, less even
    lines.StopAtUmbilicPatchesOff()  # the surface has no noise
    for stage in (ridges, lines):
        stage.Update()
    return umbilics, ridges, lines


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--picture", help="a .png file to draw")
arguments = parser.parse_args()

panels = []
for b0, b2 in FORMS:
    umbilics, ridges, lines = stages_of(graph(b0, b2))
    found = umbilics.GetOutput(1)
    nearest = int(np.argmin(np.hypot(*vtk_to_numpy(found.GetPoints().GetData())[:, :2].T)))
    name, index, count = (
        found.GetPointData().GetArray(array).GetTuple1(nearest)
        for array in ("Pattern", "Index", "RidgeCount")
    )
    caption = f"{PATTERNS[int(name)]}, index {int(2 * index):+}/2, {int(count)}-ridge"
    print(f"b0 = {b0}, b2 = {b2}: {caption}")
    if arguments.picture:
        import drawing

        panel = drawing.Panel(caption)
        panel.surface(umbilics.GetOutputPort())
        panel.lines(lines.GetOutputPort(), 0.005)
        panel.ridges(ridges.GetOutputPort(), 0.014)
        panel.balls(umbilics.GetOutputPort(1), 0.035, drawing.UMBILICS[index])
        panel.look((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 1.0, 0.0), 1.7)
        panels.append(panel)

if arguments.picture:
    drawing.write(arguments.picture, panels, 250, 250)
