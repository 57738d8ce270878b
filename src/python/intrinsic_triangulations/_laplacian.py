# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Laplace-Beltrami operators of any triangles and of points.

"""Laplace-Beltrami operators of any triangles and of points."""

from __future__ import annotations

import math
from typing import Any, Tuple

import numpy
import scipy.sparse
from numpy.typing import ArrayLike

from . import _arrays, _core


def laplacian(V: ArrayLike, F: ArrayLike, mass: str = "lumped") -> Tuple[scipy.sparse.csc_matrix, scipy.sparse.csc_matrix]:
    """The Laplace-Beltrami operator of any triangles.

    It is that of the intrinsic Delaunay triangulation of the tufted cover: the triangles may be non-manifold, not orientable,
    thin, without area, or given twice, and may have a border. There is no tolerance, and no length is changed.

    Parameters
    ----------
    V : (n, 3) array of integers or floats
        The positions of the vertices.
    F : (m, 3) array of integers
        The corners of the triangles, counted from 0.
    mass : {"lumped", "galerkin"}
        Which mass matrix is returned: a third of the area around each vertex, or that of linear finite elements.

    Returns
    -------
    L : (n, n) scipy.sparse.csc_matrix
        The stiffness matrix, without unit: symmetric, positive semidefinite, with zero row sums; no entry off the diagonal is
        positive. `u @ L @ u` is the integral of the squared gradient of u. (The sign is that of `robust_laplacian`, and opposite to
        that of libigl's `cotmatrix`.)
    M : (n, n) scipy.sparse.csc_matrix
        The mass matrix, in the squared unit of V. `L u = λ M u` is the eigenvalue problem of −Δ.

    Raises
    ------
    InvalidSurfaceError
        If there is no face, an index is out of range, or a coordinate is not finite.

    Notes
    -----
    A vertex without faces has a row of zeros in both matrices. Of vertices joined by an edge of length zero, the first stands for
    all, and the others have rows of zeros.

    Source: N. Sharp, K. Crane, "A Laplacian for nonmanifold triangle meshes", 2020.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> L, M = it.laplacian([[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, -1, 0]], [[0, 1, 2], [1, 0, 3]])
    >>> L.shape, round(float(M.sum()), 6)
    ((4, 4), 4.0)
    """
    is_lumped = _arrays.choice(mass, "mass", ("lumped", "galerkin")) == 0
    points, faces = _arrays.points_and_faces(V, F)
    L, M = _core.laplacian(points, faces, 0.0, is_lumped)
    return _arrays.sparse(L), _arrays.sparse(M)


def mesh_laplacian(verts: ArrayLike, faces: ArrayLike,
                   mollify_factor: float = 1e-5) -> Tuple[scipy.sparse.csc_matrix, scipy.sparse.csc_matrix]:
    """As `robust_laplacian.mesh_laplacian`: the operator of any triangles, for programs that are to run unchanged.

    Parameters
    ----------
    verts : (n, 3) array of integers or floats
        The positions of the vertices.
    faces : (m, 3) array of integers
        The corners of the triangles.
    mollify_factor : float
        Edges are lengthened by the same length, as far as needed, until each two sides of a triangle exceed the third by this
        factor of the mean length. 0 leaves all lengths as they are, which this library does not need: see `laplacian`.

    Returns
    -------
    L, M : (n, n) scipy.sparse.csc_matrix
        As those of `laplacian`, with lumped mass. The rows of vertices without faces have 1 on the diagonal of L, and a
        thousandth of the smallest mass in M, so that both can be factorized.
    """
    factor = _nonnegative(mollify_factor, "mollify_factor")
    points, triangles = _arrays.points_and_faces(verts, faces)
    L, M = _core.laplacian(points, triangles, factor, True)
    return _with_unused_vertices(_arrays.sparse(L), _arrays.sparse(M))


def point_cloud_laplacian(points: ArrayLike, mollify_factor: float = 1e-5,
                          n_neighbors: int = 30) -> Tuple[scipy.sparse.csc_matrix, scipy.sparse.csc_matrix]:
    """As `robust_laplacian.point_cloud_laplacian`: the operator of points near an unknown surface.

    This function is under the GPL, as the parts of CGAL that it uses; the rest of the package is under the LGPL.

    Parameters
    ----------
    points : (n, 3) array of integers or floats
        The points. Of several at the same place the first stands for all.
    mollify_factor : float
        It is checked, and changes nothing: the triangles around a point need no mollification here.
    n_neighbors : int
        How many of the nearest points are taken for a tangent plane, at least 2.

    Returns
    -------
    L, M : (n, n) scipy.sparse.csc_matrix
        As those of `mesh_laplacian`.
    """
    from . import _point_cloud

    _nonnegative(mollify_factor, "mollify_factor")
    neighbors = _arrays.integer(n_neighbors, "n_neighbors", 2, 2**31)
    L, M = _point_cloud.laplacian(_arrays.doubles(points, "points", (None, 3)), neighbors)
    return _with_unused_vertices(_arrays.sparse(L), _arrays.sparse(M))


def _nonnegative(value: Any, name: str) -> float:
    result = _arrays.number(value, name)
    if not (result >= 0 and math.isfinite(result)):
        raise ValueError(f"{name} has to be finite and not negative, not {value!r}")
    return result


def _with_unused_vertices(L: scipy.sparse.csc_matrix,
                          M: scipy.sparse.csc_matrix) -> Tuple[scipy.sparse.csc_matrix, scipy.sparse.csc_matrix]:
    mass = M.diagonal()
    is_unused = mass == 0
    if is_unused.any():
        L = (L + scipy.sparse.diags(is_unused.astype(float))).tocsc()
        smallest = mass[~is_unused].min() if not is_unused.all() else 1.0
        M = scipy.sparse.diags(numpy.where(is_unused, 1e-3 * smallest, mass)).tocsc()
    return L, M
