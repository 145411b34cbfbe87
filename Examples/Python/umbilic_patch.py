# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Close-up of an umbilic: the triangles of its patch, and how ridges are joined to it.

    python3 umbilic_patch.py [--umbilic N] [--noise EDGES] [--picture FILE.png]

The mesh is the example surface of RR-5294, Fig. 25, with its points moved at random. On the left
ridges are joined in singular triangles (section 6.2), on the right in patches (section 6.3).
"""

import argparse
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

import vtkridges

# Outside, in a patch, where umbilics have cancelled each other.
REGIONS = [(0.95, 0.95, 0.95), (1.0, 0.9, 0.6), (0.7, 0.9, 0.9)]

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--umbilic", type=int, default=5, help="its id")
parser.add_argument("--noise", type=float, default=0.003, help="standard deviation, in mean edges")
parser.add_argument("--points", type=int, default=60, help="least number to fit to")
parser.add_argument("--frequency", type=int, default=40, help="fineness of the mesh")
parser.add_argument("--picture", help="a .png file to draw")
arguments = parser.parse_args()

source = vtkridges.vtkRidgeExampleSource()
source.SetFrequency(arguments.frequency)
source.Update()
mesh = source.GetOutput()
positions = vtk_to_numpy(mesh.GetPoints().GetData())
corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
edge = np.linalg.norm(positions[corners[:, 0]] - positions[corners[:, 1]], axis=1).mean()
positions += arguments.noise * edge * np.random.default_rng(1).normal(size=positions.shape)

jets = vtkridges.vtkJetFitting()
jets.SetInputData(mesh)
jets.SetNeighborhoodToPointCount()
jets.SetMinimumNumberOfPoints(arguments.points)
umbilics = vtkridges.vtkUmbilicDetection()
umbilics.SetInputConnection(jets.GetOutputPort())
umbilics.Update()
found = umbilics.GetOutput(1)
for i in range(found.GetNumberOfPoints()):
    arrays = [found.GetPointData().GetArray(name) for name in ("Index", "RidgeCount", "Pattern")]
    values = [f"{array.GetName()} {array.GetTuple1(i):g}" for array in arrays]
    print(f"{i}:", np.round(found.GetPoint(i), 4), ", ".join(values))

chosen = arguments.umbilic
if not 0 <= chosen < found.GetNumberOfPoints():
    sys.exit("there is no such umbilic")
center = np.array(found.GetPoint(chosen))
patches = vtk_to_numpy(umbilics.GetOutput().GetCellData().GetArray("UmbilicPatch"))
reach = np.linalg.norm(positions[corners[patches == chosen]] - center, axis=-1).max()
nearest = np.linalg.norm(positions - center, axis=1).argmin()
normal = umbilics.GetOutput().GetPointData().GetNormals().GetTuple3(nearest)
index = found.GetPointData().GetArray("Index").GetTuple1(chosen)

# What is drawn of the mesh: patches and regions of cancelled umbilics in their colours.
cancelled = vtk_to_numpy(umbilics.GetOutput().GetCellData().GetArray("CancelledUmbilics"))
region = numpy_to_vtk(np.where(patches >= 0, 1, np.where(cancelled >= 0, 2, 0)), deep=True)
region.SetName("Region")
marked = vtkPolyData()
marked.ShallowCopy(umbilics.GetOutput())
marked.GetCellData().AddArray(region)
marks = vtkTrivialProducer()
marks.SetOutput(marked)

panels = []
for name, caption in (("Triangles", "joined in singular triangles"), ("Patches", "in patches")):
    ridges = vtkridges.vtkRidgeExtraction()
    ridges.SetInputConnection(umbilics.GetOutputPort())
    getattr(ridges, f"SetUmbilicJoiningTo{name}")()
    ridges.Update()
    if arguments.picture:
        import drawing

        panel = drawing.Panel(caption)
        panel.surface(marks.GetOutputPort(), edges=(0.7, 0.7, 0.7), colors=REGIONS, array="Region")
        panel.ridges(ridges.GetOutputPort(), 0.03 * reach)
        panel.balls(umbilics.GetOutputPort(1), 0.09 * reach, drawing.UMBILICS[index])
        up = np.cross(normal, (1.0, 0.0, 0.0))
        panel.look(center, normal, up, 4.6 * reach)
        panels.append(panel)

if arguments.picture:
    drawing.write(arguments.picture, panels, 480, 380)
