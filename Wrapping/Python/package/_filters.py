# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Filters run from Python: properties by keyword, errors as exceptions."""

from __future__ import annotations

import re
import sys
import warnings
from typing import Any, Sequence

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING

from .vtkFiltersRidges import (
    vtkJetFitting,
    vtkRidgeExtraction,
    vtkRidgeSharpnessFilter,
    vtkSalientRidges,
    vtkUmbilicDetection,
)

# What a fit leaves on the mesh: umbilics and ridges start from it.
FITTED = "ThirdOrder"


def camel(name: str) -> str:
    """``"fold_angle"`` or ``"fold angle"`` as VTK writes it: ``"FoldAngle"``."""
    return "".join(word[:1].upper() + word[1:] for word in re.split(r"[_\s]+", name))


def property_names(stage: Any) -> list[str]:
    """The properties of a filter of this package, as keywords."""
    own = [name[3:] for name in vars(type(stage)) if name.startswith("Set")]
    names = {name for name in own if hasattr(stage, "Get" + name)}
    return sorted(re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower() for name in names)


def set_property(stage: Any, keyword: str, value: Any) -> None:
    """Sets a property; text names the value of an enumeration."""
    name = camel(keyword)
    if not isinstance(value, str):
        getattr(stage, "Set" + name)(value)
        return
    choice = getattr(stage, f"Set{name}To{camel(value)}", None)
    if choice is None:
        start = f"Set{name}To"
        choices = [each[len(start) :] for each in dir(stage) if each.startswith(start)]
        raise ValueError(f"{keyword}={value!r}: there are {', '.join(choices) or 'numbers only'}")
    choice()


def configure(stages: Sequence[Any], properties: dict[str, Any]) -> None:
    """Sets each property on the last of the stages that has it."""
    for keyword, value in properties.items():
        owners = [stage for stage in stages if keyword in property_names(stage)]
        if not owners:
            known = sorted({name for stage in stages for name in property_names(stage)})
            raise TypeError(f"unknown property {keyword!r}; there are {', '.join(known)}")
        set_property(owners[-1], keyword, value)


def run(mesh: Any, stages: Sequence[Any]) -> None:
    """Chains the stages behind the mesh and updates the last one.

    Raises RuntimeError with the text of the first error. Warnings become Python's.
    """
    errors: list[str] = []
    notes: list[str] = []

    def listen(into: list[str]) -> Any:
        @calldata_type(VTK_STRING)
        def observer(_caller: Any, _event: str, text: str) -> None:
            # "ERROR: In file.cxx, line 1", then on the next line "vtkClass (0x1234): message".
            into.append(" ".join(re.sub(r"^.*?\(0x[0-9a-f]+\):", "", text, flags=re.S).split()))

        return observer

    stages[0].SetInputData(mesh)
    for stage, following in zip(stages, stages[1:]):
        following.SetInputConnection(stage.GetOutputPort())
    watched = [(stage, errors) for stage in stages]
    watched += [(stage.GetExecutive(), []) for stage in stages]  # they repeat that there was one
    tags = []
    for source, into in watched:
        tags.append((source, source.AddObserver("ErrorEvent", listen(into))))
        tags.append((source, source.AddObserver("WarningEvent", listen(notes))))
    stages[-1].Update()
    for source, tag in tags:
        source.RemoveObserver(tag)
    if errors:
        raise RuntimeError(errors[0])
    for note in notes:
        warnings.warn(note, RuntimeWarning, stacklevel=_depth())


def _depth() -> int:
    """The stack level, seen from the caller, of the line outside of this package."""
    frame, depth = sys._getframe(1), 1
    while frame.f_back and frame.f_globals.get("__name__", "").startswith(__package__ + "."):
        frame, depth = frame.f_back, depth + 1
    return depth


def _fit_stages(mesh: Any) -> list[Any]:
    return [] if mesh.GetPointData().HasArray(FITTED) else [vtkJetFitting()]


def fit(mesh: Any, properties: dict[str, Any]) -> Any:
    """The mesh with the arrays of vtkJetFitting."""
    stages = [vtkJetFitting()]
    configure(stages, properties)
    run(mesh, stages)
    return stages[-1].GetOutput()


def umbilics(mesh: Any, properties: dict[str, Any]) -> Any:
    """A vertex per umbilic, of a mesh that has been fitted or will be."""
    stages = [*_fit_stages(mesh), vtkUmbilicDetection()]
    configure(stages, properties)
    run(mesh, stages)
    return stages[-1].GetOutput(1)


def extract(mesh: Any, properties: dict[str, Any]) -> Any:
    """The ridges of a mesh that has been fitted or will be."""
    stages = [
        *_fit_stages(mesh),
        vtkUmbilicDetection(),
        vtkRidgeExtraction(),
        vtkRidgeSharpnessFilter(),
    ]
    configure(stages, properties)
    run(mesh, stages)
    return stages[-1].GetOutput()


def salient(mesh: Any, properties: dict[str, Any]) -> Any:
    """The feature lines of a mesh."""
    stages = [vtkSalientRidges()]
    configure(stages, properties)
    run(mesh, stages)
    return stages[-1].GetOutput()
