# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# The common subdivision of the input and a triangulation.

"""The common subdivision of the input and a triangulation, which transfers values and points between them."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Optional, Tuple

import numpy
import scipy.sparse
from numpy.typing import ArrayLike

from . import _arrays


class CommonSubdivision:
    """The polygons into which the edges of the input and of a triangulation cut the surface.

    `Triangulation.common_subdivision` returns it. Each polygon is convex and lies in one face of the input and in one
    face of the triangulation. The vertices are the input vertices, then the inserted vertices, then the crossings of
    edges. Which edges cross is exact; positions, coordinates and matrices are rounded.

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
        """The number of input vertices, which come first."""
        return self._subdivision.number_of_input_vertices()

    @property
    def number_of_inserted_vertices(self) -> int:
        """The number of inserted vertices, which come next."""
        return self._subdivision.number_of_original_vertices() - self.number_of_input_vertices

    @property
    def number_of_crossings(self) -> int:
        """The number of crossings of input edges and edges of the triangulation, which come last."""
        return self.number_of_vertices - self._subdivision.number_of_original_vertices()

    @property
    def number_of_vertices(self) -> int:
        """The total number of vertices."""
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
        """(p + 1,) array of int64: the corners of polygon i are `corners[offsets[i]:offsets[i + 1]]`,
        counterclockwise."""
        return self._polygons[0]

    @property
    def corners(self) -> numpy.ndarray:
        """(c,) array of int64: the vertices of all polygons, one polygon after another."""
        return self._polygons[1]

    @cached_property
    def _faces(self) -> Tuple[numpy.ndarray, numpy.ndarray]:
        return _read_only(*self._subdivision.faces_of_polygons())

    @property
    def input_faces(self) -> numpy.ndarray:
        """(p,) array of int64: the input face of each polygon."""
        return self._faces[0]

    @property
    def intrinsic_faces(self) -> numpy.ndarray:
        """(p,) array of int64: the face of the triangulation that contains each polygon."""
        return self._faces[1]

    @cached_property
    def _segments(self) -> Tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray]:
        return _read_only(*self._subdivision.segments())

    @property
    def segments(self) -> numpy.ndarray:
        """(s, 2) array of int64: the ends of each side of a polygon; two adjacent polygons share one segment."""
        return self._segments[0]

    @property
    def segment_input_edges(self) -> numpy.ndarray:
        """(s,) array of int64: the input edge that contains each segment, or -1."""
        return self._segments[1]

    @property
    def segment_intrinsic_edges(self) -> numpy.ndarray:
        """(s,) array of int64: the edge of the triangulation that contains each segment, or -1."""
        return self._segments[2]

    @cached_property
    def input_matrix(self) -> scipy.sparse.csc_matrix:
        """(v, n) matrix: maps values at the input vertices to values at all vertices. Its rows are coordinates in
        faces."""
        return _arrays.sparse(self._subdivision.input_matrix())

    @cached_property
    def intrinsic_matrix(self) -> scipy.sparse.csc_matrix:
        """(v, n') matrix: maps values at the vertices of the triangulation to values at all vertices."""
        return _arrays.sparse(self._subdivision.intrinsic_matrix())

    def from_input(self, values: ArrayLike) -> numpy.ndarray:
        """Interpolate values at the input vertices to all vertices, linearly on the input faces.

        Parameters
        ----------
        values : (n,) or (n, k) array of integers or floats
            The value at each input vertex.

        Returns
        -------
        (v,) or (v, k) array
        """
        return self.input_matrix @ _values(values, self.input_matrix.shape[1])

    def from_intrinsic(self, values: ArrayLike) -> numpy.ndarray:
        """Interpolate values at the vertices of the triangulation to all vertices, linearly on its faces.

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
        """Interpolate values at the corners of the input faces, such as texture coordinates with seams.

        Parameters
        ----------
        values : (m, 3) or (m, 3, k) array of integers or floats
            The value at each corner of each face, in the order of F.

        Returns
        -------
        (c,) or (c, k) array
            The value at each corner of each polygon, in the order of `corners`. Where values differ across an input
            edge, the results do, too.
        """
        array = _arrays.as_array(values, "values", "iuf", "real numbers")
        if array.ndim not in (2, 3) or array.shape[1] != 3:
            raise ValueError(f"values has to have shape (m, 3) or (m, 3, k), not {array.shape}")
        array = _arrays.doubles(array, "values", array.shape)
        if array.ndim == 2:
            return self._subdivision.interpolate_corners(numpy.ascontiguousarray(array).reshape(-1))
        columns = [self._subdivision.interpolate_corners(numpy.ascontiguousarray(array[:, :, i]).reshape(-1))
                   for i in range(array.shape[2])]
        return numpy.stack(columns, axis=1) if columns else numpy.zeros((len(self.corners), 0))

    @cached_property
    def positions(self) -> numpy.ndarray:
        """(v, 3) array: the positions of all vertices in space, in the unit of the input, rounded.

        Raises
        ------
        ValueError
            If the surface is given by lengths alone.
        """
        if self._points is None:
            raise ValueError("the surface is given by lengths: its vertices have no positions")
        return self.input_matrix @ self._points

    def triangles(self) -> Tuple[numpy.ndarray, numpy.ndarray]:
        """Cut the polygons into triangles, for programs that draw only triangles.

        Returns
        -------
        corners : (t, 3) array of int64
            For each triangle, the positions of its corners in `corners`: its vertices are `s.corners[corners]`.
        polygons : (t,) array of int64
            The polygon of each triangle.
        """
        counts = numpy.diff(self.offsets) - 2
        polygons = numpy.repeat(numpy.arange(len(counts)), counts)
        number_in_polygon = numpy.arange(len(polygons)) - numpy.repeat(numpy.cumsum(counts) - counts, counts)
        first = self.offsets[polygons]
        return numpy.stack([first, first + number_in_polygon + 1, first + number_in_polygon + 2], axis=1), polygons

    def mesh(self) -> Tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray, numpy.ndarray]:
        """Return plain arrays for a viewer: a mesh in space that shows both triangulations.

        Returns
        -------
        points : (v, 3) array
            `positions`.
        triangles : (t, 3) array of int64
            The vertices of each triangle, for example for `polyscope.register_surface_mesh` or
            `pyvista.PolyData.from_regular_faces`.
        input_faces, intrinsic_faces : (t,) arrays of int64
            The two faces that contain each triangle.
        """
        corners, polygons = self.triangles()
        return self.positions, self.corners[corners], self.input_faces[polygons], self.intrinsic_faces[polygons]

    def to_intrinsic(self, faces: ArrayLike, coordinates: ArrayLike) -> Tuple[numpy.ndarray, numpy.ndarray]:
        """Map points of the input to the triangulation.

        The face of each point is decided exactly. Each point costs O(log n) for n edges that cross its input face,
        unless it is extremely close to one of them.

        Parameters
        ----------
        faces : (k,) array of integers
            The input face of each point.
        coordinates : (k, 3) array of integers or floats
            Its nonnegative barycentric coordinates, for the corners of the face in order. They need not sum to 1.

        Returns
        -------
        faces : (k,) array of int64
            The face of the triangulation.
        coordinates : (k, 3) array
            The coordinates there, rounded; but one is zero exactly if the point lies on an edge, two if it is a vertex.

        Raises
        ------
        InvalidArgumentError
            If there is no such face.
        InvalidPointError
            If coordinates are negative, not finite, or all zero.
        """
        return self._subdivision.to_intrinsic(*_surface_points(faces, coordinates))

    def to_input(self, faces: ArrayLike, coordinates: ArrayLike) -> Tuple[numpy.ndarray, numpy.ndarray]:
        """Map points of the triangulation to the input; otherwise like `to_intrinsic`."""
        return self._subdivision.to_input(*_surface_points(faces, coordinates))

    def mass_matrices(self) -> Tuple[scipy.sparse.csc_matrix, scipy.sparse.csc_matrix, scipy.sparse.csc_matrix]:
        """Integrate the products of hat functions, in the squared unit of the input. O(size of the subdivision).

        Returns
        -------
        M_input : (n, n) scipy.sparse.csc_matrix
            Both functions belong to the input.
        M_intrinsic : (n', n') scipy.sparse.csc_matrix
            Both functions belong to the triangulation.
        M_mixed : (n', n) scipy.sparse.csc_matrix
            Rows belong to the triangulation, columns to the input. The solution u of `M_intrinsic u = M_mixed v` is the
            function on the triangulation nearest to the function v on the input.
        """
        one, two, mixed = self._subdivision.mass_matrices()
        return _arrays.sparse(one), _arrays.sparse(two), _arrays.sparse(mixed)


def _surface_points(faces: ArrayLike, coordinates: ArrayLike) -> Tuple[numpy.ndarray, numpy.ndarray]:
    of_faces = _arrays.indices(faces, "faces", (None,), None, "face")
    return of_faces, _arrays.doubles(coordinates, "coordinates", (len(of_faces), 3))


def _values(values: ArrayLike, number: int) -> numpy.ndarray:
    array = _arrays.as_array(values, "values", "iuf", "real numbers")
    if array.ndim not in (1, 2) or array.shape[0] != number:
        raise ValueError(f"values has to have shape ({number},) or ({number}, k), not {array.shape}")
    return _arrays.doubles(array, "values", array.shape)


def _read_only(*arrays: numpy.ndarray) -> Tuple[numpy.ndarray, ...]:
    # They are returned again and again.
    for array in arrays:
        array.flags.writeable = False
    return arrays
