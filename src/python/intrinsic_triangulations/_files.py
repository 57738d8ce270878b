# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Reads meshes from files, and orients and repairs them.

"""Reads meshes from files, and orients and repairs them."""

from __future__ import annotations

import os
import warnings
from typing import Any, List, NamedTuple, Optional, Tuple, Union

import numpy
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._documented import documented
from ._errors import InvalidSurfaceError, reading
from ._writing import texture_of_obj


@documented
class Repair(NamedTuple):
    """One kind of repair that `repair` or `orient` made."""

    kind: str
    """The kind of repair, as in the command's files: "reversed faces", "opened edges" and so on."""
    count: int
    """The number of faces, vertices or edges affected."""
    first: List[int]
    """The smallest of their input numbers, at most ten; for an edge, the number of its face."""
    message: str
    """A sentence about the first one."""


@documented
class RepairedMesh(NamedTuple):
    """The result of `repair`."""

    V: numpy.ndarray
    """(n, 3) array: the positions of the vertices."""
    F: numpy.ndarray
    """(m, 3) array of int64: the corners of the triangles."""
    vertices: numpy.ndarray
    """(n,) array of int64: the input vertex of each vertex."""
    faces: numpy.ndarray
    """(m,) array of int64: the input face that each triangle is, or is part of."""
    repairs: List[Repair]
    """The repairs; empty if none was necessary."""


@documented
class TexturedMesh(NamedTuple):
    """The result of `read_mesh` with `texture=True`."""

    V: numpy.ndarray
    """(n, 3) array: the positions of the vertices."""
    F: Any
    """(m, 3) array of int64, or list of lists: the corners of the faces."""
    uv: numpy.ndarray
    """(t, 2) array: the texture coordinates."""
    corners: Any
    """As F: the number of the texture coordinates of each corner, or -1 for none. `uv[corners]` has those of all corners."""


def read_mesh(file_name: Union[str, "os.PathLike[str]"], texture: bool = False) -> Any:
    """Read the points and faces of an OFF, OBJ, PLY, STL or TS file, as the command does.

    Nothing is merged, turned over or left out. But STL files have no vertices, so their corners are merged where they
    coincide. Each coordinate becomes the nearest double. O(size of the file).

    Parameters
    ----------
    file_name : str or path
        The extension determines the format.
    texture : bool
        Whether to return a `TexturedMesh`, which has the texture coordinates of an OBJ file, with its seams.

    Returns
    -------
    V : (n, 3) array
        The positions of the vertices.
    F : (m, 3) array of int64, or list of lists
        The corners of the faces: an array if all faces are triangles, otherwise one list per face, for `repair`.

    Raises
    ------
    InvalidFileError
        If the file cannot be read. The message names the line or the element at fault. It is an `InvalidSurfaceError` and
        an `OSError`; if there is no such file, it is a `FileNotFoundError`, too.

    Warns
    -----
    UserWarning
        If the file is readable but unusual, for example if its header has a wrong number of facets.
    """
    path = os.fspath(file_name)
    if texture and not path.lower().endswith(".obj"):
        raise ValueError("file_name has to end with .obj, the format whose texture coordinates are read")
    with reading(path):
        V, corners, first, unusual = _core.read_mesh(path)
    for text in unusual:
        warnings.warn(f"{path}: {text}", stacklevel=2)

    def by_face(numbers: numpy.ndarray) -> Any:
        if len(first) == 0:
            return numbers.reshape(-1, 3)
        return [numbers[begin:end].tolist() for begin, end in zip(first[:-1], first[1:])]

    if not texture:
        return V, by_face(corners)
    uv, numbers = texture_of_obj(path, len(corners))
    return TexturedMesh(V, by_face(corners), uv, by_face(numbers))


def orient(V: ArrayLike, F: ArrayLike) -> Tuple[numpy.ndarray, List[Repair]]:
    """Turn triangles over until any two that share an edge agree.

    The first triangle of each edge-connected part keeps its orientation. At an edge with more than two triangles,
    directions alternate as around a solid. Vertices are not copied, so such edges remain: only `repair` makes a surface
    of them.

    Parameters
    ----------
    V : (n, 3) array of integers or floats
        The positions of the vertices.
    F : (m, 3) array of integers
        The corners of the triangles, counted from 0.

    Returns
    -------
    F : (m, 3) array of int64
        The same triangles, some of them with their corners in reverse order.
    repairs : list of Repair
        One entry, or none if no triangle was turned over.

    Raises
    ------
    InvalidSurfaceError
        If an index is out of range or repeated, a coordinate is not finite, or the surface is one-sided, so that no
        orientation fits. `repair` cuts it open.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> F, repairs = it.orient([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 1]], [[0, 1, 2], [1, 2, 3]])
    >>> F.tolist(), repairs[0].message
    ([[0, 1, 2], [3, 2, 1]], 'face 1 was turned over')
    """
    points, faces = _arrays.finite_points_and_faces(V, F)
    is_bad = (faces[:, 0] == faces[:, 1]) | (faces[:, 1] == faces[:, 2]) | (faces[:, 2] == faces[:, 0])
    if is_bad.any():
        row = int(numpy.argmax(is_bad))
        raise InvalidSurfaceError(f"F[{row}] names a vertex twice; repair(V, F) removes it", "REPEATED_CORNER", row,
                                  int(is_bad.sum()))
    result = faces.astype(numpy.int64)
    turned = _core.turned_faces(points, faces)
    result[turned] = result[turned][:, ::-1]
    _check_orientation(result)
    if len(turned) == 0:
        return result, []
    message = f"face {turned[0]} was turned over"
    if len(turned) > 1:
        message += f", and {len(turned) - 1} more face{'s' if len(turned) > 2 else ''} like it"
    return result, [Repair("reversed faces", len(turned), turned[:10].tolist(), message)]


def _check_orientation(faces: numpy.ndarray) -> None:
    """Raises if the two triangles of an edge traverse it in the same direction."""
    sides = numpy.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    ends = numpy.sort(sides, axis=1)
    edges, number, count = numpy.unique(ends, axis=0, return_inverse=True, return_counts=True)
    forward = numpy.bincount(number.ravel(), weights=(sides[:, 0] < sides[:, 1]), minlength=len(edges))
    is_bad = (count == 2) & (forward != 1)
    if is_bad.any():
        edge = int(numpy.argmax(is_bad))
        face = int(numpy.flatnonzero(number.ravel() == edge)[0] % len(faces))
        raise InvalidSurfaceError(
            f"the surface is one-sided: the triangles at edge {edges[edge][0]}-{edges[edge][1]} of face {face} cannot be turned to "
            "agree; repair(V, F) cuts it open", "INCONSISTENT_ORIENTATION", face, int(is_bad.sum()))


def repair(V: ArrayLike, F: ArrayLike, stitching_tolerance: Optional[float] = None) -> RepairedMesh:
    """Turn any polygons into an oriented triangle mesh by repairing their connectivity.

    This cuts polygons into triangles, closes seams, orients faces, and removes duplicate faces and unused vertices. At
    an edge with more than two faces, those that bound the same piece of a solid stay together, so closed parts stay
    closed. No vertex moves. O(n log n), except for faces with many corners. The command's option ``--repair`` does the
    same. This function is under the GPL, like the parts of CGAL that it uses.

    Parameters
    ----------
    V : (n, 3) array of integers or floats
        The positions of the vertices.
    F : (m, k) array of integers, or sequence of sequences
        The corners of the faces, counted from 0; faces may have any number of corners.
    stitching_tolerance : float, optional
        If it is given, border edges are split at the border vertices that lie within them, exactly or not farther away
        than this length, and border vertices not farther apart are merged.

    Returns
    -------
    RepairedMesh

    Raises
    ------
    InvalidSurfaceError
        If there is no face, an index is out of range, a coordinate is not finite, a face crosses itself, or all faces
        begin with the number of their corners, as VTK has them.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> mesh = it.repair([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2, 3], [0, 1, 4]])
    >>> for r in mesh.repairs:
    ...     print(r.message)
    face 0 (4 corners) was cut into triangles
    face 1 was turned over
    >>> mesh.faces.tolist()
    [0, 0, 1]
    """
    from . import _repair

    tolerance = None if stitching_tolerance is None else _arrays.number(stitching_tolerance, "stitching_tolerance")
    points = _arrays.doubles(V, "V", (None, 3))
    _arrays.refuse_counts(F)
    if isinstance(F, numpy.ndarray):
        array = _arrays.as_array(F, "F", "iu", "integers")
        _arrays.check_shape(array, "F", (None, None))
        lengths = [array.shape[1]] * len(array)
        corners = array.ravel()
    else:
        try:
            polygons = [_arrays.as_array(face, f"F[{i}]", "iu", "integers").ravel() for i, face in enumerate(F)]
        except TypeError:
            raise ValueError("F has to be a sequence of faces") from None
        lengths = [len(face) for face in polygons]
        corners = numpy.concatenate([face.astype(numpy.int64) for face in polygons]) if polygons else numpy.zeros(0, numpy.int64)
    is_bad = (corners < 0) | (corners >= len(points))
    if is_bad.any():
        where = int(numpy.argmax(is_bad))
        row = int(numpy.searchsorted(numpy.cumsum(lengths), where, side="right"))
        raise InvalidSurfaceError(_arrays.bad_index("F", row, "vertex", int(corners[where]), corners, len(points)), "BAD_INDEX", row,
                                  int(is_bad.sum()))
    first = numpy.concatenate([[0], numpy.cumsum(lengths, dtype=numpy.int64)]).tolist()
    V, F, vertices, faces, repairs = _repair.repair(points, corners.astype(numpy.uint32), first, tolerance)
    return RepairedMesh(V, F, vertices, faces, [Repair(*entry) for entry in repairs])
