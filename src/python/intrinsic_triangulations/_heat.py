# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Distances by the heat method, and along shortest paths.

"""Distances by the heat method, with potpourri3d's names, and along shortest paths."""

from __future__ import annotations

from numbers import Integral
from typing import Any, Literal, Optional, Sequence, Tuple

import numpy
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._rebuilt import Rebuilt
from ._triangulation import Triangulation

Boundary = Literal["neumann", "dirichlet", "averaged"]


class MeshHeatMethodDistanceSolver(Rebuilt):
    """Approximates the distance of each vertex from a set of sources, by the heat method.

    The matrices are factorized once; each set of sources then costs two or three solutions of linear systems. Several
    threads may share a solver; their calls wait for each other.

    Parameters
    ----------
    V : (n, 3) array of integers or floats
        The positions of the vertices.
    F : (m, 3) array of integers
        The corners of the triangles, counted from 0.
    t_coef : float
        The time for which heat spreads, in units of the squared mean edge length: the longer, the smoother.
    use_robust : bool
        True: work on the intrinsic Delaunay triangulation of the tufted cover, which takes any triangles and has no
        border. False: work on the triangles themselves, which must be an oriented manifold.
    boundary : {"neumann", "dirichlet", "averaged"}
        The condition at the border, without the cover: no heat leaves, the border is cold, or the mean of both.
    keeps_ridges : bool
        Whether to raise distances to the smallest values consistent with their neighbors. Otherwise the method rounds
        off ridges where fronts meet, as potpourri3d does.

    Raises
    ------
    InvalidSurfaceError
        If there is no face, an index is out of range, a coordinate is not finite, or, without the cover, the triangles
        are not an oriented manifold.
    NumericalError
        If a matrix cannot be factorized.
    """

    def __init__(self, V: ArrayLike, F: ArrayLike, t_coef: float = 1.0, use_robust: bool = True, *, boundary: Boundary = "neumann",
                 keeps_ridges: bool = True) -> None:
        points, faces = (array.copy() for array in _arrays.points_and_faces(V, F))
        options = _options(t_coef, boundary, keeps_ridges)
        self._remember(MeshHeatMethodDistanceSolver.__init__, points, faces, t_coef, use_robust, boundary=boundary,
                       keeps_ridges=keeps_ridges)
        self._number_of_vertices = len(points)
        self._surface = points, faces, bool(use_robust)
        if use_robust:
            self._heat = _core.heat_on_any_triangles(points, faces, *options)
        else:
            self._heat = _core.heat_on_surface(_core.Surface.from_points(points, faces), *options)

    @classmethod
    def from_triangulation(cls, triangulation: Triangulation, t_coef: float = 1.0, *, boundary: Boundary = "neumann",
                           keeps_ridges: bool = True) -> "MeshHeatMethodDistanceSolver":
        """Make a solver for a triangulation as it is now: flipped, refined, or given by lengths.

        Parameters
        ----------
        triangulation : Triangulation
            It should be Delaunay. Later flips do not affect the solver.
        t_coef, boundary, keeps_ridges
            As for the constructor.

        Raises
        ------
        InvalidSurfaceError, NumericalError
            If a length leaves the range of doubles, or a matrix cannot be factorized.
        """
        if not isinstance(triangulation, Triangulation):
            raise ValueError(f"triangulation has to be a Triangulation, not {type(triangulation).__name__}")
        result = cls.__new__(cls)
        result._begin(triangulation.copy(), t_coef, boundary, keeps_ridges)
        return result

    def _begin(self, triangulation: Triangulation, t_coef: float, boundary: Boundary, keeps_ridges: bool) -> None:
        self._remember(MeshHeatMethodDistanceSolver._begin, triangulation, t_coef, boundary, keeps_ridges)
        self._number_of_vertices = triangulation.number_of_vertices
        self._surface = None
        self._heat = _core.heat_on_surface(triangulation._surface, *_options(t_coef, boundary, keeps_ridges))

    def compute_distance(self, v_ind: int) -> numpy.ndarray:
        """Return the distance of each vertex from one source.

        Parameters
        ----------
        v_ind : int
            The source.

        Returns
        -------
        (n,) array
            In the unit of the input: exactly zero at the source, infinite where no source is connected.
        """
        source = _arrays.vertex(v_ind, "v_ind", self._number_of_vertices)
        return self._heat.distances(numpy.array([source], dtype=numpy.uint32))

    def compute_distance_multisource(self, v_inds: ArrayLike) -> numpy.ndarray:
        """Return the distance of each vertex from the nearest of several sources.

        Parameters
        ----------
        v_inds : (k,) array of integers
            The sources, at least one.

        Returns
        -------
        (n,) array
            As for `compute_distance`: exactly zero at each source.
        """
        return self._heat.distances(_arrays.sources(v_inds, self._number_of_vertices))

    def compute_distance_from(self, sources: Sequence[Any], offsets: Optional[ArrayLike] = None) -> numpy.ndarray:
        """Return the distance of each vertex from the nearest of several points, edges and curves.

        Parameters
        ----------
        sources, offsets
            As for `geodesic_distances_from`. The triangulation is made again to place them.

        Returns
        -------
        (n,) array
            As for `compute_distance`.

        Raises
        ------
        ValueError
            As `geodesic_distances_from`; also if the solver was made from a triangulation, or offsets differ so much that
            the heat of a source vanishes.
        """
        if self._surface is None:
            raise ValueError("a solver that was made from a triangulation takes vertices as sources only")
        points, faces, is_on_cover = self._surface
        return self._heat.distances_from(points, faces, is_on_cover, *_placed(points, faces, sources, offsets))

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
        vertices = _arrays.indices(v_inds, "v_inds", (None,), self._number_of_vertices)
        return self._heat.extend(vertices, _arrays.finite(values, "values", (len(vertices),)), 0.0)


def geodesic_distances(V: ArrayLike, F: ArrayLike, v_inds: ArrayLike, tolerance: float = 0.001) -> numpy.ndarray:
    """Return the length of the shortest path on the surface from the nearest source to each vertex.

    This takes any triangles, and follows straight lines over the intrinsic Delaunay triangulation. No distance exceeds
    the shortest path along edges or falls below the straight line through space. Parts without a source have no effect.

    Parameters
    ----------
    V, F
        As for `MeshHeatMethodDistanceSolver`.
    v_inds : integer, or (k,) array of integers
        The sources, at least one.
    tolerance : float
        How much each edge that a path crosses may change the length of the path, as a fraction of the length of the
        edge: at least 0, less than 1. With 0, distances are exact up to rounding, but take longer.

    Returns
    -------
    (n,) array
        In the unit of the input: exactly zero at each source, infinite where no source is connected.

    Raises
    ------
    InvalidSurfaceError
        As for `MeshHeatMethodDistanceSolver`.
    """
    points, faces = _arrays.points_and_faces(V, F)
    sources = _arrays.sources(v_inds, len(points))
    _arrays.warn_of_gaps(points, faces)
    return _core.geodesic_distances(points, faces, sources, _tolerance(tolerance))


def geodesic_distances_from(V: ArrayLike, F: ArrayLike, sources: Sequence[Any], tolerance: float = 0.001, *,
                            offsets: Optional[ArrayLike] = None,
                            barriers: Sequence[Any] = ()) -> Tuple[numpy.ndarray, numpy.ndarray]:
    """Return the length of the shortest path from the nearest of several points, edges and curves to each vertex.

    Paths leave a curve at right angles. With the tolerance 0, distances from curves are exact up to rounding, too.

    Parameters
    ----------
    V, F, tolerance
        As for `geodesic_distances`.
    sources : sequence, or a vertex
        At least one. An integer is a vertex, two integers are an edge, four numbers are a point: the number of a triangle, and
        barycentric coordinates, as `EdgeFlipGeodesicSolver.locate` finds them. A (k, 4) array is a curve through such points,
        each in the triangle of the one before, or on an edge or at a vertex of it.
    offsets : (number of sources,) array of floats
        The distances at the sources, not negative; 0 by default.
    barriers : sequence
        Edges and curves, given as sources, that no path crosses: they meet only at points that both have. Paths turn
        around their ends. A vertex on a barrier has the smaller distance of its sides. The triangles then have to form an
        oriented manifold.

    Returns
    -------
    distances : (n,) array
        In the unit of the input: infinite where no source is connected.
    nearest : (n,) array of integers
        The number of the nearest source; -1 where no source is connected.

    Raises
    ------
    InvalidSurfaceError
        As for `MeshHeatMethodDistanceSolver`.
    ValueError
        If there is no source, or one does not lie on the surface, an offset is negative, or barriers cross.
    """
    points, faces = _arrays.points_and_faces(V, F)
    placed = _placed(points, faces, sources, offsets, barriers)
    _arrays.warn_of_gaps(points, faces)
    return _core.geodesic_distances_from(points, faces, *placed, _tolerance(tolerance), len(barriers))


def farthest_vertices(V: ArrayLike, F: ArrayLike, number: int, v_inds: ArrayLike = (),
                      tolerance: float = 0.001) -> Tuple[numpy.ndarray, numpy.ndarray]:
    """Return vertices, each of which is as far as possible from the sources and from the ones before.

    Parameters
    ----------
    V, F, tolerance
        As for `geodesic_distances`.
    number : int
        How many vertices are wanted; there are fewer if all others have the distance 0.
    v_inds : (k,) array of integers
        The sources; none to begin with the first vertex.

    Returns
    -------
    vertices : (number,) array of integers
    distances : (number,) array
        From the sources and the vertices before; infinite if no path leads there.
    """
    points, faces = _arrays.points_and_faces(V, F)
    sources = _arrays.indices(v_inds, "v_inds", (None,), len(points))
    if not (isinstance(number, (int, numpy.integer)) and 0 <= number < 2**32):
        raise ValueError(f"number has to be a whole number that is not negative, not {number!r}")
    _arrays.warn_of_gaps(points, faces)
    return _core.farthest_vertices(points, faces, sources, int(number), _tolerance(tolerance))


def geodesic_distance_matrix(V: ArrayLike, F: ArrayLike, sources: ArrayLike, targets: ArrayLike,
                             tolerance: float = 0.001) -> numpy.ndarray:
    """Return the length of the shortest path from each source to each target, on several cores.

    The numbers are those of `geodesic_distances` from each source alone. Only what is nearer than the farthest target is
    visited.

    Parameters
    ----------
    V, F, tolerance
        As for `geodesic_distances`.
    sources, targets : (k,) and (m,) arrays of integers
        Vertices.

    Returns
    -------
    (k, m) array
        Infinite where no path leads.
    """
    points, faces = _arrays.points_and_faces(V, F)
    rows = _arrays.indices(sources, "sources", (None,), len(points))
    columns = _arrays.indices(targets, "targets", (None,), len(points))
    _arrays.warn_of_gaps(points, faces)
    return _core.geodesic_distance_matrix(points, faces, rows, columns, _tolerance(tolerance)).reshape(len(rows), len(columns))


def compute_distance(V: ArrayLike, F: ArrayLike, v_ind: int) -> numpy.ndarray:
    """Construct a `MeshHeatMethodDistanceSolver` and return its `compute_distance`."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance(v_ind)


def compute_distance_multisource(V: ArrayLike, F: ArrayLike, v_inds: ArrayLike) -> numpy.ndarray:
    """Construct a `MeshHeatMethodDistanceSolver` and return its `compute_distance_multisource`."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance_multisource(v_inds)


def _tolerance(tolerance: Any) -> float:
    if not (isinstance(tolerance, (int, float, numpy.integer, numpy.floating)) and 0 <= tolerance < 1):
        raise ValueError(f"tolerance has to be at least 0 and below 1, not {tolerance!r}")
    return float(tolerance)


def _placed(points: numpy.ndarray, faces: numpy.ndarray, sources: Sequence[Any], offsets: Optional[ArrayLike],
            barriers: Sequence[Any] = ()) -> tuple:
    """Return the triangles and coordinates of all points of sources and barriers, where each begins, and the offsets."""
    if isinstance(sources, Integral):  # as geodesic_distances() takes one
        sources = [sources]
    places = [_arrays.places(source, f"sources[{i}]", faces, len(points)) for i, source in enumerate(sources)]
    _arrays.require_sources(len(places), "sources")
    starts = numpy.zeros(len(places)) if offsets is None else _arrays.finite(offsets, "offsets", (len(places),))
    places += [_arrays.places(barrier, f"barriers[{i}]", faces, len(points)) for i, barrier in enumerate(barriers)]
    first = numpy.cumsum([0] + [len(p) for p in places]).astype(numpy.uint32)
    return (*_arrays.numbers_and_coordinates(places), first, starts)


def _options(t_coef: Any, boundary: Any, keeps_ridges: Any) -> tuple:
    return _arrays.positive(t_coef, "t_coef"), _arrays.choice(boundary, "boundary", Boundary), bool(keeps_ridges)
