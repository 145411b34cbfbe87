# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The feature lines of a scan with PyVista: the surface, and its crests and valleys as tubes.

    python3 pyvista_salient.py [MESH] [--fold-angle DEGREES] [--picture FILE.png]

MESH is a surface in a file that PyVista reads; without it, it is the surface of RR-5294, Fig. 25.
Without a picture a window opens.
"""

import argparse

import pyvista

import vtkridges
import vtkridges.pyvista

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("mesh", nargs="?", help="a file that PyVista reads")
parser.add_argument("--fold-angle", type=float, default=15.0, help="degrees; more: fewer lines")
parser.add_argument("--picture", help="a .png file to draw")
arguments = parser.parse_args()

if arguments.mesh:
    mesh = pyvista.read(arguments.mesh).triangulate().clean()
else:
    source = vtkridges.vtkRidgeExampleSource()
    source.Update()
    mesh = pyvista.wrap(source.GetOutput())

# mesh.ridges.salient(...) is the same where PyVista has accessors.
lines = vtkridges.pyvista.salient(mesh, fold_angle=arguments.fold_angle)
print(lines.n_cells, "lines")

plotter = pyvista.Plotter(off_screen=arguments.picture is not None, window_size=[900, 800])
plotter.set_background("white")
plotter.add_mesh(mesh, color="#f2efe8", smooth_shading=True)
if lines.n_cells:
    plotter.add_mesh(lines.tube(radius=0.002 * mesh.length), scalars="RidgeType_rgb", rgb=True)
plotter.camera_position = [(0.4, 0.3, 1.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
plotter.reset_camera()
plotter.camera.zoom(1.25)
plotter.show(screenshot=arguments.picture)
