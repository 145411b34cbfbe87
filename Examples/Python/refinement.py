# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Refines a coarse mesh of a surface until it can be proved that all ridges are found.

    python3 refinement.py ["f(x, y, z)" xmin xmax ymin ymax zmin zmax edge-length]

Writes refined.vtp and prints the verdict on each hypothesis. Without arguments it takes an ellipsoid.
"""

import sys

from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import vtkridges

ellipsoid = ["x^2 + y^2/0.64 + z^2/0.36 - 1", -1.1, 1.1, -0.9, 0.9, -0.7, 0.7, 0.33]
if len(sys.argv) not in (1, 9):
    sys.exit(__doc__)
formula, *numbers = sys.argv[1:] or ellipsoid

mesh = vtkridges.vtkImplicitSurfaceMesh()
mesh.SetFormula(formula)
mesh.SetBounds([float(number) for number in numbers[:6]])
mesh.SetEdgeLength(float(numbers[6]))
refinement = vtkridges.vtkCompliantRefinement()  # takes the formula from the mesh
refinement.SetInputConnection(mesh.GetOutputPort())

writer = vtkXMLPolyDataWriter()
writer.SetFileName("refined.vtp")
writer.SetInputConnection(refinement.GetOutputPort())
if not writer.Write():
    sys.exit("cannot write refined.vtp")
if mesh.GetOutput().GetNumberOfPoints() == 0:
    sys.exit("there is no surface")

before, after = (stage.GetOutput().GetNumberOfPoints() for stage in (mesh, refinement))
print(before, "points,", after, "after refinement")
table = refinement.GetOutputDataObject(1)
for row in range(table.GetNumberOfRows()):
    print(*(table.GetValueByName(row, name).ToString() for name in ("Check", "Verdict")), sep=": ")
