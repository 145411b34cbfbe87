# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The feature lines of a scan: python3 salient.py [mesh.ply]

Writes lines.vtp. Without a mesh it takes the example surface of RR-5294, Fig. 25.
"""

import sys

from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import vtkridges

mesh = vtkPLYReader() if len(sys.argv) > 1 else vtkridges.vtkRidgeExampleSource()
if len(sys.argv) > 1:
    mesh.SetFileName(sys.argv[1])
lines = vtkridges.vtkSalientRidges()
lines.SetInputConnection(mesh.GetOutputPort())
lines.SetFoldAngle(15.0)
writer = vtkXMLPolyDataWriter()
writer.SetFileName("lines.vtp")
writer.SetInputConnection(lines.GetOutputPort())
if not writer.Write():
    sys.exit("cannot write lines.vtp")
print(lines.GetOutput().GetNumberOfLines(), "lines")
