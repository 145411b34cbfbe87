# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors of k and d by libigl and PyMeshLab: python3 accuracy_of_others.py FOLDER

FOLDER has the meshes of `RidgesAccuracy --write` with their exact curvatures. Errors are as in the
tables that RidgesAccuracy prints. Called by accuracy.sh.
"""

import sys
import time
from pathlib import Path

import igl
import numpy as np
import pymeshlab


def read(path):
    lines = path.read_text(encoding="utf-8").split("\n")
    points, triangles, _ = map(int, lines[1].split())
    mesh = np.array([line.split() for line in lines[2 : 2 + points]], dtype=float)
    faces = np.array([line.split()[1:] for line in lines[2 + points : 2 + points + triangles]], dtype=np.int64)
    return mesh, faces, np.loadtxt(path.with_suffix(".exact"))


def by_libigl(points, faces):
    d1, _, k1, k2 = igl.principal_curvature(points, faces)[:4]
    return k1, k2, d1


def by_meshlab(points, faces):
    curvatures = []
    for kind in ("Min Curvature", "Max Curvature"):
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(points, faces))
        meshes.compute_curvature_principal_directions_per_vertex(
            method="Quadric Fitting", curvcolormethod=kind
        )
        curvatures.append(meshes.current_mesh().vertex_scalar_array())
    return *curvatures, meshes.current_mesh().vertex_curvature_principal_dir1_matrix()


def errors(k1, k2, d1, exact):
    """Conventions differ: with the sign and, at each point, the order that suit best."""
    of_k = []
    for sign in (1.0, -1.0):
        high = np.maximum(sign * k1, sign * k2)
        low = np.minimum(sign * k1, sign * k2)
        square = ((high - exact[:, 0]) ** 2 + (low - exact[:, 1]) ** 2).sum()
        of_k.append(np.sqrt(square / (exact[:, :2] ** 2).sum()))
    gap = exact[:, 0] - exact[:, 1]
    use = gap > 0.1 * gap.mean()
    cosine = np.abs((d1 * exact[:, 2:]).sum(axis=1)) / np.maximum(np.linalg.norm(d1, axis=1), 1e-300)
    angle = np.degrees(np.arccos(np.clip(cosine, 0, 1)))[use]
    # MeshLab's first direction is that of either curvature, from point to point.
    return min(of_k), np.sqrt((np.minimum(angle, 90 - angle) ** 2).mean())


def main():
    print("| mesh                       | by                   | k       | d       |   time |")
    print("|----------------------------|----------------------|---------|---------|--------|")
    for path in sorted(Path(sys.argv[1]).glob("*.off")):
        points, faces, exact = read(path)
        for name, method in (("libigl, 5 rings", by_libigl), ("PyMeshLab, quadrics", by_meshlab)):
            begin = time.process_time()
            result = method(points, faces)
            took = 1e6 * (time.process_time() - begin) / len(points)
            of_k, of_d = errors(*result, exact)
            mesh = path.stem.replace("_", " ")
            print(f"| {mesh:26} | {name:20} | {of_k:.1e} | {of_d:.1e} | {took:6.1f} |", flush=True)


if __name__ == "__main__":
    main()
