# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# What the methods of a triangulation return.

"""What the methods of a triangulation return."""

from __future__ import annotations

from typing import Dict, NamedTuple

import numpy

from ._documented import documented


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
    """(t,) array of int64: the number of the region of each triangle. Marked edges separate regions; where vertices were
    merged, a region can come apart."""
    marked_edges: numpy.ndarray
    """(e, 2) array of int64: the ends of the marked edges and of those of the border."""
    lines: numpy.ndarray
    """(e,) array of int64: the number of the line of each of them: connected edges with the same regions beside them."""
    deviation: float
    """Films apart, no point of either surface is farther than this from the other one: proven, rounding included."""
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
    """With maximum_deviation, the pairs of triangles that have more in common than their common corners and edges; first
    those where the surface does not cross itself."""
    new_crossings: int
    """How many of them do not stand for parts of faces of the input that cross."""
    area_of_films: float
    """The area of films that were left out: two sheets of a closed surface that enclose no volume. Only from there, the
    triangles may be farther away than `deviation`."""
    minimum_dihedral_angle: float
    """The smallest angle between two triangles at an edge, in degrees."""
    folded_edges: numpy.ndarray
    """The edges of closed triangles at which this angle is below 0.1 degrees, by their ends."""
    can_be_filled: bool
    """Whether they are closed, nowhere folded onto themselves, and, as far as that was examined, do not cross: programs
    that fill volumes take them."""
