# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# The elements of a triangulation: their numbers and where they lie.

"""The elements of a triangulation: their numbers and where they lie."""

from __future__ import annotations

from typing import Any, Optional, Tuple

import numpy
import scipy.sparse
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._laplacian import Mass
from ._subdivision import CommonSubdivision


class Elements:
    """What can be asked of a `Triangulation` without changing it."""

    _surface: Any
    _points: Optional[numpy.ndarray]

    def __repr__(self) -> str:
        return (f"<Triangulation: {self.number_of_vertices} vertices, {self.number_of_edges} edges, "
                f"{self.number_of_faces} faces>")

    @property
    def number_of_vertices(self) -> int:
        """The number of vertices: the input vertices, with their numbers, followed by the inserted ones."""
        return self._surface.number_of_vertices()

    @property
    def number_of_edges(self) -> int:
        """The number of edges."""
        return self._surface.number_of_edges()

    @property
    def number_of_faces(self) -> int:
        """The number of faces."""
        return self._surface.number_of_faces()

    @property
    def faces(self) -> numpy.ndarray:
        """(m, 3) array of int64: the corners of the faces, counterclockwise. Corners may coincide."""
        return self._surface.faces()

    @property
    def face_edges(self) -> numpy.ndarray:
        """(m, 3) array of int64: the edge from corner i to corner i + 1 of each face."""
        return self._surface.edges_of_faces()

    @property
    def edges(self) -> numpy.ndarray:
        """(k, 2) array of int64: the ends of each edge. They may coincide, and several edges may have the same ends."""
        return self._surface.edges()

    @property
    def lengths(self) -> numpy.ndarray:
        """(k,) array: the length of each edge, in the unit of the input; within 1 ulp of the exact length."""
        return self._surface.lengths()

    @property
    def weights(self) -> numpy.ndarray:
        """(k,) array: half the sum of the cotangents of the one or two angles opposite to each edge; no unit.

        Weights are rounded, but have the exact sign: no interior weight of a Delaunay triangulation is negative. The
        off-diagonal entries of L are the negated sums of the weights of all edges that join two vertices.

        Raises
        ------
        InvalidSurfaceError
            If a face has zero area.
        """
        return self._surface.weights()

    @property
    def areas(self) -> numpy.ndarray:
        """(m,) array: the area of each face, in the squared unit of the input; the relative error is at most 2**-32."""
        return self._surface.areas()

    @property
    def angles(self) -> numpy.ndarray:
        """(m, 3) array: the angle at each corner of each face in radians; the relative error is at most 2**-49."""
        return self._surface.corner_angles()

    def sharp_edges(self, degrees: float, minimum_size: float = 0) -> numpy.ndarray:
        """Find the sharp edges of the input, to be constrained in `refine` before any flip.

        A sliver, thinner than `minimum_size` or four units in the last place of the largest coordinate, takes the
        direction of the face beyond its longest side. Chains of sharp edges shorter than `minimum_size` are dropped.
        Directions and lengths are rounded. O(n log n).

        Parameters
        ----------
        degrees : float
            The minimum angle between the directions of the two faces, from 0 to 180.
        minimum_size : float
            The size of slivers and short chains, in the unit of the input.

        Returns
        -------
        (k,) array of bool
            For each edge of the input.

        Raises
        ------
        ValueError
            If the surface is given by lengths alone.

        Examples
        --------
        >>> import intrinsic_triangulations as it
        >>> t = it.Triangulation([[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]], [[0, 1, 2], [1, 0, 3]])
        >>> int(t.sharp_edges(30).sum()), int(t.sharp_edges(100).sum())
        (1, 0)
        """
        if self._points is None:
            raise ValueError("the surface is given by lengths: its faces have no directions")
        return self._surface.sharp_edges(self._points, _arrays.number(degrees, "degrees"),
                                         _arrays.number(minimum_size, "minimum_size")).astype(bool)

    def edges_between(self, pairs: ArrayLike) -> numpy.ndarray:
        """Find the edges that join given pairs of vertices, to be constrained in `refine`.

        Parameters
        ----------
        pairs : (p, 2) array of integers
            The pairs, in any order. For a polyline `v` they are `numpy.stack((v[:-1], v[1:]), axis=1)`.

        Returns
        -------
        (k,) array of bool
            For each edge of the current triangulation.

        Raises
        ------
        ValueError
            If no edge joins the vertices of a pair.
        InvalidSurfaceError
            If there is no such vertex.

        Examples
        --------
        >>> import intrinsic_triangulations as it
        >>> t = it.Triangulation([[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]], [[0, 1, 2], [1, 0, 3]])
        >>> int(t.edges_between([[1, 0]]).sum())
        1
        """
        given = _arrays.indices(pairs, "pairs", (None, 2), self.number_of_vertices).tolist()
        wanted = {tuple(sorted(pair)) for pair in given}
        ends = [tuple(sorted(edge)) for edge in self.edges.tolist()]
        missing = wanted.difference(ends)
        if missing:
            first = next(pair for pair in given if tuple(sorted(pair)) in missing)
            raise ValueError(f"no edge joins the vertices {first[0]} and {first[1]}" +
                             (f", nor {len(missing) - 1} more pairs" if len(missing) > 1 else ""))
        return numpy.array([edge in wanted for edge in ends], dtype=bool)

    def _border(self) -> numpy.ndarray:
        return numpy.bincount(self._surface.edges_of_faces().ravel(), minlength=self.number_of_edges) == 1

    def _constrained(self, constrained: Any) -> Optional[numpy.ndarray]:
        return _arrays.marks(constrained, "constrained", self.number_of_edges)

    def laplacian(self, mass: Mass = "lumped") -> Tuple[scipy.sparse.csc_matrix, scipy.sparse.csc_matrix]:
        """Return the Laplace-Beltrami operator of this triangulation, flipped or not.

        Parameters
        ----------
        mass : {"lumped", "galerkin"}
            The mass matrix.

        Returns
        -------
        L, M : (n, n) scipy.sparse.csc_matrix
            As from `intrinsic_triangulations.laplacian`; but that function also flips border edges, in a second layer
            of the surface. Here, entries of border edges can be positive.

        Raises
        ------
        InvalidSurfaceError
            If a face has zero area.
        """
        is_lumped = _arrays.choice(mass, "mass", Mass) == 0
        return _arrays.sparse(self._surface.stiffness()), _arrays.sparse(self._surface.mass(is_lumped))

    @property
    def mass(self) -> numpy.ndarray:
        """(n,) array: a third of the area of the faces at each vertex, in the squared unit of the input."""
        return self._surface.mass(True)[0]

    @property
    def inserted_vertices(self) -> Tuple[numpy.ndarray, numpy.ndarray]:
        """(i,) array of input faces, and (i, 3) array of coordinates there: where the inserted vertices lie."""
        return self._surface.inserted_vertices()

    @property
    def positions(self) -> numpy.ndarray:
        """(n, 3) array: the positions of all vertices in space, in the unit of the input; rounded for new vertices.

        Raises
        ------
        ValueError
            If the surface is given by lengths alone.
        """
        if self._points is None:
            raise ValueError("the surface is given by lengths: its vertices have no positions")
        subdivision = self.common_subdivision() if self.number_of_vertices > len(self._points) else None
        return self._points.copy() if subdivision is None else subdivision.positions[:self.number_of_vertices]

    def common_subdivision(self) -> CommonSubdivision:
        """Return the common subdivision of the input and this triangulation, as it is now.

        O(size + number of crossings).

        Returns
        -------
        CommonSubdivision
            It transfers values and points between the two. Later flips do not change it.

        Raises
        ------
        UndecidedError
            If an edge crosses more than 2**20 input edges.
        """
        return CommonSubdivision(_core.subdivision(self._surface), self._points)
