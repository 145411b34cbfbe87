# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""From numpy arrays to numpy arrays: points and triangles in, ridges and curvature out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from . import _filters

__all__ = ["Curvature", "Ridges", "Umbilics", "curvature", "ridges", "salient_ridges", "umbilics"]

Array = npt.NDArray[Any]


@dataclass(frozen=True, eq=False)
class Ridges:
    """Ridges as polylines, each of one type.

    Attributes
    ----------
    points : numpy.ndarray
        Points of all lines, (n, 3).
    lines : list of numpy.ndarray
        For each line, the indices of its points in order.
    type : numpy.ndarray
        For each line: 1 maximum elliptic (blue), 2 maximum hyperbolic (green), 3 minimum elliptic
        (red), 4 minimum hyperbolic (yellow), 0 undecided.
    ridge_id : numpy.ndarray
        The whole ridge that the line is a part of.
    sharpness, strength, length : numpy.ndarray
        Measures of each line; the first two have no unit.
    crest, closed : numpy.ndarray
        Whether the line is a crest line, and whether it is a loop.
    fold_angle : numpy.ndarray or None
        The largest angle by which the surface folds across the line, in degrees, if computed.
    """

    points: Array
    lines: list[Array]
    type: Array
    ridge_id: Array
    sharpness: Array
    strength: Array
    length: Array
    crest: Array
    closed: Array
    fold_angle: Array | None = None

    def __len__(self) -> int:
        return len(self.lines)

    def positions(self, line: int) -> Array:
        """The points of a line in order, (k, 3)."""
        return self.points[self.lines[line]]


@dataclass(frozen=True, eq=False)
class Umbilics:
    """Umbilics, where the two principal curvatures are equal.

    Attributes
    ----------
    points : numpy.ndarray
        Where they are, (n, 3).
    index : numpy.ndarray
        Turns of the principal directions around each: +0.5 or -0.5.
    ridge_count : numpy.ndarray
        Ridges of each colour that end there: 1 or 3.
    """

    points: Array
    index: Array
    ridge_count: Array


@dataclass(frozen=True, eq=False)
class Curvature:
    """Curvature at the points of a mesh; that of a sphere of radius r is -1/r.

    Attributes
    ----------
    maximum, minimum : numpy.ndarray
        The principal curvatures k1 >= k2, (n,).
    maximum_direction, minimum_direction, normals : numpy.ndarray
        A direct orthonormal frame at each point, (n, 3).
    third_order : numpy.ndarray
        The derivatives b0, b1, b2, b3 of the curvatures along the directions, (n, 4).
    status : numpy.ndarray
        0 where the fit is good, else the bits of ``FitStatus``.
    """

    maximum: Array
    minimum: Array
    maximum_direction: Array
    minimum_direction: Array
    normals: Array
    third_order: Array
    status: Array


def _mesh(points: npt.ArrayLike, triangles: npt.ArrayLike) -> vtkPolyData:
    positions = np.ascontiguousarray(points, dtype=float)
    corners = np.asarray(triangles)
    if positions.ndim != 2 or positions.shape[1] != 3:
        raise ValueError(f"points have the shape (n, 3), not {positions.shape}")
    if corners.size == 0:
        corners = corners.reshape(0, 3).astype(np.int64)
    if corners.ndim != 2 or corners.shape[1] != 3:
        raise ValueError(f"triangles have the shape (m, 3), not {corners.shape}")
    if not np.issubdtype(corners.dtype, np.integer):
        raise ValueError(f"triangles are indices of points, not {corners.dtype}")
    if corners.size and not 0 <= corners.min() <= corners.max() < len(positions):
        raise ValueError(
            f"triangles have indices {corners.min()} to {corners.max()}, "
            f"but there are {len(positions)} points"
        )
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(positions, deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(corners.astype(np.int64).ravel(), deep=True))
    mesh = vtkPolyData()
    mesh.SetPoints(vtk_points)
    mesh.SetPolys(cells)
    return mesh


def _array(attributes: Any, name: str, components: int = 1) -> Array:
    data = attributes.GetArray(name)
    if data is None:
        return np.empty((0,) if components == 1 else (0, components))
    return np.asarray(vtk_to_numpy(data))


def _points(data: vtkPolyData) -> Array:
    if data.GetNumberOfPoints() == 0:
        return np.empty((0, 3))
    return np.asarray(vtk_to_numpy(data.GetPoints().GetData()))


def _ridges(data: vtkPolyData) -> Ridges:
    cells = data.GetCellData()
    lines: list[Array] = []
    if data.GetNumberOfLines() > 0:
        ids = vtk_to_numpy(data.GetLines().GetConnectivityArray())
        starts = vtk_to_numpy(data.GetLines().GetOffsetsArray())[1:-1]
        lines = np.split(ids, starts)
    return Ridges(
        points=_points(data),
        lines=lines,
        type=_array(cells, "RidgeType"),
        ridge_id=_array(cells, "RidgeId"),
        sharpness=_array(cells, "Sharpness"),
        strength=_array(cells, "Strength"),
        length=_array(cells, "Length"),
        crest=_array(cells, "Crest").astype(bool),
        closed=_array(cells, "Closed").astype(bool),
        fold_angle=_array(cells, "FoldAngle") if cells.HasArray("FoldAngle") else None,
    )


def ridges(points: npt.ArrayLike, triangles: npt.ArrayLike, **properties: Any) -> Ridges:
    """All ridges of a triangle mesh.

    Parameters
    ----------
    points : array_like
        Points, (n, 3).
    triangles : array_like
        Indices of the corners of the triangles, (m, 3), oriented consistently.
    **properties
        Properties of ``vtkJetFitting``, ``vtkUmbilicDetection``, ``vtkRidgeExtraction`` and
        ``vtkRidgeSharpnessFilter`` in lower case, such as ``minimum_sharpness=10`` or
        ``crest_only=True``.

    Returns
    -------
    Ridges
        The lines, with their types and measures.

    Examples
    --------
    >>> import numpy as np, vtkridges
    >>> x, y = (side.ravel() for side in np.mgrid[-2:2:60j, -2:2:60j])
    >>> points = np.column_stack([x, y, np.sin(2 * x) * np.cos(y)])
    >>> corner = np.add.outer(60 * np.arange(59), np.arange(59)).ravel()
    >>> lower = np.column_stack([corner, corner + 60, corner + 61])
    >>> upper = np.column_stack([corner, corner + 61, corner + 1])
    >>> found = vtkridges.ridges(points, np.vstack([lower, upper]), crest_only=True)
    >>> len(found) > 0, found.positions(0).shape[1]
    (True, 3)
    """
    return _ridges(_filters.extract(_mesh(points, triangles), properties))


def salient_ridges(
    points: npt.ArrayLike,
    triangles: npt.ArrayLike,
    fold_angle: float = 15.0,
    relative_scale: float = 0.01,
    **properties: Any,
) -> Ridges:
    """The few long feature lines of a scan or a part.

    Parameters
    ----------
    points, triangles : array_like
        As for `ridges`.
    fold_angle : float
        Angle in degrees by which the surface folds along every line; more gives fewer lines.
    relative_scale : float
        Size of the smallest features, as a share of the model's diameter.
    **properties
        Other properties of ``vtkSalientRidges`` in lower case, such as ``crest_only=False``.

    Returns
    -------
    Ridges
        Crests (type 3) and valleys (type 1), the most important first.
    """
    properties.update(fold_angle=fold_angle, relative_scale=relative_scale)
    return _ridges(_filters.salient(_mesh(points, triangles), properties))


def umbilics(points: npt.ArrayLike, triangles: npt.ArrayLike, **properties: Any) -> Umbilics:
    """The umbilics of a triangle mesh.

    Parameters
    ----------
    points, triangles : array_like
        As for `ridges`.
    **properties
        Properties of ``vtkJetFitting`` and ``vtkUmbilicDetection`` in lower case.

    Returns
    -------
    Umbilics
        The sum of their indices is the Euler characteristic of a closed mesh.
    """
    data = _filters.umbilics(_mesh(points, triangles), properties)
    attributes = data.GetPointData()
    return Umbilics(
        points=_points(data),
        index=_array(attributes, "Index"),
        ridge_count=_array(attributes, "RidgeCount"),
    )


def curvature(points: npt.ArrayLike, triangles: npt.ArrayLike, **properties: Any) -> Curvature:
    """Principal curvatures, their directions and derivatives at the points of a triangle mesh.

    Parameters
    ----------
    points, triangles : array_like
        As for `ridges`.
    **properties
        Properties of ``vtkJetFitting`` in lower case, such as ``degree=6`` or
        ``standard_errors=True``.

    Returns
    -------
    Curvature
        An array per quantity, in the order of the points.
    """
    attributes = _filters.fit(_mesh(points, triangles), properties).GetPointData()
    return Curvature(
        maximum=_array(attributes, "MaximumCurvature"),
        minimum=_array(attributes, "MinimumCurvature"),
        maximum_direction=_array(attributes, "MaximumDirection", 3),
        minimum_direction=_array(attributes, "MinimumDirection", 3),
        normals=_array(attributes, "Normals", 3),
        third_order=_array(attributes, "ThirdOrder", 4),
        status=_array(attributes, "FitStatus"),
    )
