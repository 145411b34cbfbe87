# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ridges and umbilics of a mesh: python3 ridges.py [mesh.ply | .stl | .obj | .vtp]

Writes ridges.vtp and umbilics.vtp. Without a mesh it takes the example surface of RR-5294, Fig. 25.
"""

import sys

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

mesh = vtkridges.vtkRidgeExampleSource()
if len(sys.argv) > 1:
    reader = READERS[sys.argv[1].rsplit(".", 1)[-1].lower()]()
    reader.SetFileName(sys.argv[1])
    mesh = vtkStaticCleanPolyData()  # merges points that coincide
    mesh.SetInputConnection(reader.GetOutputPort())

jets = vtkridges.vtkJetFitting()
umbilics = vtkridges.vtkUmbilicDetection()
ridges = vtkridges.vtkRidgeExtraction()
salient = vtkridges.vtkRidgeSharpnessFilter()
salient.SetMinimumSharpness(10.0)
stages = [mesh, jets, umbilics, ridges, salient]
for stage, following in zip(stages, stages[1:]):
    following.SetInputConnection(stage.GetOutputPort())

salient.Update()
if mesh.GetOutput().GetNumberOfPoints() == 0:
    sys.exit("there is no mesh")

outputs = {"ridges.vtp": salient.GetOutputPort(), "umbilics.vtp": umbilics.GetOutputPort(1)}
for name, port in outputs.items():
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(name)
    writer.SetInputConnection(port)
    if not writer.Write():
        sys.exit(f"cannot write {name}")

print(mesh.GetOutput().GetNumberOfPoints(), "points")
print(umbilics.GetOutput(1).GetNumberOfPoints(), "umbilics")
print(ridges.GetOutput().GetNumberOfLines(), "polylines, of which")
print(salient.GetOutput().GetNumberOfLines(), "are salient")
