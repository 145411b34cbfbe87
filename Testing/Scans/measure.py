# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Number, length and stability of salient lines: python3 measure.py [option=value ...] mesh ...

For each mesh (OFF, PLY or OBJ) lines are found on the mesh, on a decimation to half of its triangles,
and on a subdivision after Loop with noise of a tenth of an edge. Printed are the share of the
length of one that has a line of the other, of the same colour, within one and a half edges of the
coarser mesh, both ways. Options are properties of vtkSalientRidges, as FoldAngle=25. With the word
"controls" as mesh: the length of lines on surfaces that have none, with noise of 0, 0.05, 0.1 and
0.2 edges. With "creases:" before the name of the mesh of a part: how much of its creases, the edges
at which it turns by 20 degrees or more, has lines within one and a half edges, and the length of
lines that are farther from creases, with noise of 0, 0.005 and 0.02 edges.

Not run by ctest: the meshes are not part of this project, and it takes a minute.
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkQuadricDecimation, vtkStaticCleanPolyData
from vtkmodules.vtkFiltersModeling import vtkLoopSubdivisionFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkIOPLY import vtkPLYReader

import vtkridges


def make_mesh(points, triangles):
    mesh = vtkPolyData()
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=1))
    mesh.SetPoints(coordinates)
    cells = vtkCellArray()
    ids = np.ascontiguousarray(triangles, dtype=np.int64).ravel()
    cells.SetData(3, numpy_to_vtkIdTypeArray(ids, deep=1))
    mesh.SetPolys(cells)
    return mesh


def arrays_of(mesh):
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    return points, vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def run(algorithm, mesh):
    algorithm.SetInputData(mesh)
    algorithm.Update()
    return make_mesh(*arrays_of(algorithm.GetOutput()))


def merged(mesh):
    return run(vtkStaticCleanPolyData(), mesh)


def read(path):
    if path.endswith(".off"):
        with open(path, encoding="utf-8") as file:
            numbers = file.read().split()
        points, triangles = int(numbers[1]), int(numbers[2])
        end = 4 + 3 * points
        corners = np.array(numbers[end : end + 4 * triangles], dtype=np.int64).reshape(-1, 4)
        return make_mesh(np.array(numbers[4:end], dtype=float).reshape(-1, 3), corners[:, 1:])
    reader = vtkOBJReader() if path.endswith(".obj") else vtkPLYReader()
    reader.SetFileName(path)
    reader.Update()
    return merged(make_mesh(*arrays_of(reader.GetOutput())))


def mean_edge(mesh):
    points, triangles = arrays_of(mesh)
    sides = [points[triangles[:, i]] - points[triangles[:, i - 1]] for i in range(3)]
    return np.linalg.norm(np.concatenate(sides), axis=1).mean()


def add_noise(mesh, share_of_edge):
    points, triangles = arrays_of(mesh)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    normals = np.zeros_like(points)
    for i in range(3):
        np.add.at(normals, triangles[:, i], np.cross(b - a, c - a))
    normals /= np.linalg.norm(normals, axis=1)[:, None] + 1e-300
    noise = np.random.RandomState(1).randn(len(points), 1) * share_of_edge * mean_edge(mesh)
    return make_mesh(points + noise * normals, triangles)


def decimated(mesh):
    decimation = vtkQuadricDecimation()
    decimation.SetTargetReduction(0.5)
    return merged(run(decimation, mesh))


def subdivided(mesh):
    return add_noise(run(vtkLoopSubdivisionFilter(), mesh), 0.1)


class Lines:
    """Points along the lines, an even distance apart, with colours and the length that each has."""

    def __init__(self, mesh, step, options):
        finder = vtkridges.vtkSalientRidges()
        for name, value in options.items():
            getattr(finder, "Set" + name)(value)
        finder.SetInputData(mesh)
        finder.Update()
        lines = finder.GetOutput()
        self.count = lines.GetNumberOfLines()
        positions, colours, lengths = [np.zeros((0, 3))], [np.zeros(0)], [np.zeros(0)]
        if self.count:
            points = vtk_to_numpy(lines.GetPoints().GetData())
            ids = vtk_to_numpy(lines.GetLines().GetConnectivityArray())
            begins = vtk_to_numpy(lines.GetLines().GetOffsetsArray())
            types = vtk_to_numpy(lines.GetCellData().GetArray("RidgeType"))
            for line in range(self.count):
                line_points = points[ids[begins[line] : begins[line + 1]]]
                pieces = np.linalg.norm(np.diff(line_points, axis=0), axis=1)
                arc = np.concatenate([[0.0], np.cumsum(pieces)])
                number = max(1, int(np.ceil(arc[-1] / step)))
                at = arc[-1] * (np.arange(number) + 0.5) / number
                positions.append(
                    np.stack([np.interp(at, arc, line_points[:, i]) for i in range(3)], axis=1)
                )
                colours.append(np.full(number, types[line]))
                lengths.append(np.full(number, arc[-1] / number))
        self.positions = np.concatenate(positions)
        self.colours = np.concatenate(colours)
        self.lengths = np.concatenate(lengths)

    def share_near(self, other, tolerance):
        """The share of the length that has points of the other lines nearby."""
        near = 0.0
        for colour in (1, 3):
            ours = self.positions[self.colours == colour]
            theirs = other.positions[other.colours == colour]
            lengths = self.lengths[self.colours == colour]
            for begin in range(0, len(ours) if len(theirs) else 0, 256):
                chunk = ours[begin : begin + 256]
                squares = ((chunk[:, None] - theirs[None]) ** 2).sum(axis=2).min(axis=1)
                near += lengths[begin : begin + 256][squares <= tolerance**2].sum()
        total = self.lengths.sum()
        return near / total if total else 1.0


def size_of(mesh):
    points, _ = arrays_of(mesh)
    return 2.0 * np.linalg.norm(points - points.mean(axis=0), axis=1).max()


def measure(path, options):
    mesh = read(path)
    edge = mean_edge(mesh)
    lines = Lines(mesh, edge / 3, options)
    texts = [f"{path}: {lines.count} lines, {lines.lengths.sum() / size_of(mesh):.2f} D"]
    for name, change in (("decimated", decimated), ("subdivided with noise", subdivided)):
        version = change(mesh)
        others = Lines(version, edge / 3, options)
        tolerance = 1.5 * max(edge, mean_edge(version))
        shares = lines.share_near(others, tolerance), others.share_near(lines, tolerance)
        texts.append(f"{name}: {shares[0]:.3f} {shares[1]:.3f} ({others.count} lines)")
    print("; ".join(texts), flush=True)


def crease_points(mesh, least_angle=20.0):
    """Points along the edges at which the surface turns by an angle, and the length of each."""
    points, triangles = arrays_of(mesh)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    sides = np.sort(np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)]), axis=1)
    faces = np.tile(np.arange(len(triangles)), 3)
    order = np.lexsort((sides[:, 1], sides[:, 0]))
    sides, faces = sides[order], faces[order]
    twice = np.flatnonzero((sides[1:] == sides[:-1]).all(axis=1))
    cosines = (normals[faces[twice]] * normals[faces[twice + 1]]).sum(axis=1)
    sharp = sides[twice[cosines < np.cos(np.radians(least_angle))]]
    fractions = (np.arange(6) + 0.5) / 6
    start, end = points[sharp[:, 0]], points[sharp[:, 1]]
    places = start[:, None] + fractions[None, :, None] * (end - start)[:, None]
    lengths = np.linalg.norm(end - start, axis=1)[:, None] / 6
    return places.reshape(-1, 3), np.broadcast_to(lengths, places.shape[:2]).ravel()


def are_near(points, others, tolerance):
    near = np.zeros(len(points), dtype=bool)
    for begin in range(0, len(points) if len(others) else 0, 256):
        chunk = points[begin : begin + 256]
        squares = ((chunk[:, None] - others[None]) ** 2).sum(axis=2).min(axis=1)
        near[begin : begin + 256] = squares <= tolerance**2
    return near


def measure_creases(path, options):
    mesh = read(path)
    edge = mean_edge(mesh)
    size = size_of(mesh)
    places, lengths = crease_points(mesh)
    for noise in (0.0, 0.005, 0.02):
        lines = Lines(add_noise(mesh, noise), edge / 3, options)
        covered = lengths[are_near(places, lines.positions, 1.5 * edge)].sum() / lengths.sum()
        false = lines.lengths[~are_near(lines.positions, places, 1.5 * edge)].sum() / size
        print(
            f"{path}, noise {noise}: {lines.count} lines, covered {covered:.3f}, "
            f"false {false:.2f} D",
            flush=True,
        )


def grid(count, around, function):
    """A mesh over [0, 1) x [0, 1], closed in the first direction if `around`."""
    u, v = np.meshgrid(np.arange(count) / (count - (not around)), np.linspace(0, 1, count))
    ids = np.arange(count * count).reshape(count, count)
    right = np.roll(ids, -1, axis=1)
    columns = slice(None) if around else slice(None, -1)
    a, b = ids[:-1, columns].ravel(), right[:-1, columns].ravel()
    c, d = right[1:, columns].ravel(), ids[1:, columns].ravel()
    triangles = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return make_mesh(function(u.ravel(), v.ravel()), triangles)


def control_surfaces():
    def turned(radius, height):
        return lambda u, v: np.stack(
            [
                radius(v) * np.cos(2 * np.pi * u),
                radius(v) * np.sin(2 * np.pi * u),
                height(v),
            ],
            axis=1,
        )

    sphere = vtkridges.vtkRidgeExampleSource()
    sphere.SetSurfaceToEllipsoid()
    sphere.SetSemiAxes(1.0, 1.0, 1.0)
    sphere.SetFrequency(40)
    sphere.Update()
    yield "sphere", make_mesh(*arrays_of(sphere.GetOutput()))
    yield "plane", grid(120, False, lambda u, v: np.stack([u, v, 0 * u], axis=1))
    yield "cylinder", grid(120, True, turned(lambda v: 1 + 0 * v, lambda v: 6 * v))
    yield "cone", grid(120, True, turned(lambda v: 0.4 + 0.8 * v, lambda v: 5 * v))
    torus = grid(
        120,
        True,
        turned(lambda v: 2 + 0.7 * np.cos(2 * np.pi * v), lambda v: 0.7 * np.sin(2 * np.pi * v)),
    )
    yield "torus", merged(torus)


def controls(options):
    for name, surface in control_surfaces():
        size = size_of(surface)
        texts = []
        for noise in (0.0, 0.05, 0.1, 0.2):
            lines = Lines(add_noise(surface, noise), mean_edge(surface), options)
            texts.append(f"{noise}: {lines.lengths.sum() / size:.2f} D")
        print(f"{name}: " + ", ".join(texts), flush=True)


def main(arguments):
    options = {}
    for argument in arguments:
        if "=" in argument:
            name, value = argument.split("=")
            options[name] = type(getattr(vtkridges.vtkSalientRidges(), "Get" + name)())(float(value))
        elif argument == "controls":
            controls(options)
        elif argument.startswith("creases:"):
            measure_creases(argument[len("creases:") :], options)
        else:
            measure(argument, options)


if __name__ == "__main__":
    main(sys.argv[1:])
