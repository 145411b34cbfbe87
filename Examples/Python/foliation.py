# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Curvature lines with ridges and umbilics, as in RR-5294, Fig. 1: python3 foliation.py --help

Writes blue.vtp and red.vtp, the lines of the maximum and of the minimum curvature. The picture has
both side by side; drawing needs an X server, maybe a virtual one (xvfb-run -a python3 ...).
"""

import argparse
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkStaticCleanPolyData
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import vtkridges

READERS = {
    "obj": vtkOBJReader,
    "ply": vtkPLYReader,
    "stl": vtkSTLReader,
    "vtp": vtkXMLPolyDataReader,
}

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0].split(":")[0])
parser.add_argument("mesh", nargs="?", help=".ply, .obj, .stl or .vtp; else the paper's ellipsoid")
parser.add_argument("--separation", type=float, default=0.06, help="of lines, by model size")
parser.add_argument("--points", type=int, help="least number to fit to [chosen by the noise]")
parser.add_argument("--sharpness", type=float, default=0.0, help="least one of ridges")
parser.add_argument("--picture", help="a .png file to draw")
parser.add_argument("--view", default="0.45,1,0.8", help="direction to the viewer")
parser.add_argument("--up", default="0,0,1", help="direction that is up in the picture")
arguments = parser.parse_args()

mesh = vtkridges.vtkRidgeExampleSource()
mesh.SetSurfaceToEllipsoid()
mesh.SetFrequency(32)  # 10k points
if arguments.mesh:
    reader = READERS[arguments.mesh.rsplit(".", 1)[-1].lower()]()
    reader.SetFileName(arguments.mesh)
    mesh = vtkStaticCleanPolyData()  # merges points that coincide
    mesh.SetInputConnection(reader.GetOutputPort())

jets = vtkridges.vtkJetFitting()
if arguments.points:
    jets.SetNeighborhoodToPointCount()
    jets.SetMinimumNumberOfPoints(arguments.points)
umbilics = vtkridges.vtkUmbilicDetection()
ridges = vtkridges.vtkRidgeExtraction()
salient = vtkridges.vtkRidgeSharpnessFilter()
salient.SetMinimumSharpness(arguments.sharpness)
stages = [mesh, jets, umbilics, ridges, salient]
for stage, following in zip(stages, stages[1:]):
    following.SetInputConnection(stage.GetOutputPort())

foliations = {}
for name, direction in (("blue", "Maximum"), ("red", "Minimum")):
    foliation = vtkridges.vtkPrincipalFoliation()
    foliation.SetInputConnection(umbilics.GetOutputPort())
    getattr(foliation, f"SetDirectionTo{direction}")()
    foliation.SetSeparation(arguments.separation)
    foliation.SetStopAtUmbilicPatches(bool(arguments.mesh))  # the ellipsoid has no noise
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(f"{name}.vtp")
    writer.SetInputConnection(foliation.GetOutputPort())
    if not writer.Write():
        sys.exit(f"cannot write {name}.vtp")
    lines = foliation.GetOutput()
    closed = lines.GetCellData().GetArray("Closed")
    loops = int(vtk_to_numpy(closed).sum()) if lines.GetNumberOfLines() else 0
    print(f"{name}: {lines.GetNumberOfLines()} lines, {loops} of them closed")
    foliations[name] = foliation

if not arguments.picture:
    sys.exit()

# ------------------------------------------------------------------------------------ the picture

import drawing  # noqa: E402

WIDTH, HEIGHT = 500, 330
back = np.array([float(x) for x in arguments.view.split(",")])
up = np.array([float(x) for x in arguments.up.split(",")])
right = np.cross(up, back)
axes = np.array([axis / np.linalg.norm(axis) for axis in (right, np.cross(back, right), back)])
points = vtk_to_numpy(umbilics.GetOutput().GetPoints().GetData()) @ axes.T
low, high = points.min(axis=0), points.max(axis=0)
center, size = (low + high) / 2 @ axes, np.linalg.norm(high - low) / 1.5
height = 1.06 * max(high[1] - low[1], (high[0] - low[0]) * HEIGHT / WIDTH)

panels = []
for foliation in foliations.values():
    panel = drawing.Panel()
    panel.surface(umbilics.GetOutputPort())
    panel.lines(foliation.GetOutputPort(), 0.0016 * size)
    panel.ridges(salient.GetOutputPort(), 0.0032 * size)
    panel.balls(umbilics.GetOutputPort(1), 0.008 * size, (0.0, 0.0, 0.0))
    panel.look(center, back, up, height)
    panels.append(panel)
drawing.write(arguments.picture, panels, WIDTH, HEIGHT)
