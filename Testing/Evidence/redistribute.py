# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Deals meshes to ranks and writes the pieces: mpirun pvbatch redistribute.py FILE.vtp...

Those of a.vtp are a/a_0.vtp, and so on.
"""

import sys

from paraview import simple

for path in sys.argv[1:]:
    mesh = simple.XMLPolyDataReader(FileName=[path])
    pieces = simple.ExtractSurface(Input=simple.RedistributeDataSet(Input=mesh))
    simple.SaveData(path[: -len(".vtp")] + ".pvtp", proxy=pieces)
