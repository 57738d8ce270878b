# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Tangent vectors by the vector heat method.

"""Parallel transport of tangent vectors, and logarithmic maps, with potpourri3d's names."""

from __future__ import annotations

from typing import Any, Literal, Optional, Tuple

import numpy
import scipy.sparse
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._rebuilt import Rebuilt

Strategy = Literal["VectorHeat", "AffineLocal", "AffineAdaptive"]


class MeshVectorHeatSolver(Rebuilt):
    """Parallel-transports tangent vectors along shortest paths, and computes logarithmic maps, by the vector heat
    method.

    The matrices are factorized once; each query then solves two or three linear systems. A tangent vector has two
    coordinates in the frame of its vertex; `get_tangent_frames` returns these frames. Several threads may share a
    solver. Results are approximate.

    Parameters
    ----------
    V : (n, 3) array of integers or floats
        The positions of the vertices.
    F : (m, 3) array of integers
        The corners of the triangles, counted from 0: an oriented manifold.
    t_coef : float, optional
        The time for which heat spreads, in units of the squared mean edge length: the longer, the smoother. Default:
        0.05 times the cube root of the number of vertices of each component, but at least 0.5.
    use_intrinsic_delaunay : bool
        Must be True: on other triangulations the method has no guarantees.

    Raises
    ------
    InvalidSurfaceError
        As `Triangulation`.
    NumericalError
        If a matrix cannot be factorized.
    """

    def __init__(self, V: ArrayLike, F: ArrayLike, t_coef: Optional[float] = None, use_intrinsic_delaunay: bool = True) -> None:
        if not use_intrinsic_delaunay:
            raise ValueError("use_intrinsic_delaunay has to be True: on other triangulations, the method has no guarantees")
        time = None if t_coef is None else _arrays.positive(t_coef, "t_coef")
        points, faces = _arrays.points_and_faces(V, F)
        self._remember(MeshVectorHeatSolver.__init__, points.copy(), faces.copy(), t_coef)
        surface = _core.Surface.from_points(points, faces)
        surface.flip_to_delaunay(None, 2**64 - 1)
        self._surface = surface
        self._points = points.copy()
        self._heat = _core.vector_heat(surface, time)

    def get_tangent_frames(self) -> Tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray]:
        """Return the tangent planes in space.

        Returns
        -------
        basis_x, basis_y, basis_n : (n, 3) arrays
            For each vertex, the two axes and the normal: rounded orthogonal unit vectors. The vector with coordinates
            (a, b) is `a * basis_x[v] + b * basis_y[v]`.
        """
        return _core.tangent_frames(self._surface, self._points)

    def get_connection_laplacian(self) -> scipy.sparse.csc_matrix:
        """Return the connection Laplacian for tangent vectors as complex numbers.

        Returns
        -------
        (n, n) scipy.sparse.csc_matrix of complex numbers
            Hermitian, without unit.
        """
        return _arrays.sparse(_core.connection_laplacian(self._surface))

    def transport_tangent_vector(self, v_ind: int, vector: Any) -> numpy.ndarray:
        """Parallel-transport a tangent vector from one vertex to all others along shortest paths.

        Parameters
        ----------
        v_ind : int
            The vertex.
        vector : (2,) array of integers or floats
            Its coordinates in the frame of the vertex.

        Returns
        -------
        (n, 2) array
            The coordinates in the frame of each vertex; (0, 0) where the source is not connected.
        """
        source = _arrays.vertex(v_ind, "v_ind", len(self._points))
        return self.transport_tangent_vectors([source], _arrays.doubles(vector, "vector", (2,))[None])

    def transport_tangent_vectors(self, v_inds: ArrayLike, vectors: Any) -> numpy.ndarray:
        """Parallel-transport tangent vectors from several vertices: every other vertex gets the vector of the nearest
        one.

        Parameters
        ----------
        v_inds : (k,) array of integers
            Different vertices.
        vectors : (k, 2) array of integers or floats
            Coordinates in their frames.

        Returns
        -------
        (n, 2) array
            As for `transport_tangent_vector`.
        """
        vertices = _arrays.indices(v_inds, "v_inds", (None,), len(self._points))
        if len(numpy.unique(vertices)) < len(vertices):
            raise ValueError("v_inds has to name each vertex once")
        array = _arrays.doubles(vectors, "vectors", (len(vertices), 2))
        return self._heat.transport(vertices, array[:, 0], array[:, 1])

    def compute_log_map(self, v_ind: int, strategy: Strategy = "AffineLocal") -> numpy.ndarray:
        """Return the logarithmic map at a vertex: direction and distance of every other vertex.

        Parameters
        ----------
        v_ind : int
            The vertex.
        strategy : {"VectorHeat", "AffineLocal", "AffineAdaptive"}
            Has no effect; it is for programs written for potpourri3d. The method is by Soliman and Sharp (2025).

        Returns
        -------
        (n, 2) array
            In the frame of the vertex, in the unit of the input: (0, 0) at the vertex, infinite where it is not
            connected.
        """
        _arrays.choice(strategy, "strategy", Strategy)
        return self._heat.log_map(_arrays.vertex(v_ind, "v_ind", len(self._points)))

    def extend_scalar(self, v_inds: ArrayLike, values: ArrayLike) -> numpy.ndarray:
        """Extend values at some vertices to all: elsewhere, to about the value at the nearest of these vertices.

        Parameters
        ----------
        v_inds : (k,) array of integers
            The vertices.
        values : (k,) array of integers or floats
            Their values.

        Returns
        -------
        (n,) array
            Zero where no such vertex can be reached.
        """
        vertices = _arrays.indices(v_inds, "v_inds", (None,), len(self._points))
        return self._heat.extend(vertices, _arrays.finite(values, "values", (len(vertices),)))
