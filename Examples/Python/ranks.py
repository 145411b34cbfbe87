# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ridges of a large mesh on several ranks: mpirun -np 4 python3 ranks.py [mesh.pvtp | .vtp]

Writes ridges.vtp and umbilics.vtp. Each rank reads its pieces of a .pvtp; a .vtp is read by the first rank. Without a mesh it takes
the example surface of RR-5294, Fig. 25, all of it on the first rank.
"""

import sys

from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkStaticCleanPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter, vtkXMLPPolyDataReader

import vtkridges
from vtkridges.parallel import use_mpi, vtkPRidgesAndUmbilics

controller = use_mpi()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()

merged = vtkStaticCleanPolyData()  # where a rank reads several pieces, their points are not
filter = vtkPRidgesAndUmbilics()
filter.SetMinimumSharpness(10.0)
filter.SetInputConnection(merged.GetOutputPort())
if len(sys.argv) > 1 and sys.argv[1].endswith(".pvtp"):
    reader = vtkXMLPPolyDataReader()
    reader.SetFileName(sys.argv[1])
    merged.SetInputConnection(reader.GetOutputPort())
elif rank > 0:
    merged.SetInputData(vtkPolyData())
else:
    source = vtkXMLPolyDataReader() if len(sys.argv) > 1 else vtkridges.vtkRidgeExampleSource()
    if len(sys.argv) > 1:
        source.SetFileName(sys.argv[1])
    merged.SetInputConnection(source.GetOutputPort())
filter.UpdatePiece(rank, ranks, 0)

if rank == 0:  # which has all lines and umbilics
    for port, name in enumerate(["ridges.vtp", "umbilics.vtp"]):
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(name)
        writer.SetInputData(filter.GetOutputDataObject(port))
        if not writer.Write():
            sys.exit(f"cannot write {name}")
    print(filter.GetOutput(1).GetNumberOfPoints(), "umbilics")
    print(filter.GetOutput().GetNumberOfLines(), "polylines")
