# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# A triangulation of a surface by straight lines on it.

"""A triangulation of a surface by straight lines on it."""

from __future__ import annotations

import copy
import math
import os
from typing import Any, Dict, Literal, Mapping, NamedTuple, Optional, Tuple, Union

import numpy
import scipy.sparse
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._conformal import Boundary, ConformalMap, conformal_map
from ._documented import documented
from ._errors import InvalidArgumentError, reading, writing
from ._laplacian import Mass
from ._simplification import SimplifiedSurface
from ._subdivision import CommonSubdivision


@documented
class FlipReport(NamedTuple):
    """The result of `Triangulation.flip_to_delaunay`."""

    is_delaunay: bool
    """Whether every edge that is not constrained is Delaunay; False if `max_flips` did not suffice."""
    flips: int
    """The number of flips."""
    tests: int
    """The number of Delaunay tests."""


@documented
class VerificationReport(NamedTuple):
    """The result of `Triangulation.verify`."""

    is_delaunay: bool
    """Whether all edges are Delaunay, and all faces are triangles with the right orientation."""
    tests: int
    """The number of edges tested."""
    ties: int
    """The number of edges whose opposite angles sum to exactly π."""
    not_delaunay: numpy.ndarray
    """The numbers of the edges whose opposite angles sum to more than π."""
    inverted: numpy.ndarray
    """The numbers of the faces with the wrong orientation; always empty."""


@documented
class RefinementReport(NamedTuple):
    """The result of `Triangulation.refine`."""

    is_refined: bool
    """Whether all faces meet the criteria."""
    insertions: int
    """The number of vertices inserted into faces."""
    segment_splits: int
    """The number of vertices inserted on edges."""
    flips: int
    """The number of flips."""
    unrefined: numpy.ndarray
    """The numbers of the faces that do not meet the criteria."""
    reasons: numpy.ndarray
    """(u,) array of int8: the reason for each of them, as its position among the keys of `number_by_reason`."""
    number_by_reason: Dict[str, int]
    """How many there are: "cone", "small_input_angle", "beside_small_input_angle", "unrepresentable", "too_small",
    "whole_edge", "budget"."""
    minimum_size: float
    """The smallest size, given or chosen."""
    is_finished: bool
    """Whether no more vertices would help; False if `max_insertions` did not suffice."""


@documented
class StraightMesh(NamedTuple):
    """The result of `Triangulation.straight_mesh`: another surface, of which nothing is known but what stands here."""

    points: numpy.ndarray
    """(n, 3) array: the positions of the vertices."""
    points_of_vertices: numpy.ndarray
    """(v,) array of int64: the point of each vertex of the triangulation, the same in number unless vertices are merged."""
    merged_vertices: numpy.ndarray
    """The numbers of the vertices that have the point of another one."""
    triangles: numpy.ndarray
    """(t, 3) array of int64: the faces with three different corners, in order."""
    faces: numpy.ndarray
    """(t,) array of int64: the face of the triangulation that each triangle is."""
    input_faces: numpy.ndarray
    """(t,) array of int64: the face of the input that covers most of each triangle."""
    regions: numpy.ndarray
    """(t,) array of int64: the number of the region of each triangle. Marked edges separate regions."""
    marked_edges: numpy.ndarray
    """(e, 2) array of int64: the ends of the marked edges and of those of the border."""
    lines: numpy.ndarray
    """(e,) array of int64: the number of the line of each of them: connected edges with the same regions beside them."""
    deviation: float
    """No point of either surface is farther than this from the other one: proven, rounding included."""
    deviation_place: numpy.ndarray
    """(3,) array: where on the surface that distance is attained, nearly."""
    minimum_angle: float
    """The smallest angle of the triangles, in degrees."""
    thin_triangles: numpy.ndarray
    """The numbers of the triangles with an angle below `thin_angle`; first those that are not at sharp corners."""
    sharp_corners: int
    """How many of them have it between two marked edges, where every mesh has that angle."""
    sufficient_deviation: float
    """A larger maximum deviation with which the triangles are good, as was tried; 0 if they are, or there is none."""
    loops: numpy.ndarray
    """The edges of the triangulation whose ends are the same. Two points more make a triangle of each."""
    multiple_edges: numpy.ndarray
    """The edges of the triangulation that have both ends in common with one before."""
    is_surface: bool
    """Whether the triangles are a manifold, without other holes than the surface has and without doubled triangles."""
    message: str
    """What makes them no surface, in words."""
    removed_pieces: int
    """How many connected pieces were left out that lie along others."""
    rods: int
    """How many pieces without thickness lie along nothing, and became rods that are as thick as the deviation allows."""
    new_components: int
    """How many components there are more than the surface has, as thin parts between them vanished."""
    crossing_triangles: numpy.ndarray
    """With maximum_deviation, the pairs of triangles that have more in common than their common corners and edges."""


class Triangulation:
    """A triangulation of a surface in space, or of one given by lengths.

    Edges are straight lines on the surface: flips change the triangulation, but not the surface. Every decision is
    exact for the given numbers. A face may have the same vertex at several corners, and several edges may join the same
    two vertices, so edges and faces are identified by their numbers, which flips do not change.

    Several threads may share a triangulation; their calls wait for each other.

    Parameters
    ----------
    V : (n, 3) array of integers or floats
        The positions of the vertices.
    F : (m, 3) array of integers
        The corners of the triangles, counted from 0: an oriented manifold, with or without border.

    Raises
    ------
    InvalidSurfaceError
        If the triangles are not an oriented manifold, an edge has length zero, or a coordinate is not finite.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> t = it.Triangulation([[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]], [[0, 1, 2], [1, 0, 3]])
    >>> t.flip_to_delaunay().flips
    1
    >>> t.edges[0].tolist(), float(t.lengths[0])
    ([3, 2], 2.0)
    """

    def __init__(self, V: ArrayLike, F: ArrayLike) -> None:
        points, faces = _arrays.points_and_faces(V, F)
        # Kept for positions: a copy, which callers cannot change.
        self._points: Optional[numpy.ndarray] = numpy.array(points)
        self._points.flags.writeable = False
        self._surface = _core.Surface.from_points(points, faces)

    @classmethod
    def from_lengths(cls, F: ArrayLike, lengths: ArrayLike) -> "Triangulation":
        """Make a triangulation from triangles and the lengths of their sides.

        Parameters
        ----------
        F : (m, 3) array of integers
            The corners of the triangles.
        lengths : (m, 3) array of integers or floats
            The length of side i of each triangle, from corner i to corner i + 1. Both sides at an edge have the same
            length.

        Raises
        ------
        InvalidSurfaceError
            If the triangles are not an oriented manifold, a length is not positive and finite, the two sides at an edge
            have different lengths, or three lengths violate the triangle inequality. Equality is accepted.
        """
        faces = _arrays.indices(F, "F", (None, 3))
        sides = _arrays.doubles(lengths, "lengths", (len(faces), 3))
        number = int(faces.max()) + 1 if faces.size else 0
        # Otherwise a single face could allocate any amount of memory.
        if number > 3 * len(faces):
            raise ValueError(f"F names vertex {number - 1}, but {len(faces)} triangles have at most {3 * len(faces)} vertices")
        return cls._of(_core.Surface.from_lengths(faces, sides, number))

    @classmethod
    def from_gluing(cls, glued_sides: ArrayLike, lengths: ArrayLike) -> "Triangulation":
        """Make a triangulation from triangles glued in any way, even a triangle to itself.

        Parameters
        ----------
        glued_sides : (k, 2) array of integers
            Pairs of sides. Side `3 f + i` runs from corner i of triangle f to corner i + 1; glued sides run in opposite
            directions. The other sides form the border.
        lengths : (m, 3) array of integers or floats
            As for `from_lengths`.

        Raises
        ------
        InvalidSurfaceError
            If a side is glued twice or to itself, or as `from_lengths`.

        Examples
        --------
        A flat torus with one vertex, made of two right triangles:

        >>> import intrinsic_triangulations as it
        >>> t = it.Triangulation.from_gluing([[0, 3], [1, 4], [2, 5]], [[3, 4, 5], [3, 4, 5]])
        >>> t.number_of_vertices, t.number_of_edges, t.verify().ties
        (1, 3, 1)
        """
        sides = _arrays.doubles(lengths, "lengths", (None, 3))
        pairs = _arrays.as_array(glued_sides, "glued_sides", "iu", "integers")
        if pairs.size == 0:
            pairs = numpy.zeros((0, 2), dtype=numpy.int64)
        pairs = _arrays.indices(pairs, "glued_sides", (None, 2), 3 * len(sides), "side")
        return cls._of(_core.Surface.from_gluing(pairs[:, 0], pairs[:, 1], sides))

    @classmethod
    def _of(cls, surface: Any, points: Optional[numpy.ndarray] = None) -> "Triangulation":
        result = cls.__new__(cls)
        result._points = points
        result._surface = surface
        return result

    def copy(self) -> "Triangulation":
        """Return an independent copy, of the same class. O(size)."""
        result = type(self).__new__(type(self))
        result.__dict__.update(self.__dict__)
        result._surface = self._surface.copy()
        return result

    __copy__ = copy

    def __deepcopy__(self, memo: Any) -> "Triangulation":
        result = self.copy()
        memo[id(self)] = result
        own = ("_surface", "_points")
        result.__dict__.update({name: copy.deepcopy(value, memo) for name, value in self.__dict__.items() if name not in own})
        return result

    def __setstate__(self, state: Any) -> None:
        self.__dict__.update(state)
        if self._points is not None:
            self._points.flags.writeable = False

    def show(self, values: Any = None) -> Any:
        """Show the input and this triangulation, in the notebook or in a browser.

        The command `idt view`, which has to be installed, writes the page.

        Parameters
        ----------
        values : (n,) array, or a dictionary of named ones, or None
            Numbers at the input vertices, which color the surface; or on the input faces, unless vertices were inserted. What is NaN or
            masked is gray.

        Returns
        -------
        Page
            The page, which you can save.

        Raises
        ------
        ValueError
            If the surface is given by lengths alone.
        Error
            If the command is not found; the environment variable IDT_COMMAND can name it.
        """
        from ._view import page_of
        page = page_of(self, values)
        try:
            is_notebook = get_ipython().has_trait("kernel")  # type: ignore[name-defined]
        except NameError:
            is_notebook = False
        if not is_notebook:
            page.open()
        return page

    def save(self, path: Union[str, os.PathLike]) -> None:
        """Write the triangulation and its input to a file from which `load` restores it exactly.

        The file is a binary PLY file of the input with additional elements; `pickle` writes the same bytes. O(size).

        Parameters
        ----------
        path : str or os.PathLike
            The name of the file, which ends with `.idt`. For a mesh in space, give points and triangles of
            `common_subdivision().mesh()` to `write_mesh`.

        Raises
        ------
        InvalidArgumentError
            If the name does not end with `.idt`.
        FileError
            If the file cannot be written. It is an `OSError`.
        UndecidedError
            If an edge crosses more than 2**20 input edges.

        Examples
        --------
        >>> import intrinsic_triangulations as it, os, tempfile
        >>> t = it.Triangulation([[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]], [[0, 1, 2], [1, 0, 3]])
        >>> t.flip_to_delaunay().flips
        1
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     t.save(os.path.join(folder, "kite.idt"))
        ...     it.Triangulation.load(os.path.join(folder, "kite.idt")).lengths.tolist() == t.lengths.tolist()
        True
        """
        name = os.fspath(path)
        if os.path.splitext(os.fsdecode(name))[1].lower() != ".idt":
            raise InvalidArgumentError(f"path has to end with .idt, not {name!r}: a saved triangulation is no mesh in space; to write "
                                       "one, give points and triangles of common_subdivision().mesh() to write_mesh()")
        with writing(name):
            self._surface.save(name)

    @classmethod
    def load(cls, path: Union[str, os.PathLike]) -> "Triangulation":
        """Read a triangulation that `save` or the command has written.

        Everything in the file is checked exactly, so the result is always a triangulation of the input in the file.
        O(size + number of crossings).

        Parameters
        ----------
        path : str or os.PathLike
            The name of the file.

        Raises
        ------
        InvalidFileError
            If the file does not contain a triangulation. The message names the byte or element at fault. It is an
            `OSError`, and a `FileNotFoundError` if there is no such file.
        """
        with reading(os.fspath(path)):
            surface = _core.Surface.load(os.fspath(path))
        points = surface.input_points()
        if len(points) == 0:
            return cls._of(surface)
        points.flags.writeable = False
        return cls._of(surface, points)

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

    def flip_to_delaunay(self, max_flips: Optional[int] = None, constrained: Optional[ArrayLike] = None) -> FlipReport:
        """Flip edges until the triangulation is Delaunay. Every decision is exact.

        Parameters
        ----------
        max_flips : int, optional
            The number of flips after which to give up. The algorithm ends without it, too: that is proven.
        constrained : (k,) array of bool, optional
            The edges that must not be flipped.

        Returns
        -------
        FlipReport

        Raises
        ------
        UndecidedError
            If an edge crosses more than 2**20 input edges. The triangulation stays valid.
        """
        maximum = 2**64 - 1 if max_flips is None else _arrays.integer(max_flips, "max_flips")
        return FlipReport(*self._surface.flip_to_delaunay(self._constrained(constrained), maximum))

    def verify(self, constrained: Optional[ArrayLike] = None) -> VerificationReport:
        """Decide for every edge, exactly and from the input alone, whether it is Delaunay.

        Parameters
        ----------
        constrained : (k,) array of bool, optional
            The edges to leave out.

        Returns
        -------
        VerificationReport

        Raises
        ------
        UndecidedError
            If an edge crosses more than 2**20 input edges.
        """
        return VerificationReport(*self._surface.verify(self._constrained(constrained)))

    def refine(self, minimum_angle: float = 25, maximum_circumradius: float = math.inf, maximum_edge_length: float = math.inf,
               constrained: Optional[ArrayLike] = None, max_insertions: Optional[int] = None, minimum_size: Optional[float] = None,
               sharp_edge_angle: Optional[float] = None, maximum_deviation: float = math.inf,
               whole: Union[None, Literal["border"], ArrayLike] = None, sizes: Optional[ArrayLike] = None,
               maximum_normal_angle: Optional[float] = None, size_gradation: float = 0.3) -> RefinementReport:
        """Flip edges and insert vertices until no face is too thin or too large. The surface does not change.

        Parameters
        ----------
        minimum_angle : float
            The smallest angle allowed, in degrees, from 0 to 30.
        maximum_circumradius, maximum_edge_length : float
            The largest circumradius and edge length allowed, in the unit of the input.
        constrained : (k,) array of bool, optional
            Edges that must not be flipped, but may be split. They must be input edges that were not flipped.
        max_insertions : int, optional
            The maximum number of new vertices. Default: ten for each vertex, and a million; then refinement does not
            begin if lengths of edges need more, judged by areas.
        minimum_size : float, optional
            No vertex is inserted for a face with a side or a height shorter than this, in the unit of the input.
            Default: 0, or up to 2**-14 of the bounding box if smaller faces need many vertices; the report has it.
        sharp_edge_angle : float, optional
            Edges of the input at which the directions of the faces differ by more than this angle in degrees are not
            flipped, either: the `sharp_edges` for the smallest size.
        maximum_deviation : float
            How far the triangles of `straight_mesh` may be from the surface, in the unit of the input. Folds are kept
            that few triangles could follow otherwise.
        whole : (k,) array of bool, or "border", optional
            Edges that must neither be flipped nor split, or those of the border. Faces that would need a vertex there
            are listed.
        sizes : (n,) array, optional
            How long edges may be at each vertex of the input, or infinity. An edge may be as long as the mean of the sizes
            at its ends, which are linear on the faces of the input.
        maximum_normal_angle : float, optional
            Edges may be as long as the way on which the normal of the surface turns by this angle in degrees. Edges that
            are not flipped, or sharper than `sharp_edge_angle`, do not count.
        size_gradation : float
            By which part of a length these sizes may grow along it; larger ones are lowered.

        Returns
        -------
        RefinementReport

        Raises
        ------
        ValueError
            If a criterion is out of range, or far too many vertices would be needed.
        UndecidedError
            As `flip_to_delaunay`.

        Examples
        --------
        >>> import numpy
        >>> import intrinsic_triangulations as it
        >>> t = it.Triangulation([[0, 0, 0], [10, 0, 0], [10, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> report = t.refine(minimum_angle=25)
        >>> report.is_refined, bool(numpy.degrees(t.angles).min() >= 25)
        (True, True)
        """
        angle = _arrays.number(minimum_angle, "minimum_angle")
        circumradius = _arrays.number(maximum_circumradius, "maximum_circumradius")
        edge_length = _arrays.number(maximum_edge_length, "maximum_edge_length")
        maximum = None if max_insertions is None else _arrays.integer(max_insertions, "max_insertions")
        size = None if minimum_size is None else _arrays.number(minimum_size, "minimum_size")
        sharp = None if sharp_edge_angle is None else _arrays.number(sharp_edge_angle, "sharp_edge_angle")
        deviation = _arrays.number(maximum_deviation, "maximum_deviation")
        marks = _arrays.marks(self._border() if isinstance(whole, str) and whole == "border" else whole, "whole", self.number_of_edges)
        given = None if sizes is None else _arrays.doubles(sizes, "sizes", (None,))
        normal = None if maximum_normal_angle is None else _arrays.number(maximum_normal_angle, "maximum_normal_angle")
        return RefinementReport(*self._surface.refine(angle, circumradius, edge_length, self._constrained(constrained), maximum, deviation, size, sharp,
                                                      marks, given, normal, _arrays.number(size_gradation, "size_gradation")))

    def simplify(self, maximum_change: Optional[float] = None, number_of_vertices: int = 0, kept: Optional[ArrayLike] = None,
                 constrained: Optional[ArrayLike] = None, sharp_angle: float = 180) -> SimplifiedSurface:
        """Remove vertices as long as it is proven that no distance changes by more than a given part.

        **The result is another surface**: this method, and no other, changes lengths; by how much is a part of the result.
        The triangulation itself is flipped to Delaunay first, which does not change its surface. O(n log n).

        Parameters
        ----------
        maximum_change : float, optional
            By which part c a distance may change: `1/(1 + c) <= shrink` and `stretch <= 1 + c`, where rounding takes up to
            1e-12. Default: 0.05, and no limit if `number_of_vertices` is given.
        number_of_vertices : int
            No more vertices are removed when so many are left. Default: 0, which is not given.
        kept : (n,) array of bool, optional
            The vertices to keep.
        constrained : (k,) array of bool, optional
            The edges that become parts of straight edges of the result.
        sharp_angle : float
            The same for edges of the input whose faces have directions that differ by more, in degrees. Default: none.

        Returns
        -------
        SimplifiedSurface

        Raises
        ------
        InvalidArgumentError
            If an argument is out of range, or the surface is given by lengths alone and has no sharp edges.
        UndecidedError
            As `flip_to_delaunay`.

        Examples
        --------
        >>> import numpy
        >>> import intrinsic_triangulations as it
        >>> x, y = numpy.meshgrid(numpy.arange(9), numpy.arange(9))
        >>> V = numpy.stack([x.ravel(), y.ravel(), 0.3 * numpy.sin(x.ravel())], axis=1)
        >>> i = numpy.arange(81).reshape(9, 9)
        >>> a, b, c, d = (k.ravel() for k in (i[:-1, :-1], i[:-1, 1:], i[1:, 1:], i[1:, :-1]))
        >>> t = it.Triangulation(V, numpy.concatenate([numpy.stack([a, b, c], axis=1), numpy.stack([a, c, d], axis=1)]))
        >>> s = t.simplify(maximum_change=0.05)          # a rolled sheet keeps its four corners
        >>> s.triangulation.number_of_vertices, abs(s.stretch - 1) < 1e-12, sorted(s.kept.tolist())
        (4, True, [0, 8, 72, 80])
        """
        change = None if maximum_change is None else _arrays.number(maximum_change, "maximum_change")
        marks = [_arrays.marks(given, name, n) for given, name, n in
                 ((kept, "kept", self.number_of_vertices), (constrained, "constrained", self.number_of_edges))]
        surface, vertices, faces, coordinates, shrink, stretch, prolongation, reasons = _core.simplify(
            self._surface, change, _arrays.integer(number_of_vertices, "number_of_vertices"),
            *(None if given is None else given.tolist() for given in marks), _arrays.number(sharp_angle, "sharp_angle"))
        return SimplifiedSurface(type(self)._of(surface), vertices, (faces, coordinates), shrink, stretch,
                                 _arrays.sparse(prolongation), reasons)

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

    def straight_mesh(self, marked: Optional[ArrayLike] = None, thin_angle: float = 10, maximum_deviation: float = 0,
                      fixed: Optional[ArrayLike] = None) -> StraightMesh:
        """Return the faces as straight triangles in space, for programs that know no others.

        That is another surface. `refine` with `maximum_deviation` brings the two close to each other. With the same
        distance, vertices are merged here where that makes thin triangles better or removes a sheet of no thickness.

        Parameters
        ----------
        marked : (k,) array of bool, optional
            The edges of the input, as `sharp_edges` returns them, whose parts separate regions. Pass those that
            `refine` has kept, for no other edge of the input stays an edge for sure.
        thin_angle : float
            Triangles with a smaller angle, in degrees, are listed.
        maximum_deviation : float
            The distance from the surface up to which vertices may be merged; 0 if none may.
        fixed : (n,) array of bool, optional
            The vertices of the input that must not be merged with others, such as the ends of edges that stay whole.

        Returns
        -------
        StraightMesh

        Raises
        ------
        ValueError
            If the surface is given by lengths alone, or there is not one mark for each edge of the input.

        Examples
        --------
        >>> import intrinsic_triangulations as it
        >>> t = it.Triangulation([[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]], [[0, 1, 2], [1, 0, 3]])
        >>> sharp = t.sharp_edges(30)
        >>> t.refine(25, constrained=sharp).is_refined
        True
        >>> mesh = t.straight_mesh(sharp)
        >>> mesh.is_surface, mesh.deviation < 1e-13, int(mesh.regions.max()) + 1, int(mesh.lines.max()) + 1
        (True, True, 2, 3)
        """
        if self._points is None:
            raise ValueError("the surface is given by lengths: its triangles are not in space")
        subdivision = _core.subdivision(self._surface)
        marks = _arrays.marks(marked, "marked", subdivision.number_of_input_edges())
        return StraightMesh(*subdivision.straight_mesh(self._points, marks, _arrays.number(thin_angle, "thin_angle"),
                                                      _arrays.number(maximum_deviation, "maximum_deviation"),
                                                      _arrays.marks(fixed, "fixed", len(self._points))))

    def conformal_map(self, cones: Optional[int] = None, cone_angles: Optional[Mapping[int, float]] = None,
                      boundary: Optional[Boundary] = None, boundary_angles: Optional[Mapping[int, float]] = None) -> ConformalMap:
        """Return a conformal map of the surface to the plane, which is proven to be locally injective.

        The surface may have any topology: it is cut open between its cones. The triangulation does not change.

        Parameters
        ----------
        cones : int, optional
            How many cones are chosen in each component; by default, so many that no length changes too much.
        cone_angles : mapping from vertices to float, optional
            The sums of the angles wanted at vertices inside the surface.
        boundary : {"free", "angles", "disk"}, optional
            The border keeps its scale; or has the given angles, and is straight elsewhere; or becomes a polygon whose outer
            angles are proportional to its edges. By default "free", or "angles" if some are given.
        boundary_angles : mapping from vertices to float, optional
            The angles of vertices on the border.

        Returns
        -------
        ConformalMap

        Raises
        ------
        InvalidArgumentError
            If the angles have the wrong sum, are not positive, or belong to other vertices.
        NumericalError
            If rounding prevents convergence, or turns triangles over.

        Examples
        --------
        >>> import intrinsic_triangulations as it
        >>> t = it.Triangulation([[0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, -1, 0]], [[0, 1, 2], [0, 2, 3], [0, 3, 1]])
        >>> m = t.conformal_map()
        >>> m.is_certified, m.overlaps, len(m.turned), m.uv.shape[1:]
        (True, False, 0, (3, 2))
        """
        return conformal_map(self._surface, self.number_of_vertices, cones, cone_angles, boundary, boundary_angles)

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
