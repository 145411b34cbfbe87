# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The complete ridges of a noisy surface at a scale, and whether they are consistent:

    python3 coherence.py [mesh.vtp]

Prints each check of vtkRidgeCoherence with what it found. Without an argument it takes an ellipsoid
with noise.
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import vtkridges

if len(sys.argv) > 2:
    sys.exit(__doc__)
if len(sys.argv) == 2:
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(sys.argv[1])
    reader.Update()
    mesh = reader.GetOutput()
else:
    source = vtkridges.vtkRidgeExampleSource()
    source.SetSurfaceToEllipsoid()
    source.SetFrequency(40)
    source.Update()
    mesh = source.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    points += np.random.default_rng(1).normal(scale=2e-4, size=points.shape)

jets = vtkridges.vtkJetFitting()  # finds out how noisy the mesh is
jets.SetInputDataObject(mesh)
smooth = vtkridges.vtkMongeSmoothing()
smooth.SetMethodToAllOrders()  # for the complete ridges; the default is for salient lines
smooth.SetRelativeSigma(0.02)  # of the diameter of the model
umbilics = vtkridges.vtkUmbilicDetection()
ridges = vtkridges.vtkRidgeExtraction()
stages = [jets, smooth, umbilics, ridges]
for stage, following in zip(stages, stages[1:]):
    following.SetInputConnection(stage.GetOutputPort())

coherence = vtkridges.vtkRidgeCoherence()
coherence.SetInputConnection(0, umbilics.GetOutputPort())
coherence.SetInputConnection(1, ridges.GetOutputPort())
coherence.SetInputConnection(2, umbilics.GetOutputPort(1))
coherence.Update()
if ridges.GetOutput().GetNumberOfPoints() == 0:
    sys.exit("there are no ridges")

print(umbilics.GetOutput(1).GetNumberOfPoints(), "umbilics")
print(ridges.GetOutput().GetNumberOfLines(), "lines")
table = coherence.GetOutput()
wrong = 0
for row in range(table.GetNumberOfRows()):
    check, found = (table.GetValueByName(row, name).ToString() for name in ("Check", "Found"))
    severity = table.GetValueByName(row, "Severity").ToInt()
    wrong += severity == 2
    print(f"{check:22} {('passed', 'uncertain', 'wrong')[severity]:10} {found}")
sys.exit(1 if wrong else 0)
