# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# A triangulation of a surface by straight lines on it.

"""A triangulation of a surface by straight lines on it."""

from __future__ import annotations

import copy
import math
import os
from typing import Any, Literal, Mapping, Optional, Union

import numpy
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._conformal import Boundary, ConformalMap, conformal_map
from ._elements import Elements
from ._errors import InvalidArgumentError, reading, writing
from ._reports import FlipReport, RefinementReport, StraightMesh, VerificationReport
from ._simplification import SimplifiedSurface


class Triangulation(Elements):
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
