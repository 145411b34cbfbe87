# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the Python of the README and of the pages, beside a file bunny.ply that is an ellipsoid."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOPLY import vtkPLYWriter

import vtkridges

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "Filters" / "Documentation").glob("*.md"))]
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


if __name__ == "__main__":
    unittest.main()
