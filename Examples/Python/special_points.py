# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Umbilics, turning points and purple points on the ridges of the surface of RR-5294, Fig. 25.

    python3 special_points.py [--picture FILE.png]
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

import vtkridges

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--picture", help="a .png file to draw")
arguments = parser.parse_args()

mesh = vtkridges.vtkRidgeExampleSource()
jets = vtkridges.vtkJetFitting()
umbilics = vtkridges.vtkUmbilicDetection()
ridges = vtkridges.vtkRidgeExtraction()
ridges.FindPurplePointsOn()  # port 1
stages = [mesh, jets, umbilics, ridges]
for stage, following in zip(stages, stages[1:]):
    following.SetInputConnection(stage.GetOutputPort())
ridges.Update()

# Consecutive polylines of a ridge share a turning point: each is there once.
flags = vtk_to_numpy(ridges.GetOutput().GetPointData().GetArray("TurningPoint"))
chosen = vtkPoints()
for i in np.flatnonzero(flags):
    chosen.InsertNextPoint(ridges.GetOutput().GetPoint(i))
turning = vtkPolyData()
turning.SetPoints(chosen)
print(umbilics.GetOutput(1).GetNumberOfPoints(), "umbilics")
print(turning.GetNumberOfPoints(), "turning points")
print(ridges.GetOutput(1).GetNumberOfPoints(), "purple points")

if arguments.picture:
    import drawing

    source = vtkTrivialProducer()
    source.SetOutput(turning)
    center = np.mean(np.reshape(mesh.GetOutput().GetBounds(), (3, 2)), axis=1)
    panels = []
    for side in (1.0, -1.0):
        panel = drawing.Panel()
        panel.surface(umbilics.GetOutputPort())
        panel.ridges(ridges.GetOutputPort(), 0.004)
        panel.balls(umbilics.GetOutputPort(1), 0.012, (0.0, 0.0, 0.0))
        panel.balls(source.GetOutputPort(), 0.011, (1.0, 1.0, 1.0))
        panel.balls(ridges.GetOutputPort(1), 0.011, (0.6, 0.2, 0.7))
        panel.look(center, (0.5 * side, -0.85 * side, 0.25), (0.0, 0.0, 1.0), 0.82)
        panels.append(panel)
    panels[0].caption = "black: umbilics, white: turning points"
    panels[1].caption = "purple: a blue or green ridge crosses a red or yellow one"
    drawing.write(arguments.picture, panels, 480, 440)
