# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Filters for a mesh whose pieces are on several ranks of MPI: ``mpirun -np 4 python3 script.py``.

They need VTK with MPI, and mpi4py. In a script that ParaView or pvtkpython runs, the ranks are known already, and `use_mpi` is not
needed.
"""

from __future__ import annotations

from . import vtkFiltersRidges  # noqa: F401  the superclasses
from .vtkFiltersParallelRidges import vtkPJetFitting, vtkPRidgesAndUmbilics

__all__ = ["use_mpi", "vtkPJetFitting", "vtkPRidgesAndUmbilics"]


def use_mpi(communicator=None):
    """Makes the ranks of an mpi4py communicator, all by default, those of VTK's filters.

    Call it before filters are made. Returns the vtkMPIController.
    """
    from mpi4py import MPI
    from vtkmodules.vtkParallelCore import vtkMultiProcessController
    from vtkmodules.vtkParallelMPI import vtkMPIController
    from vtkmodules.vtkParallelMPI4Py import vtkMPI4PyCommunicator

    controller = vtkMPIController()
    ranks = MPI.COMM_WORLD if communicator is None else communicator
    controller.SetCommunicator(vtkMPI4PyCommunicator.ConvertToVTK(ranks))
    vtkMultiProcessController.SetGlobalController(controller)
    return controller
