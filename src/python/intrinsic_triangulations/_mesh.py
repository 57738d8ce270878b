# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Areas and the cotangent Laplacian of the given triangles.

"""Areas and the cotangent Laplacian of the given triangles."""

from __future__ import annotations

from typing import Any

import numpy
import scipy.sparse
import scipy.sparse.csgraph
from numpy.typing import ArrayLike

from . import _arrays
from ._errors import InvalidSurfaceError
from ._laplacian import _nonnegative


def cotan_laplacian(V: ArrayLike, F: ArrayLike, denom_eps: float = 0.0) -> scipy.sparse.csr_matrix:
    """Return the cotangent Laplacian of the given triangles, without flips, like `potpourri3d.cotan_laplacian`.

    Use it to run existing programs unchanged. Unlike the matrix of `laplacian`, it has positive off-diagonal entries
    wherever the mesh is not Delaunay, and it is useless near triangles of zero area. Entries are rounded. O(size).

    Parameters
    ----------
    V : (n, 3) array of integers or floats
        The positions of the vertices.
    F : (m, 3) array of integers
        The corners of the triangles, counted from 0.
    denom_eps : float
        Added to twice the area of each triangle before dividing by it, in the squared unit of V.

    Returns
    -------
    (n, n) scipy.sparse.csr_matrix
        Symmetric with zero row sums; positive semidefinite up to rounding if denom_eps is 0.

    Raises
    ------
    InvalidSurfaceError
        If an index is out of range, a coordinate is not finite, a triangle has zero area and denom_eps is 0, or a
        number leaves the range of doubles.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> it.cotan_laplacian([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]).toarray()
    array([[ 1. , -0.5, -0.5],
           [-0.5,  0.5,  0. ],
           [-0.5,  0. ,  0.5]])
    """
    epsilon = _nonnegative(denom_eps, "denom_eps")
    points, faces = _arrays.finite_points_and_faces(V, F)
    n = len(points)
    double_areas = _double_areas(points, faces) + epsilon
    _refuse(double_areas == 0, "has no area; laplacian(V, F) takes it, and so does this function with denom_eps", "DEGENERATE_FACE")
    halves = []
    with numpy.errstate(all="ignore"):
        for i in range(3):
            corner = points[faces[:, i]]
            a, b = points[faces[:, (i + 1) % 3]] - corner, points[faces[:, (i + 2) % 3]] - corner
            halves.append(0.5 * (a * b).sum(axis=1) / double_areas)
    _refuse(~numpy.isfinite(halves).all(axis=0), "has a cotangent beyond the range of doubles; laplacian(V, F) takes it", "OUT_OF_RANGE")
    weights = scipy.sparse.coo_matrix((numpy.concatenate(halves), (faces[:, [1, 2, 0]].T.ravel(), faces[:, [2, 0, 1]].T.ravel())), shape=(n, n))
    weights = (weights + weights.T).tocsr()
    return (scipy.sparse.diags(numpy.asarray(weights.sum(axis=1)).ravel()) - weights).tocsr()


def border_edges(V: ArrayLike, F: ArrayLike) -> numpy.ndarray:
    """Return the edges that have one triangle.

    Parameters
    ----------
    V : (n, 3) array of integers or floats
        The positions of the vertices.
    F : (m, 3) array of integers
        The corners of the triangles, counted from 0.

    Returns
    -------
    (k, 2) array of int64
        Their ends, in the direction of the triangle.

    Raises
    ------
    InvalidSurfaceError
        If an index is out of range, or a coordinate is not finite.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> it.border_edges([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]]).tolist()
    [[0, 1], [1, 2], [2, 3], [3, 0]]
    """
    faces = _arrays.finite_points_and_faces(V, F)[1].astype(numpy.int64)
    sides = numpy.stack([faces, faces[:, [1, 2, 0]]], axis=2).reshape(-1, 2)
    number, count = numpy.unique(numpy.sort(sides, axis=1), axis=0, return_inverse=True, return_counts=True)[1:]
    return sides[count[number.ravel()] == 1]


def border_vertices(V: ArrayLike, F: ArrayLike) -> numpy.ndarray:
    """Return the vertices of the `border_edges`, each once.

    Parameters
    ----------
    V, F
        As for `border_edges`.

    Returns
    -------
    (k,) array of int64

    Raises
    ------
    InvalidSurfaceError
        As `border_edges`.
    """
    return numpy.unique(border_edges(V, F))


def component_labels(V: ArrayLike, F: ArrayLike) -> numpy.ndarray:
    """Return which connected component each vertex belongs to.

    Parameters
    ----------
    V, F
        As for `border_edges`.

    Returns
    -------
    (n,) array of int64
        Components are counted from 0, in the order of their first vertices; −1 for a vertex without triangles. The
        component of each triangle is `labels[F[:, 0]]`.

    Raises
    ------
    InvalidSurfaceError
        As `border_edges`.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> it.component_labels([[0, 0, 0]] * 7, [[3, 4, 6], [0, 1, 2]]).tolist()
    [0, 0, 0, 1, 1, -1, 1]
    """
    points, faces = _arrays.finite_points_and_faces(V, F)
    sides = faces[:, [0, 1]], faces[:, [1, 2]]
    joined = scipy.sparse.coo_matrix((numpy.ones(2 * len(faces)), numpy.concatenate(sides).T), shape=(len(points), len(points)))
    labels = scipy.sparse.csgraph.connected_components(joined, directed=False)[1]
    is_used = numpy.zeros(len(points), dtype=bool)
    is_used[faces.ravel()] = True
    result = numpy.full(len(points), -1, dtype=numpy.int64)
    first, number = numpy.unique(labels[is_used], return_index=True, return_inverse=True)[1:]
    result[is_used] = numpy.argsort(numpy.argsort(first))[number.ravel()]
    return result


def face_areas(V: ArrayLike, F: ArrayLike) -> numpy.ndarray:
    """Return the area of each triangle, rounded.

    Parameters
    ----------
    V : (n, 3) array of integers or floats
        The positions of the vertices.
    F : (m, 3) array of integers
        The corners of the triangles, counted from 0.

    Returns
    -------
    (m,) array
        In the squared unit of V.

    Raises
    ------
    InvalidSurfaceError
        If an index is out of range, a coordinate is not finite, or an area leaves the range of doubles.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> it.face_areas([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    array([0.5])
    """
    return _double_areas(*_arrays.finite_points_and_faces(V, F)) / 2


def vertex_areas(V: ArrayLike, F: ArrayLike) -> numpy.ndarray:
    """Return a third of the area of the triangles around each vertex, rounded.

    Parameters
    ----------
    V, F
        As for `face_areas`.

    Returns
    -------
    (n,) array
        In the squared unit of V.

    Raises
    ------
    InvalidSurfaceError
        As `face_areas`.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> it.vertex_areas([[0, 0, 0], [3, 0, 0], [0, 2, 0], [9, 9, 9]], [[0, 1, 2]])
    array([1., 1., 1., 0.])
    """
    points, faces = _arrays.finite_points_and_faces(V, F)
    thirds = _double_areas(points, faces) / 6
    return numpy.bincount(faces.ravel(), numpy.repeat(thirds, 3), len(points)).astype(float)


def _double_areas(points: numpy.ndarray, faces: numpy.ndarray) -> numpy.ndarray:
    with numpy.errstate(all="ignore"):
        a, b = points[faces[:, 1]] - points[faces[:, 0]], points[faces[:, 2]] - points[faces[:, 0]]
        exponents = numpy.frexp(numpy.abs([a, b]).max(axis=2))[1]  # without which squares of areas leave the range first
        a, b = numpy.ldexp([a, b], -exponents[:, :, None])
        result = numpy.ldexp(numpy.linalg.norm(numpy.cross(a, b), axis=1), exponents.sum(axis=0))
    _refuse(~numpy.isfinite(result), "has an area beyond the range of doubles; scale the surface", "OUT_OF_RANGE")
    return result


def _refuse(is_bad: numpy.ndarray, what: str, defect: str) -> None:
    if is_bad.any():
        raise InvalidSurfaceError(f"face {int(is_bad.argmax())} {what}", defect, int(is_bad.argmax()), int(is_bad.sum()))
