# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# The common subdivision of the input and a triangulation.

"""The common subdivision of the input and a triangulation, which carries values and points from one to the other."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Optional, Tuple

import numpy
import scipy.sparse
from numpy.typing import ArrayLike

from . import _arrays


class CommonSubdivision:
    """The polygons into which the edges of the input and those of a triangulation cut the surface.

    `Triangulation.common_subdivision` returns it. Each polygon is convex, and lies in one face of the input and in one of the
    triangulation. Its vertices are those of the input, then the inserted ones, then the crossings of edges.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> t = it.Triangulation([[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]], [[0, 1, 2], [1, 0, 3]])
    >>> t.flip_to_delaunay().flips
    1
    >>> s = t.common_subdivision()
    >>> s.number_of_polygons, s.number_of_crossings, s.positions[-1]
    (4, 1, array([2., 0., 0.]))
    """

    def __init__(self, subdivision: Any, points: Optional[numpy.ndarray]) -> None:
        self._subdivision = subdivision
        self._points = points

    def __getstate__(self) -> Any:
        return {name: value for name, value in self.__dict__.items() if name in ("_subdivision", "_points")}

    def __repr__(self) -> str:
        return f"<CommonSubdivision: {self.number_of_vertices} vertices, {self.number_of_polygons} polygons>"

    @property
    def number_of_input_vertices(self) -> int:
        """The number of vertices of the input, which come first."""
        return self._subdivision.number_of_input_vertices()

    @property
    def number_of_inserted_vertices(self) -> int:
        """The number of inserted vertices of the triangulation, which come next."""
        return self._subdivision.number_of_original_vertices() - self.number_of_input_vertices

    @property
    def number_of_crossings(self) -> int:
        """The number of crossings of an edge of the input and one of the triangulation, which come last."""
        return self.number_of_vertices - self._subdivision.number_of_original_vertices()

    @property
    def number_of_vertices(self) -> int:
        """The number of all vertices."""
        return self._subdivision.number_of_vertices()

    @property
    def number_of_polygons(self) -> int:
        """The number of polygons."""
        return len(self.offsets) - 1

    @cached_property
    def _polygons(self) -> Tuple[numpy.ndarray, numpy.ndarray]:
        return _read_only(*self._subdivision.polygons())

    @property
    def offsets(self) -> numpy.ndarray:
        """(p + 1,) array of int64: the corners of polygon i are `corners[offsets[i]:offsets[i + 1]]`, counterclockwise."""
        return self._polygons[0]

    @property
    def corners(self) -> numpy.ndarray:
        """(c,) array of int64: the vertices of all polygons, one after the other."""
        return self._polygons[1]

    @cached_property
    def _faces(self) -> Tuple[numpy.ndarray, numpy.ndarray]:
        return _read_only(*self._subdivision.faces_of_polygons())

    @property
    def input_faces(self) -> numpy.ndarray:
        """(p,) array of int64: the face of the input in which each polygon lies."""
        return self._faces[0]

    @property
    def intrinsic_faces(self) -> numpy.ndarray:
        """(p,) array of int64: the face of the triangulation in which each polygon lies."""
        return self._faces[1]

    @cached_property
    def _segments(self) -> Tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray]:
        return _read_only(*self._subdivision.segments())

    @property
    def segments(self) -> numpy.ndarray:
        """(s, 2) array of int64: the two ends of each side of a polygon, once for both polygons beside it."""
        return self._segments[0]

    @property
    def segment_input_edges(self) -> numpy.ndarray:
        """(s,) array of int64: the edge of the input that each segment is a part of, or -1."""
        return self._segments[1]

    @property
    def segment_intrinsic_edges(self) -> numpy.ndarray:
        """(s,) array of int64: the edge of the triangulation that each segment is a part of, or -1."""
        return self._segments[2]

    @cached_property
    def input_matrix(self) -> scipy.sparse.csc_matrix:
        """(v, n) matrix: from values at the vertices of the input to values at all vertices. Its rows are coordinates in faces."""
        return _arrays.sparse(self._subdivision.input_matrix())

    @cached_property
    def intrinsic_matrix(self) -> scipy.sparse.csc_matrix:
        """(v, n') matrix: from values at the vertices of the triangulation to values at all vertices."""
        return _arrays.sparse(self._subdivision.intrinsic_matrix())

    def from_input(self, values: ArrayLike) -> numpy.ndarray:
        """The function that is linear on the faces of the input, at all vertices.

        Parameters
        ----------
        values : (n,) or (n, k) array of integers or floats
            The value at each vertex of the input.

        Returns
        -------
        (v,) or (v, k) array
        """
        return self.input_matrix @ _values(values, self.input_matrix.shape[1])

    def from_intrinsic(self, values: ArrayLike) -> numpy.ndarray:
        """The function that is linear on the faces of the triangulation, at all vertices.

        Parameters
        ----------
        values : (n',) or (n', k) array of integers or floats
            The value at each vertex of the triangulation.

        Returns
        -------
        (v,) or (v, k) array
        """
        return self.intrinsic_matrix @ _values(values, self.intrinsic_matrix.shape[1])

    def from_input_corners(self, values: ArrayLike) -> numpy.ndarray:
        """Values at the corners of the faces of the input, such as texture coordinates with seams.

        Parameters
        ----------
        values : (m, 3) or (m, 3, k) array of integers or floats
            The value at each corner of each face, in the order of F.

        Returns
        -------
        (c,) or (c, k) array
            The value at each corner of each polygon, in the order of `corners`. Where the values at both sides of an edge of the
            input differ, so do these.
        """
        array = _arrays.as_array(values, "values", "iuf", "real numbers")
        if array.ndim not in (2, 3) or array.shape[1] != 3:
            raise ValueError(f"values should have shape (m, 3) or (m, 3, k), but has {array.shape}")
        array = _arrays.doubles(array, "values", array.shape)
        if array.ndim == 2:
            return self._subdivision.interpolate_corners(numpy.ascontiguousarray(array).reshape(-1))
        columns = [self._subdivision.interpolate_corners(numpy.ascontiguousarray(array[:, :, i]).reshape(-1))
                   for i in range(array.shape[2])]
        return numpy.stack(columns, axis=1) if columns else numpy.zeros((len(self.corners), 0))

    @cached_property
    def positions(self) -> numpy.ndarray:
        """(v, 3) array: the positions of all vertices in space, in the unit of the input.

        Raises
        ------
        ValueError
            If the surface is given by lengths alone.
        """
        if self._points is None:
            raise ValueError("the surface is given by lengths: its vertices have no positions")
        return self.input_matrix @ self._points

    def triangles(self) -> Tuple[numpy.ndarray, numpy.ndarray]:
        """The polygons cut into triangles, for programs that draw nothing else.

        Returns
        -------
        corners : (t, 3) array of int64
            For each triangle, the positions of its corners in `corners`; so its vertices are `s.corners[corners]`.
        polygons : (t,) array of int64
            The polygon in which it lies.
        """
        counts = numpy.diff(self.offsets) - 2
        polygons = numpy.repeat(numpy.arange(len(counts)), counts)
        number_in_polygon = numpy.arange(len(polygons)) - numpy.repeat(numpy.cumsum(counts) - counts, counts)
        first = self.offsets[polygons]
        return numpy.stack([first, first + number_in_polygon + 1, first + number_in_polygon + 2], axis=1), polygons

    def mesh(self) -> Tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray, numpy.ndarray]:
        """What a viewer needs: plain arrays of a mesh in space that shows both triangulations.

        Returns
        -------
        points : (v, 3) array
            `positions`.
        triangles : (t, 3) array of int64
            The vertices of each triangle, for `polyscope.register_surface_mesh`, `pyvista.PolyData.from_regular_faces` and the like.
        input_faces, intrinsic_faces : (t,) arrays of int64
            The faces in which each triangle lies.
        """
        corners, polygons = self.triangles()
        return self.positions, self.corners[corners], self.input_faces[polygons], self.intrinsic_faces[polygons]

    def to_intrinsic(self, faces: ArrayLike, coordinates: ArrayLike) -> Tuple[numpy.ndarray, numpy.ndarray]:
        """Points of the input as points of the triangulation.

        Parameters
        ----------
        faces : (k,) array of integers
            The face of the input in which each point lies.
        coordinates : (k, 3) array of integers or floats
            Its barycentric coordinates, for the corners of the face in order: not negative. They need not sum to 1.

        Returns
        -------
        faces : (k,) array of int64
            The face of the triangulation.
        coordinates : (k, 3) array
            The coordinates there. One is zero exactly if the point lies on an edge, and two if it is a vertex.

        Raises
        ------
        InvalidArgumentError
            If there is no such face.
        InvalidPointError
            If coordinates are negative, not finite, or all zero.
        """
        return self._subdivision.to_intrinsic(*_surface_points(faces, coordinates))

    def to_input(self, faces: ArrayLike, coordinates: ArrayLike) -> Tuple[numpy.ndarray, numpy.ndarray]:
        """Points of the triangulation as points of the input; otherwise as `to_intrinsic`."""
        return self._subdivision.to_input(*_surface_points(faces, coordinates))

    def mass_matrices(self) -> Tuple[scipy.sparse.csc_matrix, scipy.sparse.csc_matrix, scipy.sparse.csc_matrix]:
        """The integrals of the products of hat functions, in the squared unit of the input.

        Returns
        -------
        M_input : (n, n) scipy.sparse.csc_matrix
            Both functions are those of the input.
        M_intrinsic : (n', n') scipy.sparse.csc_matrix
            Both functions are those of the triangulation.
        M_mixed : (n', n) scipy.sparse.csc_matrix
            Rows for the triangulation, columns for the input: the solution u of `M_intrinsic u = M_mixed v` is, of all functions on the
            triangulation, nearest to the function v on the input.
        """
        one, two, mixed = self._subdivision.mass_matrices()
        return _arrays.sparse(one), _arrays.sparse(two), _arrays.sparse(mixed)


def _surface_points(faces: ArrayLike, coordinates: ArrayLike) -> Tuple[numpy.ndarray, numpy.ndarray]:
    of_faces = _arrays.indices(faces, "faces", (None,), None, "face")
    return of_faces, _arrays.doubles(coordinates, "coordinates", (len(of_faces), 3))


def _values(values: ArrayLike, number: int) -> numpy.ndarray:
    array = _arrays.as_array(values, "values", "iuf", "real numbers")
    if array.ndim not in (1, 2) or array.shape[0] != number:
        raise ValueError(f"values should have shape ({number},) or ({number}, k), but has {array.shape}")
    return _arrays.doubles(array, "values", array.shape)


def _read_only(*arrays: numpy.ndarray) -> Tuple[numpy.ndarray, ...]:
    # They are returned again and again.
    for array in arrays:
        array.flags.writeable = False
    return arrays
