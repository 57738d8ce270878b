# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Lines at a distance, and the borders of cells.

"""Lines at a distance from vertices, points and curves, and the lines where the nearest of them changes."""

from __future__ import annotations

from typing import Any, List, NamedTuple, Optional, Sequence, Tuple

import numpy
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._documented import documented
from ._heat import _placed, _tolerance, geodesic_distances_from


@documented
class SurfaceLine(NamedTuple):
    """A line on a surface in space. A closed one ends where it begins."""

    positions: numpy.ndarray
    """(k, 3) array: its points, in the unit of the input."""
    faces: numpy.ndarray
    """(k,) array of int64: a face of each point, which contains the next one, too."""
    coordinates: numpy.ndarray
    """(k, 3) array: the barycentric coordinates of each point in its face."""
    distance: float
    """From the sources; 0 for a border."""
    sources: Tuple[int, int]
    """The nearest sources on the left and on the right of a border; zeros for an isoline."""

    @property
    def places(self) -> numpy.ndarray:
        """(k, 4) array: the line as a source of `geodesic_distances_from`."""
        return numpy.column_stack([self.faces, self.coordinates])


def isolines(V: ArrayLike, F: ArrayLike, sources: Sequence[Any], distances: ArrayLike, tolerance: float = 0.001, *,
             chord_tolerance: Optional[float] = None, offsets: Optional[ArrayLike] = None) -> List[SurfaceLine]:
    """Return the lines whose points have a given distance from the nearest source.

    Smaller distances lie to their left. Lines are closed, or end on the border.

    Parameters
    ----------
    V, F
        An oriented surface, as for `EdgeFlipGeodesicSolver`.
    sources, tolerance, offsets
        As for `geodesic_distances_from`. With the tolerance 0, points have their distance up to rounding.
    distances : (m,) array of floats
        Positive numbers.
    chord_tolerance : float
        By how much the distance at a point between those of a line may differ, in the unit of the input; by default a
        ten-thousandth of the largest of the distances.

    Returns
    -------
    list of SurfaceLine
        In the order of their distances.

    Raises
    ------
    InvalidSurfaceError
        As for `EdgeFlipGeodesicSolver`.
    InvalidArgumentError
        If a distance is not positive, or more than about a million points, and ten for each vertex, are needed; the
        message says what would do.
    ValueError
        As for `geodesic_distances_from`.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> V, F = [[0, 0, 0], [2, 0, 0], [0, 2, 0]], [[0, 1, 2]]
    >>> line, = it.isolines(V, F, [[0, 1]], [0.5])
    >>> line.distance, line.positions[[0, -1]]
    (0.5, array([[1.5, 0.5, 0. ],
           [0. , 0.5, 0. ]]))
    """
    return _lines(V, F, sources, offsets, 0, distances, tolerance, chord_tolerance)


def offset_curves(V: ArrayLike, F: ArrayLike, curve: ArrayLike, distances: ArrayLike, tolerance: float = 0.001, *,
                  chord_tolerance: Optional[float] = None) -> List[SurfaceLine]:
    """Return the lines at a distance from a curve on one of its sides.

    Parameters
    ----------
    V, F, tolerance, chord_tolerance
        As for `isolines`.
    curve : (k, 4) array, or list of such arrays
        As a source of `geodesic_distances_from`. It is closed, or leads from border to border, and cuts something off;
        several curves do so together.
    distances : (m,) array of floats
        Positive to the left of the curve, negative to its right.

    Returns
    -------
    list of SurfaceLine

    Raises
    ------
    InvalidArgumentError
        If the curve does not separate its sides, or a distance is 0.
    """
    return _lines(V, F, _parts(curve), None, 1, distances, tolerance, chord_tolerance)


def _parts(curve: Any) -> Sequence[Any]:
    return curve if len(curve) > 0 and numpy.ndim(curve[0]) == 2 else [curve]


def sides_of_curve(V: ArrayLike, F: ArrayLike, curve: ArrayLike) -> numpy.ndarray:
    """Return for each vertex whether it lies to the left of a curve, or to its right.

    Parameters
    ----------
    V, F, curve
        As for `offset_curves`.

    Returns
    -------
    (n,) array of int64
        1 to the left, -1 to the right, 0 on the curve.

    Raises
    ------
    InvalidArgumentError
        If the curve does not separate its sides; of several, the message names those at fault.
    ValueError
        If its segments cross, or do not lie on the surface.
    """
    points, faces = _arrays.points_and_faces(V, F)
    return _core.sides_of_curve(points, faces, *_placed(points, faces, _parts(curve), None))


def signed_distances(V: ArrayLike, F: ArrayLike, curve: ArrayLike, tolerance: float = 0.001) -> numpy.ndarray:
    """Return the distance of each vertex from a curve: negative to its right.

    Parameters
    ----------
    V, F, curve, tolerance
        As for `offset_curves`.

    Returns
    -------
    (n,) array of floats

    Raises
    ------
    InvalidArgumentError, ValueError
        As for `sides_of_curve`.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> V, F = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]]
    >>> it.signed_distances(V, F, [[0, 1, 0, 0], [0, 0, 0, 1]], 0).round(3)
    array([ 0.   , -1.414,  0.   ,  1.414])
    """
    sides = sides_of_curve(V, F, curve)
    distances, _ = geodesic_distances_from(V, F, _parts(curve), tolerance)
    return numpy.where(sides < 0, -distances, distances)


def borders_of_cells(V: ArrayLike, F: ArrayLike, sources: Sequence[Any], tolerance: float = 0.001, *,
                     chord_tolerance: Optional[float] = None, offsets: Optional[ArrayLike] = None) -> List[SurfaceLine]:
    """Return the lines where the nearest source changes: the borders of the geodesic Voronoi cells.

    A line is closed, or ends on the border or where three cells meet.

    Parameters
    ----------
    V, F, sources, tolerance, chord_tolerance, offsets
        As for `isolines`. Here the distances from both sources may differ by the chord tolerance; by default, it is a
        ten-thousandth of the largest distance of a vertex.

    Returns
    -------
    list of SurfaceLine
    """
    return _lines(V, F, sources, offsets, 2, [], tolerance, chord_tolerance)


def _lines(V: ArrayLike, F: ArrayLike, sources: Sequence[Any], offsets: Optional[ArrayLike], kind: int,
           distances: ArrayLike, tolerance: float, chord_tolerance: Optional[float]) -> List[SurfaceLine]:
    points, faces = _arrays.points_and_faces(V, F)
    placed = _placed(points, faces, sources, offsets)
    levels = _arrays.finite(distances, "distances", (None,))
    chord = numpy.inf if chord_tolerance is None else _arrays.positive(chord_tolerance, "chord_tolerance")
    positions, (numbers, coordinates), ends, of_lines, pairs = _core.surface_lines(
        points, faces, *placed, kind, levels, _tolerance(tolerance), chord)
    return [SurfaceLine(positions[i:k], numbers[i:k], coordinates[i:k], float(d), (int(a), int(b)))
            for i, k, d, (a, b) in zip([0, *ends[:-1]], ends, of_lines, pairs.reshape(-1, 2))]
