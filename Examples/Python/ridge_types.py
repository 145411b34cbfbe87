# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The four types of ridges in their colours, each on a patch of a surface that shows what it is.

    python3 ridge_types.py [--picture FILE.png]

Normals point up, out of what is solid. Across the ridge run lines of the curvature it belongs to.
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkDelaunay2D

import vtkridges

# RidgeType, profile across the ridge, caption. Along the ridge all are curved a little.
PATCHES = [
    (3, lambda x: -np.sqrt(0.2 + 1.2 * x**2), "red: minimum elliptic\nk2 is least on it"),
    (4, lambda x: -0.1 * x**2 - 0.6 * x**4, "yellow: minimum hyperbolic\nk2 is greatest on it"),
    (1, lambda x: np.sqrt(0.2 + 1.2 * x**2), "blue: maximum elliptic\nk1 is greatest on it"),
    (2, lambda x: 0.1 * x**2 + 0.6 * x**4, "green: maximum hyperbolic\nk1 is least on it"),
]


def sheet(profile):
    steps = np.linspace(-1.0, 1.0, 61) + 0.004  # no point exactly on the ridge
    x, y = (grid.ravel() for grid in np.meshgrid(steps, steps))
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.column_stack([x, y, 0.0 * x]), deep=True))
    square = vtkPolyData()
    square.SetPoints(points)
    triangles = vtkDelaunay2D()
    triangles.SetInputData(square)
    triangles.Update()
    mesh = triangles.GetOutput()
    bend = 0.01 * np.sign(profile(1.0) - profile(0.0))
    vtk_to_numpy(mesh.GetPoints().GetData())[:, 2] = profile(x) + bend * (y - 0.3 * y**2) * y
    mesh.GetPoints().Modified()
    return mesh


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--picture", help="a .png file to draw")
arguments = parser.parse_args()

panels = []
for ridge_type, profile, caption in PATCHES:
    of_maximum = ridge_type in (1, 2)
    jets = vtkridges.vtkJetFitting()
    jets.SetInputData(sheet(profile))
    ridges = vtkridges.vtkRidgeExtraction()
    ridges.SetInputConnection(jets.GetOutputPort())
    ridges.SetExtractMaximum(of_maximum)
    ridges.SetExtractMinimum(not of_maximum)
    only = vtkridges.vtkRidgeSharpnessFilter()
    only.SetInputConnection(ridges.GetOutputPort())
    only.SetMinimumLength(1.0)
    for kind, name in enumerate(
        ["MaximumElliptic", "MaximumHyperbolic", "MinimumElliptic", "MinimumHyperbolic"], 1
    ):
        getattr(only, f"SetKeep{name}")(kind == ridge_type)
    lines = vtkridges.vtkPrincipalFoliation()
    lines.SetInputConnection(jets.GetOutputPort())
    lines.SetDirection(lines.MAXIMUM if of_maximum else lines.MINIMUM)
    lines.SetSeparation(0.18)
    only.Update()
    print(f"{caption.splitlines()[0]}: {only.GetOutput().GetNumberOfLines()} of length 1 or more")
    if arguments.picture:
        import drawing

        panel = drawing.Panel(caption)
        panel.surface(jets.GetOutputPort())
        panel.lines(lines.GetOutputPort(), 0.012)
        panel.ridges(only.GetOutputPort(), 0.03)
        low, high = jets.GetOutput().GetBounds()[4:]
        panel.look((0.0, 0.0, (low + high) / 2), (0.35, -1.0, 0.75), (0.0, 0.0, 1.0), 2.3)
        panels.append(panel)

if arguments.picture:
    drawing.write(arguments.picture, panels, 250, 200)
