# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the Python and the commands of the README and of the pages, beside a file bunny.ply that is an
ellipsoid and an image head.vti with another one."""

import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonDataModel import vtkQuadric
from vtkmodules.vtkImagingHybrid import vtkSampleFunction
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

import vtkridges

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "Filters" / "Documentation").glob("*.md"))]
PROGRAM = os.environ.get("RIDGES_PROGRAM") or shutil.which("vtkridges")
VERSION = (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion())

try:
    import pyvista
except ImportError:
    pyvista = None


def missing(code):
    """What a piece of code needs and is not here, or nothing."""
    if "pyvista" in code and not pyvista:
        return "PyVista"
    if ".ridges." in code and not hasattr(pyvista, "register_dataset_accessor"):
        return "PyVista 0.48"
    if "Plotter" in code and not os.environ.get("DISPLAY"):
        return "a display"
    if ">>" in code and VERSION < (9, 4):
        return "VTK 9.4"
    return None


class TestPages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        source = vtkridges.vtkRidgeExampleSource()
        source.SetSurfaceToEllipsoid()
        source.SetFrequency(16)
        writer = vtkPLYWriter()
        writer.SetFileName(str(Path(cls.folder.name, "bunny.ply")))
        writer.SetInputConnection(source.GetOutputPort())
        writer.Write()
        ellipsoid = vtkQuadric()  # 1000 at the centre, 500 on the surface
        ellipsoid.SetCoefficients(-0.5, -0.8, -1.3, 0, 0, 0, 0, 0, 0, 1000)
        image = vtkSampleFunction()
        image.SetImplicitFunction(ellipsoid)
        image.SetModelBounds(-40, 40, -32, 32, -26, 26)
        image.SetSampleDimensions(41, 33, 27)
        image.ComputeNormalsOff()
        writer = vtkXMLImageDataWriter()
        writer.SetFileName(str(Path(cls.folder.name, "head.vti")))
        writer.SetInputConnection(image.GetOutputPort())
        writer.Write()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_code_runs(self):
        count = 0
        for page in PAGES:
            for code in re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.S):
                count += 1
                if missing(code):
                    continue
                with self.subTest(page=page.name, code=code):
                    run = subprocess.run(
                        [sys.executable, "-B", "-W", "ignore", "-c", code],
                        cwd=self.folder.name,
                        env={**os.environ, "PYVISTA_OFF_SCREEN": "true"},
                        capture_output=True,
                        text=True,
                    )
                    self.assertEqual(run.returncode, 0, run.stderr)
                    self.assertNotIn("ERR|", run.stderr)  # of a filter
        self.assertGreaterEqual(count, 7)

    @unittest.skipUnless(PROGRAM, "the program is not here")
    def test_commands_run(self):
        count = 0
        for page in PAGES:
            text = page.read_text(encoding="utf-8")
            for command in re.findall(r"^    vtkridges (.*)$", text, re.M):
                if "..." in command:
                    continue
                count += 1
                with self.subTest(page=page.name, command=command):
                    run = subprocess.run(
                        [PROGRAM, "--no-picture", *shlex.split(command, comments=True)],
                        cwd=self.folder.name,
                        capture_output=True,
                        text=True,
                    )
                    self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertGreaterEqual(count, 3)


if __name__ == "__main__":
    unittest.main()
