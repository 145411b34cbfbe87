# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Importing the package beside the right VTK, a wrong one, or none."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkVersion

FAKE = """
class vtkVersion:
    @staticmethod
    def GetVTKVersion():
        return "{version}"
"""


def import_beside(version):
    """Imports vtkridges in a process whose vtkmodules are fake and only know their version."""
    with tempfile.TemporaryDirectory() as folder:
        package = Path(folder, "vtkmodules")
        package.mkdir()
        Path(package, "__init__.py").touch()
        Path(package, "vtkCommonCore.py").write_text(FAKE.format(version=version))
        paths = [folder, *filter(None, [os.environ.get("PYTHONPATH")])]
        return subprocess.run(
            [sys.executable, "-B", "-c", "import vtkridges"],
            env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)},
            capture_output=True,
            text=True,
        )


class TestImport(unittest.TestCase):
    def test_another_vtk_is_an_import_error_that_names_both(self):
        own = vtkVersion.GetVTKVersion()
        for other in ("9.0.3", "9.2.20230111", "19.1.0", own.rsplit(".", 1)[0] + ".20240101"):
            with self.subTest(other):
                process = import_beside(other)
                self.assertEqual(process.returncode, 1, process.stderr)
                self.assertIn("ImportError: vtkridges was built with VTK " + own, process.stderr)
                self.assertIn("VTK " + other, process.stderr)
                self.assertIn("vtkCommonCore.py", process.stderr)

    def test_a_patch_release_of_the_same_vtk_is_accepted(self):
        # The fake modules have no classes: the compiled one is loaded, and fails for want of them
        # or succeeds, but no version is complained about.
        process = import_beside(vtkVersion.GetVTKVersion().rsplit(".", 1)[0] + ".99")
        self.assertNotIn("was built with", process.stderr)

    def test_all_classes_are_exported(self):
        import vtkridges

        self.assertIn("vtkJetFitting", vtkridges.__all__)
        self.assertTrue(all(hasattr(vtkridges, name) for name in vtkridges.__all__))
        self.assertTrue(vtkridges.__version__)


if __name__ == "__main__":
    unittest.main()
