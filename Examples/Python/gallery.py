# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ways to choose the lines of a scan, side by side at equal total length, as in RR-5294, Fig. 26.

    python3 gallery.py [MESH] [--picture FILE.png] [--view X,Y,Z] [--up X,Y,Z]

All elliptic ridges of a fit whose scale was chosen by the noise; the strongest and the sharpest of
them, as long together as the salient lines; and these. MESH is a .ply, .obj, .stl or .vtp file;
without it, it is the surface of Fig. 25.
"""

import argparse
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import vtkridges

READERS = {
    "ply": vtkPLYReader,
    "obj": vtkOBJReader,
    "stl": vtkSTLReader,
    "vtp": vtkXMLPolyDataReader,
}


def vector(text):
    return [float(x) for x in text.split(",")]


def cell_array(lines, name):
    array = lines.GetCellData().GetArray(name)
    return vtk_to_numpy(array) if array else np.zeros(0)


def longest_by(name, ridges, length):
    """The lines with most of a quantity that are as long together as `length`."""
    lines = ridges.GetOutput()
    values = cell_array(lines, name)
    order = np.argsort(-values, kind="stable")
    total = np.cumsum(cell_array(lines, "Length")[order])
    keep = vtkridges.vtkRidgeSharpnessFilter()
    keep.SetInputConnection(ridges.GetOutputPort())
    keep.SetRankBy({"Strength": keep.STRENGTH, "Sharpness": keep.SHARPNESS}[name])
    keep.SetMaximumNumber(max(1, int(np.searchsorted(total, length))))
    keep.Update()
    return keep


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("mesh", nargs="?", help="a .ply, .obj, .stl or .vtp file")
parser.add_argument("--picture", help="a .png file to draw")
parser.add_argument("--view", type=vector, default=[0.4, 0.3, 1.0], help="from model to viewer")
parser.add_argument("--up", type=vector, default=[0.0, 1.0, 0.0], help="up in the picture")
arguments = parser.parse_args()

if arguments.mesh:
    kind = arguments.mesh.rsplit(".", 1)[-1].lower()
    if kind not in READERS:
        sys.exit(f"{arguments.mesh}: not one of {', '.join(READERS)}")
    reader = READERS[kind]()
    reader.SetFileName(arguments.mesh)
else:
    reader = vtkridges.vtkRidgeExampleSource()
triangles = vtkTriangleFilter()
triangles.SetInputConnection(reader.GetOutputPort())
mesh = vtkCleanPolyData()  # files as STL have points once a triangle
mesh.SetInputConnection(triangles.GetOutputPort())

salient = vtkridges.vtkSalientRidges()
salient.SetInputConnection(mesh.GetOutputPort())
salient.Update()

every = vtkridges.vtkRidgesAndUmbilics()
every.SetInputConnection(mesh.GetOutputPort())
every.KeepMaximumHyperbolicOff()
every.KeepMinimumHyperbolicOff()
every.KeepUndecidedOff()
every.Update()

length = cell_array(salient.GetOutput(), "Length").sum()
ways = {
    "all elliptic ridges": every,
    "the strongest": longest_by("Strength", every, length),
    "the sharpest": longest_by("Sharpness", every, length),
    "salient lines": salient,
}
for name, way in ways.items():
    lines = way.GetOutput()
    print(f"{name}: {lines.GetNumberOfLines()} lines, length {cell_array(lines, 'Length').sum():.4g}")

if arguments.picture:
    import drawing

    bounds = np.reshape(mesh.GetOutput().GetBounds(), (3, 2))
    size = np.linalg.norm(bounds[:, 1] - bounds[:, 0])
    panels = []
    for name, way in ways.items():
        panel = drawing.Panel(f"{name}\n{way.GetOutput().GetNumberOfLines()} lines")
        panel.surface(mesh.GetOutputPort())
        panel.ridges(way.GetOutputPort(), 0.0025 * size)
        panel.look(bounds.mean(axis=1), arguments.view, arguments.up, 0.75 * size)
        panels.append(panel)
    drawing.write(arguments.picture, panels, 420, 420)
