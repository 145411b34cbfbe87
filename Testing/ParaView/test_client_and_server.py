# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin in a pvserver, of one rank or of several, used by a client."""

import os
import shlex
import socket
import subprocess
import unittest

from paraview import simple
from program import AgainstProgram
from ridges_paraview import load_plugin


def command_of_server(option):
    return [*shlex.split(os.environ["RIDGES_PVSERVER"]), option]


def start_server(command=command_of_server):
    """A pvserver that listens, and its port, which is an option of its command."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    server = subprocess.Popen(
        command(f"--server-port={port}"),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    said = []
    for line in server.stdout:
        said.append(line)
        if line.startswith("Accepting connection"):
            return server, port
    raise RuntimeError("pvserver has not started: " + "".join(said))


def stop_server(server):
    """Leaves the pvserver that this client is connected to, and ends it."""
    simple.Disconnect()
    server.terminate()
    server.wait(timeout=30)
    server.stdout.close()


class TestClientAndServer(AgainstProgram):
    @classmethod
    def setUpClass(cls):
        cls.server, port = start_server()
        simple.Connect("127.0.0.1", port)
        load_plugin(remote=True)
        load_plugin(remote=False)

    @classmethod
    def tearDownClass(cls):
        stop_server(cls.server)

    def test_the_server_is_another_process(self):
        self.assertTrue(simple.GetActiveSource() is None)
        self.assertTrue(simple.servermanager.ActiveConnection.IsRemote())

    def test_the_same_as_the_program(self):
        self.compare(
            ["--minimum-number-of-points", "100", "--minimum-sharpness", "100"],
            Neighborhood="Point Count",
            MinimumNumberOfPoints=100,
            MinimumSharpness=100.0,
        )


del AgainstProgram  # not a test by itself

if __name__ == "__main__":
    unittest.main(verbosity=2)
