# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ridges of PyVista's meshes: functions, and ``mesh.ridges`` where PyVista has accessors (0.48).

The lines and points that come out carry the colours of their types as active scalars, so that
``plot()`` shows them: `COLORS` for ridges, `INDEX_COLORS` for umbilics.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pyvista

from . import _filters

__all__ = ["COLORS", "INDEX_COLORS", "RidgesAccessor", "extract", "fit", "salient", "umbilics"]

#: Red, green and blue of a ridge, by ``RidgeType``: undecided, blue, green, red, yellow.
COLORS = np.array(
    [[89, 89, 89], [13, 64, 217], [0, 140, 38], [217, 13, 13], [242, 158, 0]], dtype=np.uint8
)
#: Red, green and blue of an umbilic, of index -1/2 and +1/2.
INDEX_COLORS = np.array([[191, 0, 191], [0, 0, 0]], dtype=np.uint8)


def _checked(mesh: pyvista.PolyData) -> pyvista.PolyData:
    if not isinstance(mesh, pyvista.PolyData):
        raise TypeError(
            f"ridges are found on a pyvista.PolyData, not on {type(mesh).__name__}: "
            "extract_surface() makes one"
        )
    return mesh


def _lines(data: Any) -> pyvista.PolyData:
    lines = pyvista.wrap(data)
    if lines.n_cells:
        # PyVista takes arrays of this ending for colours.
        lines.cell_data["RidgeType_rgb"] = COLORS[lines.cell_data["RidgeType"]]
        lines.set_active_scalars("RidgeType_rgb", preference="cell")
    return lines


def salient(
    mesh: pyvista.PolyData,
    fold_angle: float = 15.0,
    relative_scale: float = 0.01,
    **properties: Any,
) -> pyvista.PolyData:
    """The few long feature lines of a scan or a part.

    Parameters
    ----------
    mesh : pyvista.PolyData
        A triangle mesh, oriented consistently.
    fold_angle : float
        Angle in degrees by which the surface folds along every line; more gives fewer lines.
    relative_scale : float
        Size of the smallest features, as a share of the model's diameter.
    **properties
        Other properties of ``vtkSalientRidges`` in lower case, such as ``crest_only=False``.

    Returns
    -------
    pyvista.PolyData
        Polylines, the most important first: red crests and blue valleys.

    Examples
    --------
    >>> import pyvista
    >>> import vtkridges.pyvista
    >>> mesh = pyvista.Icosphere(nsub=5).scale([3.0, 2.0, 1.0], inplace=False)
    >>> lines = vtkridges.pyvista.salient(mesh)
    >>> sorted(set(lines["RidgeType"].tolist()))
    [3]
    """
    properties.update(fold_angle=fold_angle, relative_scale=relative_scale)
    return _lines(_filters.salient(_checked(mesh), properties))


def extract(mesh: pyvista.PolyData, **properties: Any) -> pyvista.PolyData:
    """All ridges of a mesh, from umbilic to umbilic.

    Parameters
    ----------
    mesh : pyvista.PolyData
        A triangle mesh, oriented consistently. If it comes from `fit`, that fit is used.
    **properties
        Properties of ``vtkJetFitting``, ``vtkUmbilicDetection``, ``vtkRidgeExtraction`` and
        ``vtkRidgeSharpnessFilter`` in lower case, such as ``minimum_sharpness=10`` or
        ``crest_only=True``.

    Returns
    -------
    pyvista.PolyData
        Polylines, each of one type: blue, green, red or yellow.

    Examples
    --------
    >>> import pyvista
    >>> import vtkridges.pyvista
    >>> mesh = pyvista.Icosphere(nsub=5).scale([3.0, 2.0, 1.0], inplace=False)
    >>> lines = vtkridges.pyvista.extract(mesh, minimum_sharpness=1.0)
    >>> lines["RidgeType_rgb"].shape == (lines.n_cells, 3)
    True
    """
    return _lines(_filters.extract(_checked(mesh), properties))


def fit(mesh: pyvista.PolyData, **properties: Any) -> pyvista.PolyData:
    """The mesh with curvatures, directions and their derivatives.

    Parameters
    ----------
    mesh : pyvista.PolyData
        A triangle mesh, oriented consistently.
    **properties
        Properties of ``vtkJetFitting`` in lower case, such as ``degree=6`` or
        ``standard_errors=True``.

    Returns
    -------
    pyvista.PolyData
        The mesh with the point arrays ``MaximumCurvature``, ``MinimumCurvature`` and others.

    Examples
    --------
    >>> import pyvista
    >>> import vtkridges.pyvista
    >>> mesh = vtkridges.pyvista.fit(pyvista.Icosphere(radius=2.0, nsub=4))
    >>> float(mesh["MaximumCurvature"].mean().round(3))
    -0.5
    """
    return pyvista.wrap(_filters.fit(_checked(mesh), properties))


def umbilics(mesh: pyvista.PolyData, **properties: Any) -> pyvista.PolyData:
    """The umbilics of a mesh, where the principal curvatures are equal.

    Parameters
    ----------
    mesh : pyvista.PolyData
        A triangle mesh, oriented consistently. If it comes from `fit`, that fit is used.
    **properties
        Properties of ``vtkJetFitting`` and ``vtkUmbilicDetection`` in lower case.

    Returns
    -------
    pyvista.PolyData
        A vertex per umbilic: black where the ``Index`` is +1/2, purple where it is -1/2.

    Examples
    --------
    >>> import pyvista
    >>> import vtkridges.pyvista
    >>> mesh = pyvista.Icosphere(nsub=5).scale([3.0, 2.0, 1.0], inplace=False)
    >>> vtkridges.pyvista.umbilics(mesh)["Index"].tolist()
    [0.5, 0.5, 0.5, 0.5]
    """
    points = pyvista.wrap(_filters.umbilics(_checked(mesh), properties))
    if points.n_points:
        points.point_data["Index_rgb"] = INDEX_COLORS[(points.point_data["Index"] > 0).astype(int)]
        points.set_active_scalars("Index_rgb", preference="point")
    return points


class RidgesAccessor:
    """What ``mesh.ridges`` is: the functions of this module as methods of a mesh.

    Parameters
    ----------
    mesh : pyvista.PolyData
        The mesh that the methods are about.
    """

    def __init__(self, mesh: pyvista.PolyData) -> None:
        self._mesh = mesh

    def salient(
        self, fold_angle: float = 15.0, relative_scale: float = 0.01, **properties: Any
    ) -> pyvista.PolyData:
        """The few long feature lines: see `vtkridges.pyvista.salient`."""
        return salient(self._mesh, fold_angle, relative_scale, **properties)

    def extract(self, **properties: Any) -> pyvista.PolyData:
        """All ridges: see `vtkridges.pyvista.extract`."""
        return extract(self._mesh, **properties)

    def fit(self, **properties: Any) -> pyvista.PolyData:
        """The mesh with its curvatures: see `vtkridges.pyvista.fit`."""
        return fit(self._mesh, **properties)

    def umbilics(self, **properties: Any) -> pyvista.PolyData:
        """The umbilics: see `vtkridges.pyvista.umbilics`."""
        return umbilics(self._mesh, **properties)


if hasattr(pyvista, "register_dataset_accessor"):
    pyvista.register_dataset_accessor("ridges", pyvista.PolyData)(RidgesAccessor)
