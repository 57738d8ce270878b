# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Laplace-Beltrami operators of arbitrary triangles and of points.

"""Laplace-Beltrami operators of arbitrary triangles and of points."""

from __future__ import annotations

import math
from typing import Any, Literal, Tuple

import numpy
import scipy.sparse
import scipy.sparse.csgraph
import scipy.sparse.linalg
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._errors import NumericalError

Mass = Literal["lumped", "galerkin"]


def laplacian(V: ArrayLike, F: ArrayLike, mass: Mass = "lumped") -> Tuple[scipy.sparse.csc_matrix, scipy.sparse.csc_matrix]:
    """Return the Laplace-Beltrami operator of arbitrary triangles.

    It belongs to the intrinsic Delaunay triangulation of the tufted cover. The triangles may be non-manifold, not
    orientable, thin, of zero area or duplicated, and may have a border. There is no tolerance, and no length changes.
    All decisions are exact, so the signs are too; entries are rounded.

    Parameters
    ----------
    V : (n, 3) array of integers or floats
        The positions of the vertices.
    F : (m, 3) array of integers
        The corners of the triangles, counted from 0.
    mass : {"lumped", "galerkin"}
        The mass matrix: a third of the area around each vertex, or the matrix of linear finite elements.

    Returns
    -------
    L : (n, n) scipy.sparse.csc_matrix
        The stiffness matrix, without unit: symmetric, positive semidefinite, with zero row sums and no positive
        off-diagonal entry. `u @ L @ u` is the integral of the squared gradient of u. (`robust_laplacian` has the same
        sign, libigl's `cotmatrix` the opposite one.)
    M : (n, n) scipy.sparse.csc_matrix
        The mass matrix, in the squared unit of V. `L u = λ M u` is the eigenvalue problem of −Δ.

    Raises
    ------
    InvalidSurfaceError
        If there is no face, an index is out of range, or a coordinate is not finite.

    Notes
    -----
    Vertices that lie within border edges, or much nearer to each other than to others, cause a warning with the
    tolerance by which `repair` joins them.

    A vertex without faces has a row of zeros in both matrices. The first of several vertices joined by edges of length
    zero represents all of them; the others have rows of zeros.

    Source: N. Sharp, K. Crane, "A Laplacian for nonmanifold triangle meshes", 2020.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> L, M = it.laplacian([[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, -1, 0]], [[0, 1, 2], [1, 0, 3]])
    >>> L.shape, round(float(M.sum()), 6)
    ((4, 4), 4.0)
    """
    is_lumped = _arrays.choice(mass, "mass", Mass) == 0
    points, faces = _arrays.points_and_faces(V, F)
    _arrays.warn_of_gaps(points, faces)
    L, M = _core.laplacian(points, faces, 0.0, is_lumped)
    return _arrays.sparse(L), _arrays.sparse(M)


def mesh_laplacian(verts: ArrayLike, faces: ArrayLike,
                   mollify_factor: float = 1e-5) -> Tuple[scipy.sparse.csc_matrix, scipy.sparse.csc_matrix]:
    """Return the operator of arbitrary triangles with the parameters of `robust_laplacian.mesh_laplacian`.

    Parameters
    ----------
    verts : (n, 3) array of integers or floats
        The positions of the vertices.
    faces : (m, 3) array of integers
        The corners of the triangles.
    mollify_factor : float
        All edges are lengthened by the same amount, the smallest for which any two sides of a triangle exceed the third
        by this factor times the mean length. 0 changes no length; this library does not need mollification.

    Returns
    -------
    L, M : (n, n) scipy.sparse.csc_matrix
        As from `laplacian`, with lumped mass. Vertices without faces have 1 on the diagonal of L and a thousandth of
        the smallest mass on that of M, so that both matrices can be factorized.

    Raises
    ------
    InvalidSurfaceError
        As `laplacian`.
    """
    factor = _nonnegative(mollify_factor, "mollify_factor")
    points, triangles = _arrays.points_and_faces(verts, faces)
    L, M = _core.laplacian(points, triangles, factor, True)
    return _with_unused_vertices(_arrays.sparse(L), _arrays.sparse(M))


def point_cloud_laplacian(points: ArrayLike, mollify_factor: float = 1e-5,
                          n_neighbors: int = 30) -> Tuple[scipy.sparse.csc_matrix, scipy.sparse.csc_matrix]:
    """Return the operator of points near an unknown surface, like `robust_laplacian.point_cloud_laplacian`.

    O(n log n) in practice. This function is under the GPL, like the parts of CGAL that it uses.

    Parameters
    ----------
    points : (n, 3) array of integers or floats
        The points. The first of several at the same place represents all of them.
    mollify_factor : float
        Checked, but without effect: the triangles around a point need no mollification here.
    n_neighbors : int
        The number of nearest points that determine a tangent plane, at least 2.

    Returns
    -------
    L, M : (n, n) scipy.sparse.csc_matrix
        As from `mesh_laplacian`.

    Raises
    ------
    InvalidSurfaceError
        If a coordinate is not finite, there are fewer than three different points, or all triangles have zero area.
    """
    from . import _point_cloud

    _nonnegative(mollify_factor, "mollify_factor")
    neighbors = _arrays.integer(n_neighbors, "n_neighbors", 2, 2**31)
    L, M = _point_cloud.laplacian(_arrays.doubles(points, "points", (None, 3)), neighbors)
    return _with_unused_vertices(_arrays.sparse(L), _arrays.sparse(M))


def solve_poisson(L: Any, M: Any, f: ArrayLike) -> numpy.ndarray:
    """Solve `L u = M f` on a surface of any number of components, on each of which L is singular.

    On each component, the mean of f is subtracted, without which there is no solution, and u has the mean zero. Vertices
    without triangles get zero. One factorization; O(n log n) to O(n^1.5) in practice.

    Parameters
    ----------
    L, M : (n, n) sparse matrices
        As from `laplacian`, or from `Triangulation.laplacian`.
    f : (n,) array of integers or floats
        The values of f: `u` solves −Δu = f.

    Returns
    -------
    (n,) array

    Raises
    ------
    NumericalError
        If a solution is not finite.

    Examples
    --------
    >>> import numpy, intrinsic_triangulations as it
    >>> L, M = it.laplacian([[0, 0, 0], [1, 0, 0], [0, 1, 0], [9, 0, 0], [10, 0, 0], [9, 1, 0]], [[0, 1, 2], [3, 4, 5]])
    >>> it.solve_poisson(L, M, [1, 0, -1, 2, 1, 0]).round(6) + 0
    array([ 0.111111,  0.111111, -0.222222,  0.111111,  0.111111, -0.222222])
    """
    L, M = scipy.sparse.csc_matrix(L), scipy.sparse.csc_matrix(M)
    n = L.shape[0]
    values = _arrays.finite(f, "f", (n,))
    exponent = numpy.frexp(abs(M).max())[1] if M.nnz else 0  # areas times areas could leave the range of doubles
    M = scipy.sparse.csc_matrix((numpy.ldexp(M.data, -exponent), M.indices, M.indptr), M.shape)
    number, labels = scipy.sparse.csgraph.connected_components(L != 0, directed=False)
    mass = numpy.bincount(labels, M @ numpy.ones(n), number)

    def without_mean(u: numpy.ndarray) -> numpy.ndarray:
        return u - numpy.divide(numpy.bincount(labels, M @ u, number), mass, out=numpy.zeros(number), where=mass > 0)[labels]

    free = numpy.ones(n, dtype=bool)
    free[numpy.unique(labels, return_index=True)[1]] = False  # one vertex of each component stays at zero
    right = M @ without_mean(values)
    u = numpy.zeros(n)
    try:
        u[free] = scipy.sparse.linalg.splu(L[free][:, free].tocsc()).solve(right[free])
    except RuntimeError as error:
        raise NumericalError(f"the Poisson problem cannot be solved: {error}") from None
    with numpy.errstate(over="ignore"):
        u = numpy.ldexp(numpy.where(mass[labels] > 0, without_mean(u), 0.0), exponent)
    if not numpy.isfinite(u).all():
        raise NumericalError("the Poisson problem cannot be solved: its solution is not finite")
    return u


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
