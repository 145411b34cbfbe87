# SPDX-License-Identifier: BSD-3-Clause
"""Curvature lines with ridges and umbilics, as in RR-5294, Fig. 1: python3 foliation.py --help

Writes blue.vtp and red.vtp, the lines of the maximum and of the minimum curvature. The picture has
both side by side; drawing needs an X server, maybe a virtual one (xvfb-run -a python3 ...).
"""

import argparse
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkStaticCleanPolyData, vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import vtkridges

READERS = {
    "obj": vtkOBJReader,
    "ply": vtkPLYReader,
    "stl": vtkSTLReader,
    "vtp": vtkXMLPolyDataReader,
}
# Of ridges, by their type, and of curvature lines.
RIDGES = [(0.35, 0.35, 0.35), (0.0, 0.15, 0.75), (0, 0.55, 0.15), (0.75, 0, 0), (0.95, 0.62, 0)]
LINES = {"blue": (0.5, 0.6, 0.95), "red": (0.95, 0.55, 0.5)}

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0].split(":")[0])
parser.add_argument("mesh", nargs="?", help=".ply, .obj, .stl or .vtp; else the paper's ellipsoid")
parser.add_argument("--separation", type=float, default=0.06, help="of lines, by model size")
parser.add_argument("--points", type=int, default=18, help="least number to fit to")
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

import vtkmodules.vtkRenderingOpenGL2  # noqa: E402, F401, what draws
from vtkmodules.vtkRenderingCore import (  # noqa: E402
    vtkActor,
    vtkGlyph3DMapper,
    vtkLightKit,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)
from vtkmodules.vtkCommonCore import vtkLookupTable  # noqa: E402

WIDTH, HEIGHT = 1000, 380
back = np.array([float(x) for x in arguments.view.split(",")])
up = np.array([float(x) for x in arguments.up.split(",")])
right = np.cross(up, back)
axes = np.array([axis / np.linalg.norm(axis) for axis in (right, np.cross(back, right), back)])
points = vtk_to_numpy(umbilics.GetOutput().GetPoints().GetData()) @ axes.T
low, high = points.min(axis=0), points.max(axis=0)
center, size = (low + high) / 2 @ axes, np.linalg.norm(high - low) / 1.5
scale = 0.53 * max(high[1] - low[1], (high[0] - low[0]) * HEIGHT / (WIDTH / 2))


def add(renderer, mapper, color=None):
    actor = vtkActor()
    actor.SetMapper(mapper)
    if color:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(color)
        actor.GetProperty().SetAmbient(0.3)
        actor.GetProperty().SetDiffuse(0.75)
    renderer.AddActor(actor)


def tubes(port, radius):
    tube = vtkTubeFilter()
    tube.SetInputConnection(port)
    tube.SetRadius(radius * size)
    tube.SetNumberOfSides(8)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(tube.GetOutputPort())
    return mapper


def draw(renderer, foliation, color):
    surface = vtkPolyDataMapper()
    surface.SetInputConnection(umbilics.GetOutputPort())
    add(renderer, surface, (0.95, 0.95, 0.95))

    add(renderer, tubes(foliation.GetOutputPort(), 0.0016), color)

    table = vtkLookupTable()
    table.SetNumberOfTableValues(len(RIDGES))
    table.SetTableRange(0, len(RIDGES) - 1)
    for kind, rgb in enumerate(RIDGES):
        table.SetTableValue(kind, *rgb)
    types = tubes(salient.GetOutputPort(), 0.0032)
    types.SetScalarModeToUseCellFieldData()
    types.SelectColorArray("RidgeType")
    types.SetLookupTable(table)
    types.UseLookupTableScalarRangeOn()
    add(renderer, types)

    ball = vtkSphereSource()
    ball.SetRadius(0.008 * size)
    ball.SetPhiResolution(24)
    ball.SetThetaResolution(24)
    dots = vtkGlyph3DMapper()
    dots.SetInputConnection(umbilics.GetOutputPort(1))
    dots.SetSourceConnection(ball.GetOutputPort())
    dots.ScalingOff()
    add(renderer, dots, (0.0, 0.0, 0.0))


window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetMultiSamples(8)
window.SetSize(WIDTH, HEIGHT)
for i, (name, foliation) in enumerate(foliations.items()):
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.SetViewport(i / 2, 0.0, (i + 1) / 2, 1.0)
    draw(renderer, foliation, LINES[name])
    vtkLightKit().AddLightsToRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(center)
    camera.SetPosition(center + axes[2] * size)
    camera.SetViewUp(axes[1])
    renderer.ResetCamera()
    camera.SetParallelScale(scale)
    window.AddRenderer(renderer)
window.Render()

image = vtkWindowToImageFilter()
image.SetInput(window)
writer = vtkPNGWriter()
writer.SetFileName(arguments.picture)
writer.SetInputConnection(image.GetOutputPort())
writer.Write()
