# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture that the display defaults give, by the colors of its pixels.

Nothing is compared with a stored picture: processors and renderers differ in single pixels. The
bounds are far from what is drawn and from what a fault leaves, as noted beside them.
"""

import tempfile
import unittest
from pathlib import Path

import numpy as np
from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from ridges_paraview import delete_all, fetch, load_plugin
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkMapper

OTHER, BLUE, GREEN, RED, YELLOW, PURPLE, BLACK, WHITE = range(8)
TYPES = {1: BLUE, 2: GREEN, 3: RED, 4: YELLOW}
HUES = np.array([(0.06, 0.29, 1), (0, 1, 0.27), (1, 0.06, 0.06), (1, 0.65, 0), (1, 0, 1)])


def setUpModule():
    load_plugin()


def color_classes(image):
    """The class of each pixel. Brightness, which shading changes, only separates black and white."""
    brightness = image.max(axis=-1)
    hue = image / np.maximum(brightness, 0.01)[..., np.newaxis]
    distance = np.abs(hue[..., np.newaxis, :] - HUES).max(axis=-1)
    classes = np.where(distance.min(axis=-1) < 0.25, distance.argmin(axis=-1) + BLUE, OTHER)
    classes[brightness < 0.15] = BLACK
    classes[image.min(axis=-1) > 0.98] = WHITE
    return classes


def shot(view):
    """Color classes of the view as it is now, rows from below."""
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "picture.png")
        simple.SaveScreenshot(path, view, TransparentBackground=0)
        reader = vtkPNGReader()
        reader.SetFileName(path)
        reader.Update()
        image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    colors = vtk_to_numpy(image.GetPointData().GetScalars())[:, :3]
    return color_classes(colors.reshape(height, width, 3) / 255.0)


class Scene:
    """The outputs for an example surface, shown by default settings, seen from a corner."""

    def __init__(self, surface):
        self.view = simple.CreateRenderView(ViewSize=[400, 300], OrientationAxesVisibility=0)
        source = simple.RidgeExampleSource(Surface=surface, Frequency=32)
        self.whole = simple.RidgesAndUmbilics(Input=source)
        self.displays = [simple.Show(simple.OutputPort(self.whole, i), self.view) for i in range(3)]
        self.view.CameraPosition = [1.0, -1.0, 0.4]
        self.view.CameraViewUp = [0.0, 0.0, 1.0]
        simple.ResetCamera(self.view)
        simple.Render(self.view)

    def delete(self):
        simple.Delete(self.view)
        delete_all()

    def points_of_type(self, ridge_type):
        lines = fetch(self.whole)
        types = vtk_to_numpy(lines.GetCellData().GetArray("RidgeType"))
        ids = vtk_to_numpy(lines.GetLines().GetConnectivityArray())
        sizes = np.diff(vtk_to_numpy(lines.GetLines().GetOffsetsArray()))
        points = vtk_to_numpy(lines.GetPoints().GetData())
        return points[ids[np.repeat(types, sizes) == ridge_type]]

    def pixels(self, points):
        """Where points come to lie in the picture: row and column of the pixel of each."""
        renderer = self.view.SMProxy.GetRenderer()
        found = []
        for point in points:
            renderer.SetWorldPoint(*point, 1.0)
            renderer.WorldToDisplay()
            x, y, _ = renderer.GetDisplayPoint()
            found.append((int(y), int(x)))
        return np.array(found)


class TestBlend(unittest.TestCase):
    """All four types of ridges, and umbilics of both signs."""

    @classmethod
    def setUpClass(cls):
        cls.scene = Scene("Blend")

    @classmethod
    def tearDownClass(cls):
        cls.scene.delete()

    def test_ridges_have_the_color_of_their_type(self):
        picture = shot(self.scene.view)
        for ridge_type, color in TYPES.items():
            rows, columns = self.scene.pixels(self.scene.points_of_type(ridge_type)).T
            seen = picture[rows, columns]
            # 0.44 to 0.50 is drawn, as the surface hides the rest; of any other color, where ridges
            # cross, 0.11 at most. Two colors exchanged: 0.04 and 0.47.
            self.assertGreater(np.mean(seen == color), 0.35, ridge_type)
            for other in (BLUE, GREEN, RED, YELLOW, PURPLE, BLACK):
                if other != color:
                    self.assertLess(np.mean(seen == other), 0.2, (ridge_type, other))

    def test_umbilics_are_balls_of_both_colors(self):
        picture = shot(self.scene.view)
        # Three black balls and a purple one, 268 and 84 pixels.
        self.assertGreater(np.count_nonzero(picture == BLACK), 200)
        self.assertGreater(np.count_nonzero(picture == PURPLE), 60)

    def test_depth_offsets_do_not_matter(self):
        pictures = []
        before = vtkMapper.GetResolveCoincidentTopology()
        for mode in (0, 1):
            vtkMapper.SetResolveCoincidentTopology(mode)
            pictures.append(shot(self.scene.view))
        vtkMapper.SetResolveCoincidentTopology(before)
        # All pixels are the same. Of lines as tubes and points as spheres, 246 of 4467 differ on a
        # processor without AVX.
        drawn = np.count_nonzero(pictures[0])
        self.assertLess(np.count_nonzero(pictures[0] != pictures[1]), 0.01 * drawn)

    def test_the_legend_names_types_and_indices(self):
        plain = shot(self.scene.view)
        for display in self.scene.displays[:2]:
            display.SetScalarBarVisibility(self.scene.view, True)
        legend = shot(self.scene.view)
        for display in self.scene.displays[:2]:
            display.SetScalarBarVisibility(self.scene.view, False)
        added = np.where(legend != plain, legend, OTHER)
        for color in (BLUE, GREEN, RED, YELLOW, PURPLE, BLACK):
            self.assertGreater(np.count_nonzero(added == color), 100, color)
        self.assertGreater(np.count_nonzero(added == WHITE), 100)  # the text


class TestEllipsoid(unittest.TestCase):
    """A convex surface: what faces the eye is seen, and nothing else."""

    @classmethod
    def setUpClass(cls):
        cls.scene = Scene("Ellipsoid")

    @classmethod
    def tearDownClass(cls):
        cls.scene.delete()

    def facing(self, points):
        """Cosine of the angle between the surface's normal and the way to the eye."""
        mesh = fetch(self.scene.whole, 2)
        positions = vtk_to_numpy(mesh.GetPoints().GetData())
        nearest = [np.argmin(np.sum((positions - point) ** 2, axis=1)) for point in points]
        normals = vtk_to_numpy(mesh.GetPointData().GetArray("Normals"))[nearest]
        to_eye = np.array(self.scene.view.CameraPosition[:]) - points
        if self.scene.view.CameraParallelProjection:
            to_eye[:] = np.subtract(
                self.scene.view.CameraPosition[:], self.scene.view.CameraFocalPoint[:]
            )
        return np.sum(normals * to_eye, axis=1) / np.linalg.norm(to_eye, axis=1)

    def check_lines(self):
        picture = shot(self.scene.view)
        points = np.concatenate([self.scene.points_of_type(ridge_type) for ridge_type in TYPES])
        facing = self.facing(points)
        rows, columns = self.scene.pixels(points).T
        around = np.stack(
            [picture[rows + i, columns + j] != OTHER for i in (-1, 0, 1) for j in (-1, 0, 1)]
        )
        # A line is 4 pixels wide, so that a point's pixel and all around it are colored: 0.99 is
        # drawn, as lines have ends. Lines as tubes on the surface: 0.91.
        self.assertGreater(np.mean(around[:, facing > 0.3]), 0.96)
        # Behind the surface, where other lines cross in front of it: 0.1.
        self.assertLess(np.mean(around[:, facing < -0.3]), 0.2)

    def test_lines_are_drawn_in_full_in_front_and_not_behind(self):
        self.check_lines()

    def test_lines_in_parallel_projection(self):
        self.scene.view.CameraParallelProjection = 1
        self.check_lines()
        self.scene.view.CameraParallelProjection = 0

    def test_balls_are_whole(self):
        points = vtk_to_numpy(fetch(self.scene.whole, 1).GetPoints().GetData())
        ((row, column),) = self.scene.pixels(points[self.facing(points) > 0.3])
        picture = shot(self.scene.view)[row - 8 : row + 9, column - 8 : column + 9]
        # A disc with a diameter of 11 pixels: 85 are drawn.
        black = np.count_nonzero(picture == BLACK)
        self.assertGreater(black, 70)
        self.assertLess(black, 120)


if __name__ == "__main__":
    unittest.main(verbosity=2)
