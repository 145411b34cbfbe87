# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Exact ridges and umbilics of a surface given by a formula:

    python3 formula.py ["f(x, y, z)" xmin xmax ymin ymax zmin zmax edge-length]

Writes ridges.vtp and umbilics.vtp. Without arguments it takes the surface of RR-5294, Fig. 25.
"""

import sys

from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import vtkridges

mesh = vtkridges.vtkImplicitSurfaceMesh()
if len(sys.argv) == 9:
    mesh.SetFormula(sys.argv[1])
    mesh.SetBounds([float(text) for text in sys.argv[2:8]])
    mesh.SetEdgeLength(float(sys.argv[8]))
elif len(sys.argv) > 1:
    sys.exit(__doc__)

exact = vtkridges.vtkImplicitMongeForm()  # takes the formula from the mesh
umbilics = vtkridges.vtkUmbilicDetection()
ridges = vtkridges.vtkRidgeExtraction()
stages = [mesh, exact, umbilics, ridges]
for stage, following in zip(stages, stages[1:]):
    following.SetInputConnection(stage.GetOutputPort())

ridges.Update()
if mesh.GetOutput().GetNumberOfPoints() == 0:
    sys.exit("there is no surface")

outputs = {"ridges.vtp": ridges.GetOutputPort(), "umbilics.vtp": umbilics.GetOutputPort(1)}
for name, port in outputs.items():
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(name)
    writer.SetInputConnection(port)
    if not writer.Write():
        sys.exit(f"cannot write {name}")

field = umbilics.GetOutput().GetFieldData()
print(mesh.GetOutput().GetNumberOfPoints(), "points")
print(umbilics.GetOutput(1).GetNumberOfPoints(), "umbilics")
print("sum of their indices", field.GetArray("UmbilicIndexSum").GetValue(0))
print("Euler characteristic", field.GetArray("EulerCharacteristic").GetValue(0))
print(ridges.GetOutput().GetNumberOfLines(), "lines")
