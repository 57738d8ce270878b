# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Conformal maps to the plane.

"""Conformal maps of surfaces to the plane, with a proof of where they are locally injective."""

from __future__ import annotations

from typing import Any, Literal, NamedTuple, Optional, Tuple

import numpy

from . import _arrays, _core
from ._documented import documented

Boundary = Literal["free", "angles", "disk"]


@documented
class ConformalMap(NamedTuple):
    """The result of `Triangulation.conformal_map`.

    It is linear on the triangles of a mesh that divides the input triangles. Counts and signs refer to exactly the numbers in
    `uv`.
    """

    uv: numpy.ndarray
    """(k, 3, 2) array: the images of the corners of the triangles, counterclockwise except for `turned`."""
    triangles: numpy.ndarray
    """(k, 3) array of int64: the vertices of the triangles. The first ones are the vertices of the surface."""
    place_faces: numpy.ndarray
    """(m,) array of int64: an input face in which each vertex of the mesh lies."""
    place_coordinates: numpy.ndarray
    """(m, 3) array: its barycentric coordinates there; zero for a vertex without a face."""
    input_faces: numpy.ndarray
    """(k,) array of int64: the input face that contains each triangle."""
    is_cut: numpy.ndarray
    """(k, 3) array of bool: whether the side from corner i to the next is a part of a cut."""
    input_uv: numpy.ndarray
    """(f, 3, 2) array: the images of the corners of the input faces; those that a cut crosses follow one of its sides."""
    weights: numpy.ndarray
    """(m,) array: the weights w of the vertices of the mesh in homogeneous coordinates (w x, w y, w): interpolating them makes the
    map smoother than it is if it is linear on triangles."""
    stretch: numpy.ndarray
    """(k, 2) array: the factors by which the map stretches each triangle most and least. Their ratio is the distortion, 1 where
    shapes are kept, and their product the scale of areas."""
    u: numpy.ndarray
    """(n,) array: the logarithms of the scale factors at the vertices of the surface."""
    cones: numpy.ndarray
    """(c,) array of int64: the vertices inside the surface whose angles do not sum to 2 pi."""
    cone_angles: numpy.ndarray
    """(c,) array: the sums of their angles."""
    residual: float
    """By how much a wanted sum of angles is missed at most: proven."""
    range_of_u: float
    """The largest minus the smallest value of u."""
    steps: int
    """The steps of Newton's method."""
    seam: float
    """By how much the lengths of the two images of an edge of a cut differ at most."""
    is_certified: bool
    """Whether the map is proven to be locally injective on the ideal Delaunay triangulation, off the cuts."""
    overlaps: bool
    """Whether the border of the image crosses or touches itself: exact."""
    turned: numpy.ndarray
    """Array of int64: the triangles that are turned over or have no area: exact."""
    turned_input: numpy.ndarray
    """Array of int64: the input faces that turn over if the map is linear on them: exact."""
    divided_input: numpy.ndarray
    """Array of int64: the input faces that a cut crosses."""


def _angles(given: Any, what: str, number_of_vertices: int) -> Tuple[numpy.ndarray, numpy.ndarray]:
    items = sorted(dict(given or {}).items())
    return (numpy.array([_arrays.vertex(v, what, number_of_vertices) for v, _ in items], numpy.uint32),
            numpy.array([_arrays.number(angle, what) for _, angle in items], float))


def conformal_map(surface: Any, number_of_vertices: int, cones: Optional[int], cone_angles: Any, boundary: Any,
                  boundary_angles: Any) -> ConformalMap:
    if cone_angles is not None and cones is not None:
        raise ValueError("cones are either chosen or given: `cones` and `cone_angles` exclude each other")
    if boundary is None:
        boundary = "angles" if boundary_angles else "free"
    if cones is not None:
        cones = _arrays.integer(cones, "cones")
    (place_faces, place_coordinates), triangles, uv, input_faces, is_cut, input_uv, *rest = _core.conformal_map(
        surface, *_angles(cone_angles, "cone_angles", number_of_vertices),
        *_angles(boundary_angles, "boundary_angles", number_of_vertices), cones, _arrays.choice(boundary, "boundary", Boundary))
    return ConformalMap(uv.reshape(-1, 3, 2), triangles, place_faces, place_coordinates, input_faces, is_cut, input_uv.reshape(-1, 3, 2), *rest)
