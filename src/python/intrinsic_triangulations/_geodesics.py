# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Straight lines on a surface.

"""Straight lines on a surface, with potpourri3d's names: paths shortened by flips, and lines in a given direction."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional, Sequence, Tuple

import numpy
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._documented import documented
from ._rebuilt import Rebuilt

_NO_VERTEX = 2**32 - 1


@documented
class GeodesicPath(NamedTuple):
    """A line on a surface in space."""

    positions: numpy.ndarray
    """(k, 3) array: the points in space where it crosses edges, in the unit of the input; rounded."""
    faces: numpy.ndarray
    """(k,) array of int64: an input face for each point: except for the last, the face that the line enters there."""
    coordinates: numpy.ndarray
    """(k, 3) array: the barycentric coordinates of each point in its face."""
    length: float
    """The length of the line, in the unit of the input."""
    initial_length: float
    """The length of the initial path along edges; zero for a traced line."""
    is_geodesic: bool
    """Whether it is locally shortest, decided exactly. An unfinished path need not be."""
    status: str
    """For paths: "geodesic", "contractible" (a closed curve that was shrunk to a point), "blocked", "not_improvable" or
    "unfinished". For traced lines: "at_length", "at_border" or "at_vertex"."""
    flips: int
    """The number of flips."""
    distance: Optional[float] = None
    """If requested, the length of a shortest path, up to rounding. If `length` is the same, this path is one."""


@documented
class ShortestPath(NamedTuple):
    """A shortest path on any triangles."""

    positions: numpy.ndarray
    """(k, 3) array: its points, joined by straight lines; rounded."""
    faces: numpy.ndarray
    """(k,) array of int64: a face of each point, which contains the next one, too. Empty if source and target are one vertex
    that has no face."""
    coordinates: numpy.ndarray
    """(k, 3) array: the barycentric coordinates of each point in its face."""
    length: float
    """The sum of the lengths of the lines."""
    distance: float
    """The length of a shortest path, up to rounding."""
    is_complete: bool
    """Whether it was found; if not, some lines are missing."""

    @property
    def places(self) -> numpy.ndarray:
        """(k, 4) array: the path as a source of `geodesic_distances_from`."""
        return numpy.column_stack([self.faces, self.coordinates])


def shortest_path(V: ArrayLike, F: ArrayLike, source: Any, target: Any, via: Sequence[Any] = ()) -> ShortestPath:
    """Return a shortest path between two vertices or points of any triangles.

    It goes from each face at an edge into all others, however many there are, as `geodesic_distances` does.

    Parameters
    ----------
    V, F
        As for `MeshHeatMethodDistanceSolver`.
    source, target : integer, or four numbers
        The ends: vertices, or points, given as sources of `geodesic_distances_from`. `EdgeFlipGeodesicSolver.find_path`
        takes points in space.
    via : sequence
        Vertices or points in between: the path is shortest from each one to the next.

    Returns
    -------
    ShortestPath
        With one position if all stops are at the same point.

    Raises
    ------
    InvalidArgumentError
        If there is no path, or all faces around some vertex have zero area: `repair` removes them.
    InvalidPointError
        If a point does not lie on the surface.
    InvalidSurfaceError
        As for `MeshHeatMethodDistanceSolver`.
    """
    points, faces = _arrays.points_and_faces(V, F)
    _arrays.warn_of_gaps(points, faces)
    stops = {"source": source, **{f"via[{i}]": stop for i, stop in enumerate(via)}, "target": target}
    if len(stops) == 2 and not any(numpy.ndim(stop) for stop in stops.values()):
        ends = [_arrays.vertex(stop, name, len(points)) for name, stop in stops.items()]
        return ShortestPath(*_core.shortest_path(points, faces, numpy.array(ends, numpy.uint32), numpy.zeros(0, numpy.uint32),
                                                 numpy.zeros((0, 3))))
    places = [_arrays.places(stop, name, faces, len(points)) for name, stop in stops.items()]
    if any(len(place) != 1 for place in places):
        raise ValueError("source, target and via have to be vertices, or points of four numbers: a triangle and "
                         "barycentric coordinates")
    return ShortestPath(*_core.shortest_path(points, faces, numpy.zeros(0, numpy.uint32),
                                             *_arrays.numbers_and_coordinates(places)))


def _path(parts: tuple) -> GeodesicPath:
    positions, (faces, coordinates), *others = parts
    return GeodesicPath(positions, faces, coordinates, *others)


@documented
class CutSurface(NamedTuple):
    """A surface that was cut open."""

    positions: numpy.ndarray
    """(k, 3) array: the positions of the vertices; the input vertices come first."""
    triangles: numpy.ndarray
    """(l, 3) array of int64: the corners of the triangles."""
    input_faces: numpy.ndarray
    """(l,) array of int64: the input face that each triangle is part of."""
    faces: numpy.ndarray
    """For each new vertex, an input face that contains it."""
    coordinates: numpy.ndarray
    """The barycentric coordinates of the new vertices in these faces."""


class _Lines(Rebuilt):
    def __init__(self, V: ArrayLike, F: ArrayLike, t_coef: float = 1.0) -> None:
        points, faces = _arrays.points_and_faces(V, F)
        self._remember(_Lines.__init__, points.copy(), faces.copy())
        self._number_of_vertices = len(points)
        self._number_of_faces = len(faces)
        self._surface = _core.SurfaceInSpace(points, faces)

    def locate(self, point: ArrayLike) -> Tuple[int, numpy.ndarray]:
        """Find the point of the surface nearest to a point in space, for example a picked one. O(size).

        Parameters
        ----------
        point : (3,) array of integers or floats
            The point.

        Returns
        -------
        face : int
            A face of the input.
        coordinates : (3,) array
            The barycentric coordinates there, rounded, but exactly on an edge or at a vertex if these are nearest.

        Raises
        ------
        InvalidPointError
            If a coordinate is not finite, or there are no faces.
        """
        faces, coordinates = self._surface.locate(_arrays.vector(point, "point"))
        return int(faces[0]), coordinates[0]

    def cut_along_path(self, path: GeodesicPath) -> CutSurface:
        """Cut the surface open along a path or a traced line.

        Faces that the path crosses are divided, and each vertex on it gets a copy for each side. The ends of an open
        path are not divided unless they lie on the border.

        Parameters
        ----------
        path : GeodesicPath
            A path on this surface that does not cross itself.

        Returns
        -------
        CutSurface

        Raises
        ------
        InvalidSurfaceError
            If two edges of the surface join the same vertices.
        InvalidPointError
            If the path does not lie on the surface, or crosses itself.
        """
        faces = _arrays.indices(path.faces, "path.faces", (None,), self._number_of_faces)
        points, triangles, input_faces, (new_faces, new_coordinates) = self._surface.cut_along_path(
            faces, _arrays.doubles(path.coordinates, "path.coordinates", (len(faces), 3))
        )
        return CutSurface(points, triangles, input_faces, new_faces, new_coordinates)


class EdgeFlipGeodesicSolver(_Lines):
    """Finds locally shortest paths and closed curves by flipping edges.

    A path starts along edges, and is shortened until the angles on both sides of each vertex on it are at least π,
    decided exactly. It need not be a shortest path. Queries are independent of each other; each copies the
    triangulation.

    Parameters
    ----------
    V : (n, 3) array of integers or floats
        The positions of the vertices.
    F : (m, 3) array of integers
        The corners of the triangles, counted from 0: an oriented manifold.
    t_coef : float
        Has no effect; it is for programs written for potpourri3d.

    Raises
    ------
    InvalidSurfaceError
        As `Triangulation`.
    """

    def find_geodesic_path(self, v_start: int, v_end: int, max_iterations: Optional[int] = None,
                           max_relative_length_decrease: Optional[float] = None) -> numpy.ndarray:
        """Return a locally shortest path between two vertices.

        Parameters
        ----------
        v_start, v_end : int
            The ends of the path.
        max_iterations : int, optional
            The number of flips after which to stop.
        max_relative_length_decrease : float, optional
            Must be 0, potpourri3d's default: paths are straightened completely.

        Returns
        -------
        (k, 3) array
            The points of the path in space.

        Raises
        ------
        InvalidArgumentError
            If there is no such vertex, or no path along edges.
        """
        return self.find_path([v_start, v_end], False, max_iterations, max_relative_length_decrease).positions

    def find_geodesic_path_poly(self, v_list: Any, max_iterations: Optional[int] = None,
                                max_relative_length_decrease: Optional[float] = None) -> numpy.ndarray:
        """Like `find_geodesic_path`, but start with edge paths from each vertex of `v_list` to the next. The result
        need not pass through the vertices in between."""
        return self.find_path(v_list, False, max_iterations, max_relative_length_decrease).positions

    def find_geodesic_loop(self, v_list: Any, max_iterations: Optional[int] = None,
                           max_relative_length_decrease: Optional[float] = None) -> numpy.ndarray:
        """Return a locally shortest closed curve, starting with edge paths from each vertex of `v_list` to the next,
        and from the last to the first. The first point is repeated as the last. A curve that can be shrunk to a point
        becomes one."""
        return self.find_path(v_list, True, max_iterations, max_relative_length_decrease).positions

    def find_path(self, v_list: Any, is_closed: bool = False, max_iterations: Optional[int] = None,
                  max_relative_length_decrease: Optional[float] = None, *, is_shortest: bool = False) -> GeodesicPath:
        """Like the other functions, but return everything known about the path.

        Parameters
        ----------
        v_list : (k,) array of integers, or a list that also contains (3,) arrays of floats
            At least two stops: vertices, or points in space, each of which stands for the nearest point of the surface.
        is_closed : bool
            Whether the curve returns to its first vertex.
        max_iterations, max_relative_length_decrease
            As for `find_geodesic_path`.
        is_shortest : bool
            Whether to find a shortest path from stop to stop, with its length in `distance`; not for closed curves.

        Returns
        -------
        GeodesicPath
            It has no points if an open path ends where it starts.

        Raises
        ------
        InvalidArgumentError
            If there is no such vertex, or no path along edges.
        """
        if max_relative_length_decrease not in (None, 0):
            raise ValueError("max_relative_length_decrease has to be None or 0: paths are straightened completely")
        maximum = 2**64 - 1 if max_iterations is None else _arrays.integer(max_iterations, "max_iterations")
        if is_closed and is_shortest:
            raise ValueError("is_shortest has to be False for closed curves")
        vertices, points = self._stops(v_list)
        if len(vertices) < 2:
            raise ValueError("v_list has to name two vertices or more")
        return _path(self._surface.path(vertices, points, bool(is_closed), bool(is_shortest), maximum))

    def _stops(self, v_list: Any) -> Tuple[numpy.ndarray, numpy.ndarray]:
        if not numpy.iterable(v_list) or not any(numpy.ndim(stop) for stop in v_list):
            vertices = _arrays.indices(v_list, "v_list", (None,), self._number_of_vertices)
            return vertices, numpy.zeros((len(vertices), 3))
        vertices = numpy.full(len(v_list), _NO_VERTEX, dtype=numpy.uint32)
        points = numpy.zeros((len(v_list), 3))
        for i, stop in enumerate(v_list):
            if numpy.ndim(stop):
                points[i] = _arrays.vector(stop, "v_list")
            else:
                vertices[i] = _arrays.vertex(stop, "v_list", self._number_of_vertices)
        return vertices, points


def geodesic_path(V: ArrayLike, F: ArrayLike, source: Any, target: Any, is_shortest: bool = False) -> GeodesicPath:
    """Return a locally shortest path between two vertices or points.

    Parameters
    ----------
    V, F
        As for `EdgeFlipGeodesicSolver`.
    source, target : int, or (3,) array of floats
        The ends: vertices, or points in space, each of which stands for the nearest point of the surface.
    is_shortest : bool
        Whether to find a shortest path.

    Returns
    -------
    GeodesicPath

    Raises
    ------
    InvalidSurfaceError, InvalidArgumentError
        As `EdgeFlipGeodesicSolver` and its `find_path`.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> V = [[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]]
    >>> path = it.geodesic_path(V, [[0, 1, 2], [1, 0, 3]], 2, 3)
    >>> path.length, path.is_geodesic, path.positions[1]
    (2.0, True, array([2., 0., 0.]))
    """
    return EdgeFlipGeodesicSolver(V, F).find_path([source, target], is_shortest=is_shortest)


def cut_along_path(V: ArrayLike, F: ArrayLike, path: GeodesicPath) -> CutSurface:
    """Cut a surface open along a path.

    Parameters
    ----------
    V, F
        As for `EdgeFlipGeodesicSolver`.
    path : GeodesicPath
        As for `EdgeFlipGeodesicSolver.cut_along_path`.

    Returns
    -------
    CutSurface

    Raises
    ------
    InvalidSurfaceError, InvalidPointError
        As `EdgeFlipGeodesicSolver` and its `cut_along_path`.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> V, F = [[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]], [[0, 1, 2], [1, 0, 3]]
    >>> cut = it.cut_along_path(V, F, it.geodesic_path(V, F, 2, 3))
    >>> len(cut.triangles), len(cut.positions)
    (4, 8)
    """
    return EdgeFlipGeodesicSolver(V, F).cut_along_path(path)


class GeodesicTracer(_Lines):
    """Traces straight lines on a surface from a point in a given direction.

    Which edge a line crosses next is decided exactly; points are rounded. A line ends after the length of the vector,
    at the border, or if it hits a vertex exactly. Unless `max_iterations` is given, a line that crosses a million faces
    is an error.

    Parameters
    ----------
    V : (n, 3) array of integers or floats
        The positions of the vertices.
    F : (m, 3) array of integers
        The corners of the triangles, counted from 0: an oriented manifold.
    t_coef : float
        Has no effect; it is for programs written for potpourri3d.

    Raises
    ------
    InvalidSurfaceError
        As `Triangulation`.
    """

    def trace_geodesic_from_vertex(self, start_vert: int, direction_xyz: ArrayLike, max_iterations: Optional[int] = None) -> numpy.ndarray:
        """Trace a line from a vertex.

        Parameters
        ----------
        start_vert : int
            The vertex.
        direction_xyz : (3,) array of integers or floats
            A vector, projected to the tangent plane at the vertex. Between neighboring edges, angles in that plane and
            on the surface are proportional.
        max_iterations : int, optional
            The number of faces after which the line is cut off, at least 1.

        Returns
        -------
        (k, 3) array
            The points of the line in space.

        Raises
        ------
        InvalidPointError
            If the direction or the point is not finite, or not on the surface.
        """
        start = _arrays.vertex(start_vert, "start_vert", self._number_of_vertices)
        vector = _arrays.vector(direction_xyz, "direction_xyz")
        return _path(self._surface.trace_from_vertex(start, vector, _number_of_faces(max_iterations))).positions

    def trace_geodesic_from_face(self, start_face: int, bary_coords: ArrayLike, direction_xyz: ArrayLike,
                                 max_iterations: Optional[int] = None) -> numpy.ndarray:
        """Trace a line from a point in a face.

        Parameters
        ----------
        start_face : int
            The face.
        bary_coords : (3,) array of integers or floats
            The nonnegative coordinates of the point, for the corners of the face in order.
        direction_xyz : (3,) array of integers or floats
            A vector, projected to the plane of the face.
        max_iterations : int, optional
            The number of faces after which the line is cut off, at least 1.

        Returns
        -------
        (k, 3) array
            The points of the line in space.

        Raises
        ------
        InvalidPointError
            If the direction or the point is not finite, or not on the surface.
        """
        start = _arrays.integer(start_face, "start_face", 0, self._number_of_faces - 1)
        coordinates = _arrays.vector(bary_coords, "bary_coords")
        vector = _arrays.vector(direction_xyz, "direction_xyz")
        return _path(self._surface.trace_from_face(start, coordinates, vector, _number_of_faces(max_iterations))).positions


def _number_of_faces(max_iterations: Optional[int]) -> Optional[int]:
    return None if max_iterations is None else _arrays.integer(max_iterations, "max_iterations", 1)
