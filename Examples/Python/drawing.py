# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the examples that draw have in common: ridges in their colours, side by side in a .png.

Drawing needs an X server, maybe a virtual one (xvfb-run -a python3 ...).
"""

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401, what writes text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, what draws
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkGlyph3DMapper,
    vtkLightKit,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)

# Of ridges, by RidgeType: undecided, blue, green, red, yellow.
RIDGES = [(0.35, 0.35, 0.35), (0.0, 0.15, 0.75), (0, 0.55, 0.15), (0.75, 0, 0), (0.95, 0.62, 0)]
LINES = [(0.5, 0.6, 0.95), (0.95, 0.55, 0.5)]  # of curvature lines, by PrincipalDirection
UMBILICS = {0.5: (0.0, 0.0, 0.0), -0.5: (0.75, 0.0, 0.75)}  # by index
GREY = (0.95, 0.95, 0.95)


def lookup(colors):
    """A table of one colour for each of 0, 1, 2, ..."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(len(colors))
    table.SetTableRange(0, len(colors) - 1)
    for i, color in enumerate(colors):
        table.SetTableValue(i, *color)
    return table


class Panel:
    """One of the pictures side by side. Radii are in units of the model."""

    def __init__(self, caption=""):
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(1.0, 1.0, 1.0)
        self.caption = caption

    def add(self, mapper, color=None):
        actor = vtkActor()
        actor.SetMapper(mapper)
        if color:
            mapper.ScalarVisibilityOff()
            actor.GetProperty().SetColor(color)
        actor.GetProperty().SetAmbient(0.3)
        actor.GetProperty().SetDiffuse(0.75)
        self.renderer.AddActor(actor)
        return actor

    def surface(self, port, edges=None, colors=None, array=None):
        """Triangles, on demand with their edges and coloured by a cell array."""
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(port)
        if array:
            self.color_by(mapper, colors, array)
        actor = self.add(mapper, None if array else GREY)
        if edges:
            actor.GetProperty().EdgeVisibilityOn()
            actor.GetProperty().SetEdgeColor(edges)

    def color_by(self, mapper, colors, array):
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray(array)
        mapper.SetLookupTable(lookup(colors))
        mapper.UseLookupTableScalarRangeOn()

    def tubes(self, port, radius, colors, array):
        """Polylines as tubes, coloured by a cell array of small numbers."""
        tube = vtkTubeFilter()
        tube.SetInputConnection(port)
        tube.SetRadius(radius)
        tube.SetNumberOfSides(12)
        tube.CappingOn()
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(tube.GetOutputPort())
        self.color_by(mapper, colors, array)
        self.add(mapper)

    def ridges(self, port, radius):
        self.tubes(port, radius, RIDGES, "RidgeType")

    def lines(self, port, radius):
        self.tubes(port, radius, LINES, "PrincipalDirection")

    def balls(self, port, radius, color):
        """A ball at every point."""
        ball = vtkSphereSource()
        ball.SetRadius(radius)
        ball.SetPhiResolution(24)
        ball.SetThetaResolution(24)
        mapper = vtkGlyph3DMapper()
        mapper.SetInputConnection(port)
        mapper.SetSourceConnection(ball.GetOutputPort())
        mapper.ScalingOff()
        self.add(mapper, color)

    def look(self, center, back, up, height):
        """At a center, from the direction `back`; `height` is what the panel shows of the model."""
        center, back = np.asarray(center, float), np.asarray(back, float)
        camera = self.renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(center)
        camera.SetPosition(center + back / np.linalg.norm(back) * 10.0 * height)
        camera.SetViewUp(up)
        self.renderer.ResetCameraClippingRange()
        camera.SetParallelScale(height / 2.0)


def write(file, panels, width, height):
    """Panels of this size in pixels, side by side, with their captions below."""
    gap, line = 8, 22
    strip = line * max(len(panel.caption.splitlines()) for panel in panels) + 8
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    size = (len(panels) * (width + gap) - gap, height + strip)
    window.SetSize(*size)
    paper = vtkRenderer()
    paper.SetBackground(1.0, 1.0, 1.0)
    window.AddRenderer(paper)
    for i, panel in enumerate(panels):
        left = i * (width + gap)
        panel.renderer.SetViewport(left / size[0], strip / size[1], (left + width) / size[0], 1.0)
        vtkLightKit().AddLightsToRenderer(panel.renderer)
        window.AddRenderer(panel.renderer)
        text = vtkTextActor()
        text.SetInput(panel.caption)
        text.SetPosition(left + width / 2, strip - 4)
        style = text.GetTextProperty()
        style.SetColor(0.1, 0.1, 0.1)
        style.SetFontSize(17)
        style.SetJustificationToCentered()
        style.SetVerticalJustificationToTop()
        paper.AddActor2D(text)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtkPNGWriter()
    writer.SetFileName(file)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
