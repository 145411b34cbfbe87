# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the ParaView plugin share."""

import os

from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

PLUGIN = os.environ["RIDGES_PLUGIN"]
PROXIES = [
    "JetFitting",
    "UmbilicDetection",
    "RidgeExtraction",
    "RidgeSharpnessFilter",
    "PrincipalFoliation",
    "RidgesAndUmbilics",
    "MongeSmoothing",
    "SalientRidges",
]


def load_plugin(remote=False):
    """Makes the proxies known to paraview.simple, where they are looked up."""
    simple.LoadPlugin(PLUGIN, remote=remote, ns=vars(simple))


def delete_all():
    """Leaves nothing of a test behind."""
    for proxy in reversed(list(simple.GetSources().values())):
        simple.Delete(proxy)


class Messages:
    """Collects what would come up in the output window."""

    def __enter__(self):
        self._before = vtkOutputWindow.GetInstance()
        self._window = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self._window)
        return self

    def __exit__(self, *_):
        vtkOutputWindow.SetInstance(self._before)

    @property
    def text(self):
        return self._window.GetOutput()

    def lines_of(self, class_name):
        """What the filters of this class said, each a line; not what others say about them."""
        return [
            line.split("): ", 1)[1] for line in self.text.splitlines() if line.startswith(class_name)
        ]


def arrays(data):
    """Every array of a vtkPolyData, points and cells included, by a name."""
    found = {"points": vtk_to_numpy(data.GetPoints().GetData())} if data.GetPoints() else {}
    for kind, attributes in (
        ("point ", data.GetPointData()),
        ("cell ", data.GetCellData()),
        ("field ", data.GetFieldData()),
    ):
        for i in range(attributes.GetNumberOfArrays()):
            if attributes.GetArray(i):
                found[kind + attributes.GetArrayName(i)] = vtk_to_numpy(attributes.GetArray(i))
    for name in ("Verts", "Lines", "Polys"):
        cells = getattr(data, "Get" + name)()
        found[name + " offsets"] = vtk_to_numpy(cells.GetOffsetsArray())
        found[name + " connectivity"] = vtk_to_numpy(cells.GetConnectivityArray())
    return found


def fetch(proxy, port=0):
    """An output as it is on the first process, without appending anything to it."""
    return simple.servermanager.Fetch(proxy, 0, None, port)
