# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes vtkFiltersRidges.pyi, the types of the compiled module, by VTK's own script.

    python3 stubs.py PACKAGE_FOLDER

The script names two types that are not defined; here they get the ones that are meant.
"""

import re
import sys
from pathlib import Path

from vtkmodules import generate_pyi


def typed(stub):
    """The text of the stub with properties of the type that their getter returns."""
    classes = re.split(r"(?m)^(?=class )", stub)
    for i, text in enumerate(classes):
        getters = dict(re.findall(r"def Get(\w+)\(self\) -> ([^:]+):", text))
        types = {name.lower(): kind for name, kind in getters.items()}

        def declaration(match, types=types):
            kind = types.get(match[1].replace("_", ""), "Any")
            return f"    {match[1]}:{kind}\n"

        classes[i] = re.sub(r"    (\w+):'getset_descriptor'\n", declaration, text)
    return re.sub(r"'vtkObjectBase'", "vtkmodules.vtkCommonCore.vtkObjectBase", "".join(classes))


folder = Path(sys.argv[1])
generate_pyi.main(["", "-p", "vtkridges", "-o", str(folder), "vtkFiltersRidges"])
file = folder / "vtkFiltersRidges.pyi"
file.write_text(typed(file.read_text()))
