# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What makes the mesh fails on one rank of a pvserver: an error at the client, and no rank waits."""

import os
import shlex
import tempfile
import threading
import unittest
from pathlib import Path

from paraview import simple
from ridges_paraview import Messages, delete_all, load_plugin
from test_client_and_server import start_server, stop_server

PATIENCE = 30.0  # seconds
SIDE = 16  # points of a row


def numbers(values):
    return " ".join(str(value) for value in values)


def write_rows(path, first, last, points=None):
    """Rows of the graph of a polynomial, and maybe a false number of points."""
    coordinates = []
    for i in range(first - 8, last - 7):
        for j in range(-8, SIDE - 8):
            height = 40 * i * i - 25 * j * j + 2 * i * i * i + i * j * j
            coordinates += [i, j, height / 1000]
    corners = []
    for a in range((last - first) * SIDE):
        if a % SIDE < SIDE - 1:
            b = a + SIDE
            corners += [a, b, b + 1, a, b + 1, a + 1]
    triangles = len(corners) // 3
    path.write_text(
        f"""<VTKFile type="PolyData" version="0.1"><PolyData>
<Piece NumberOfPoints="{points or len(coordinates) // 3}" NumberOfPolys="{triangles}">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
{numbers(coordinates)}</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">
{numbers(corners)}</DataArray><DataArray type="Int64" Name="offsets" format="ascii">
{numbers(range(3, 3 * triangles + 3, 3))}</DataArray></Polys></Piece></PolyData></VTKFile>""",
        encoding="utf-8",
    )


class TestFailingRank(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # The last of the three ranks runs in another folder, where it does not find all files.
        cls._folder = tempfile.TemporaryDirectory()
        cls.folder = Path(cls._folder.name)
        cls.other = cls.folder / "other"
        cls.other.mkdir()
        *launcher, server = shlex.split(os.environ["RIDGES_PVSERVER"])
        # By the shell: mpirun of Open MPI 5 ends at once with folders of its own for some ranks.
        script = 'test "$OMPI_COMM_WORLD_RANK" -lt 2 || cd other; exec "$@"'
        cls.server, port = start_server(
            lambda option: [*launcher, "-wdir", str(cls.folder), "sh", "-c", script, "sh", server, option]
        )
        simple.Connect("127.0.0.1", port)
        load_plugin(remote=True)
        load_plugin(remote=False)

    @classmethod
    def tearDownClass(cls):
        stop_server(cls.server)
        cls._folder.cleanup()

    def setUp(self):
        # If a rank waits for ever, the client does not.
        self._timer = threading.Timer(PATIENCE, self.server.terminate)
        self._timer.start()

    def tearDown(self):
        self._timer.cancel()
        delete_all()

    def expect_error(self, make_reader, text):
        """On two filters, and again when something has changed."""
        for make in (simple.JetFitting, simple.RidgesAndUmbilics):
            reader = make_reader()
            filtered = make(Input=reader)
            for neighborhood in ("Automatic", "Rings"):
                with Messages() as messages:
                    filtered.Neighborhood = neighborhood
                    filtered.UpdatePipeline()
                self.assertIn("The mesh cannot be used: " + text, messages.text)
                self.assertEqual(filtered.GetDataInformation().GetNumberOfPoints(), 0)
            simple.Delete(filtered)
            simple.Delete(reader)

    # The first rank reads all of it.
    def test_a_file_that_is_not_what_it_says(self):
        path = self.folder / "mesh.vtp"
        write_rows(path, 0, 15, points=300)
        self.expect_error(
            lambda: simple.XMLPolyDataReader(FileName=[str(path)]),
            "on rank 0: what makes the piece has failed (Cannot read points array",
        )

    def pieces(self):
        """A mesh in three pieces, which the ranks read, and how to read it."""
        rows = [0, 5, 10, 15]
        for i in range(3):
            write_rows(self.folder / f"{i}.vtp", rows[i], rows[i + 1])
        path = self.folder / "mesh.pvtp"
        path.write_text(
            '<VTKFile type="PPolyData" version="0.1"><PPolyData GhostLevel="0">'
            '<PPoints><PDataArray type="Float64" NumberOfComponents="3"/></PPoints>'
            + "".join(f'<Piece Source="{i}.vtp"/>' for i in range(3))
            + "</PPolyData></VTKFile>",
            encoding="utf-8",
        )
        return lambda: simple.XMLPartitionedPolydataReader(FileName=[str(path)])

    def test_a_missing_piece(self):
        read = self.pieces()
        (self.folder / "2.vtp").unlink()
        self.expect_error(read, "on rank 2: what makes the piece has failed (File for piece 2")

    # Which its reader says at once, and does not run; the others would wait in the filter.
    def test_a_file_that_is_not_on_all_machines(self):
        self.pieces()
        self.expect_error(
            lambda: simple.XMLPartitionedPolydataReader(FileName=["mesh.pvtp"]),
            "on rank 2: what makes the piece has failed (Error opening file mesh.pvtp)",
        )

    def test_no_failure(self):
        with Messages() as messages:
            filtered = simple.JetFitting(Input=self.pieces()())
            filtered.UpdatePipeline()
        self.assertEqual(messages.text, "")
        self.assertEqual(filtered.GetDataInformation().GetNumberOfPoints(), 18 * SIDE)


if __name__ == "__main__":
    unittest.main(verbosity=2)
