# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The program vtkridges, which is built with VTK, as what ParaView is compared with."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np
from paraview import simple
from ridges_paraview import arrays, delete_all, fetch
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

PROGRAM = os.environ.get("RIDGES_PROGRAM", "")
BUNNY = Path(os.environ.get("RIDGES_MESH_DIRECTORY", "")) / "bunny00.off"


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


@unittest.skipUnless(os.path.exists(PROGRAM), "RIDGES_PROGRAM is not there")
@unittest.skipUnless(BUNNY.exists(), "the mesh bunny00.off is not there")
class AgainstProgram(unittest.TestCase):
    """The same mesh, the same properties: the same bytes."""

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = Path(self._folder.name)

    def tearDown(self):
        delete_all()
        self._folder.cleanup()

    def compare(self, options, **properties):
        prefix = self.folder / "bunny"
        subprocess.run(
            [PROGRAM, BUNNY, "--complete", "--no-picture", "--write-mesh", "--quiet"]
            + ["--output", prefix, *options],
            check=True,
        )
        # The mesh carries the results already: they have to be replaced, not passed on.
        mesh = simple.XMLPolyDataReader(FileName=[f"{prefix}-mesh.vtp"])
        mesh.PointArrayStatus = []
        mesh.CellArrayStatus = []
        whole = simple.RidgesAndUmbilics(Input=mesh, **properties)
        for port, name in enumerate(("ridges", "umbilics", "mesh")):
            expected = arrays(read(f"{prefix}-{name}.vtp"))
            found = arrays(fetch(whole, port))
            # Numbers in the whole mesh are said where it may be in pieces.
            found = {key: value for key, value in found.items() if " Gathered" not in key}
            self.assertEqual(set(found), set(expected))
            for key, values in expected.items():
                np.testing.assert_array_equal(found[key], values, err_msg=f"{name}: {key}")
        self.assertGreater(fetch(whole).GetNumberOfLines(), 10)
