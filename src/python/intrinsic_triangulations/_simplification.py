# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Simplified surfaces, and distances by way of them.

"""Simplified surfaces, and distances by way of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Dict, NamedTuple, Optional, Tuple

import numpy
import scipy.sparse
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._documented import documented
from ._errors import InvalidArgumentError
from ._rebuilt import Rebuilt

if TYPE_CHECKING:
    from ._triangulation import Triangulation


@documented
class SimplifiedSurface(NamedTuple):
    """The result of `Triangulation.simplify`: a surface with fewer vertices, and its relation to the given one.

    With the map φ from one to the other, `shrink * d(p, q) <= d'(φp, φq) <= stretch * d(p, q)` for all points p and q.
    This is proven, rounding included.
    """

    triangulation: "Triangulation"
    """The surface, given by lengths alone, with a Delaunay triangulation."""
    kept: numpy.ndarray
    """(c,) array of int64: the given vertex that each of its vertices is."""
    places: Tuple[numpy.ndarray, numpy.ndarray]
    """(n,) array of input faces of `triangulation`, and (n, 3) array of coordinates there: where the given vertices lie.
    The face of an isolated vertex is -1."""
    shrink: float
    """How much distances may have become shorter."""
    stretch: float
    """How much distances may have become longer."""
    prolongation: scipy.sparse.csc_matrix
    """(n, c) matrix: carries values at its vertices to the given vertices, linearly. Rows sum to 1, but those of isolated vertices
    are empty."""
    reasons: Dict[str, int]
    """How many vertices were kept: `by_bound`, as the bound allows no less; `by_request`; `as_corners` of the border or of a line;
    `for_gluing`, with a loop or fewer than three faces; `by_number`, as so many were asked for; `isolated`."""

    def prolongation_from(self, triangulation: "Triangulation") -> scipy.sparse.csc_matrix:
        """Find the same matrix for a refined triangulation of the simplified surface.

        Parameters
        ----------
        triangulation : Triangulation
            The member `triangulation` after `refine()`, or a copy of it.

        Returns
        -------
        (n, c') scipy.sparse.csc_matrix
            It carries values at the c' vertices of that triangulation to the given vertices, linearly. The row of an isolated
            vertex is empty, and so is the column of a vertex near which there is no given vertex.

        Raises
        ------
        InvalidArgumentError
            If the input of the triangulation has another number of vertices than the simplified surface.
        """
        faces, coordinates = self.places
        rows = numpy.flatnonzero(faces >= 0)
        subdivision = triangulation.common_subdivision()
        if subdivision.number_of_input_vertices != len(self.kept):
            raise InvalidArgumentError(
                f"the input of the triangulation has {subdivision.number_of_input_vertices} vertices, where the simplified "
                f"surface has {len(self.kept)}: give its member `triangulation`, or a copy, refined or not")
        at, weights = subdivision.to_intrinsic(faces[rows], coordinates[rows])
        entries = weights.ravel(), (numpy.repeat(rows, 3), triangulation.faces[at].ravel())
        return scipy.sparse.csc_matrix(entries, shape=(len(faces), triangulation.number_of_vertices))


@documented
class DistanceIntervals(NamedTuple):
    """The result of `SimplifiedDistances.distances`, in the unit of the input; infinite where no source is connected."""

    distances: numpy.ndarray
    """(n,) array: the distances on the simplified surface."""
    lower: numpy.ndarray
    """(n,) array: distances on the surface itself are not shorter."""
    upper: numpy.ndarray
    """(n,) array: and not longer."""


class SimplifiedDistances(Rebuilt):
    """Distances between the vertices of a surface, within a few percent, in a fraction of the time.

    The surface is simplified once; exact distances on the simplified surface follow, with intervals that contain those on the
    surface itself, up to rounding. Several threads may ask one object at once. It is pickled as its arguments.

    Parameters
    ----------
    V : (n, 3) array of integers or floats
        The positions of the vertices.
    F : (m, 3) array of integers
        The corners of the triangles, counted from 0: an oriented manifold, with or without border.
    maximum_change : float, optional
        By which part a distance may change. Default: 0.05.

    Raises
    ------
    InvalidSurfaceError
        As for `Triangulation`.
    InvalidArgumentError
        If `maximum_change` is negative.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> d = it.SimplifiedDistances([[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]], [[0, 1, 2], [1, 0, 3]])
    >>> found = d.distances(2)
    >>> bool(found.lower[3] <= 2 <= found.upper[3])
    True
    """

    def __init__(self, V: ArrayLike, F: ArrayLike, maximum_change: Optional[float] = None) -> None:
        points, faces = _arrays.points_and_faces(V, F)
        change = None if maximum_change is None else _arrays.number(maximum_change, "maximum_change")
        self._remember(SimplifiedDistances.__init__, numpy.array(points), numpy.array(faces), change)
        self._distances = _core.SimplifiedDistances(points, faces, change)
        self._number_of_vertices = len(points)

    def distances(self, v_inds: ArrayLike) -> DistanceIntervals:
        """Return the distance of each vertex from the nearest source.

        Parameters
        ----------
        v_inds : integer, or (k,) array of integers
            The sources, at least one.

        Returns
        -------
        DistanceIntervals
        """
        return DistanceIntervals(*self._distances.distances(_arrays.sources(v_inds, self._number_of_vertices)))
