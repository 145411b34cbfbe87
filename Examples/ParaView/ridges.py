# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ridges and umbilics of a mesh in ParaView: pvpython ridges.py [MESH [PICTURE.png]]

MESH is anything that ParaView reads as polygons (PLY, OBJ, STL, VTP); without one an example surface
is taken. The plugin is found by PV_PLUGIN_PATH. A picture and the state ridges.pvsm are written.
"""

import sys

from paraview.simple import *

if len(sys.argv) > 1:
    mesh = OpenDataFile(sys.argv[1])
else:
    mesh = RidgeExampleSource(Surface="Blend")

# One filter for all of it: ridges, umbilics and the mesh with its curvatures. Of a scan, keep what
# is sharp: MinimumSharpness=300.
ridges = RidgesAndUmbilics(Input=mesh, MinimumSharpness=1.0)

view = CreateRenderView(ViewSize=[1200, 900], OrientationAxesVisibility=0)
for port in range(3):  # lines, points, and the surface they are on
    display = Show(OutputPort(ridges, port), view)
    if port < 2:  # in the colors of types and indices, with a legend
        display.SetScalarBarVisibility(view, True)
view.CameraPosition = [1.0, -1.0, 0.4]
view.CameraViewUp = [0.0, 0.0, 1.0]
ResetCamera(view)

SaveScreenshot(sys.argv[2] if len(sys.argv) > 2 else "ridges.png", view)
SaveState("ridges.pvsm")

ridges.UpdatePipeline()
lines = ridges.GetDataInformation(0).GetNumberOfCells()
points = ridges.GetDataInformation(1).GetNumberOfPoints()
print(f"{lines} ridges, {points} umbilics")
