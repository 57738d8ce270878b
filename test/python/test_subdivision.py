# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Common subdivisions: their arrays, values and points carried across them.

import numpy
import pytest
import scipy.sparse.linalg

import intrinsic_triangulations as it
from conftest import icosphere


@pytest.fixture(params=["flipped", "refined"])
def pair(request, thin):
    """a triangulation, its common subdivision with the input, and the input."""
    t = it.Triangulation(*thin)
    if request.param == "flipped":
        t.flip_to_delaunay()
    else:
        t.refine(20)
    return t, t.common_subdivision(), thin


def polygon_areas(s):
    corners, polygons = s.triangles()
    a, b, c = (s.positions[s.corners[corners[:, i]]] for i in range(3))
    return numpy.bincount(polygons, numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1) / 2, s.number_of_polygons)


def test_provenance(pair):
    t, s, (V, F) = pair
    assert s.number_of_input_vertices == len(V)
    assert s.number_of_inserted_vertices == t.number_of_vertices - len(V)
    assert s.number_of_crossings > 0
    assert len(s.positions) == s.number_of_vertices == s.corners.max() + 1
    assert s.number_of_vertices - len(s.segments) + s.number_of_polygons == 2  # a sphere
    # The polygons in a face of either triangulation cover it.
    areas = polygon_areas(s)
    of_input = numpy.linalg.norm(numpy.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]]), axis=1) / 2
    assert numpy.allclose(numpy.bincount(s.input_faces, areas, len(F)), of_input, rtol=1e-10)
    assert numpy.allclose(numpy.bincount(s.intrinsic_faces, areas, t.number_of_faces), t.areas, rtol=1e-10)
    # The segments of an edge are as long as the edge.
    lengths = numpy.linalg.norm(s.positions[s.segments[:, 0]] - s.positions[s.segments[:, 1]], axis=1)
    is_part = s.segment_intrinsic_edges >= 0
    sums = numpy.bincount(s.segment_intrinsic_edges[is_part], lengths[is_part], t.number_of_edges)
    assert numpy.allclose(sums, t.lengths, rtol=1e-12)
    input_edges = it.Triangulation(V, F)
    is_part = s.segment_input_edges >= 0
    sums = numpy.bincount(s.segment_input_edges[is_part], lengths[is_part], input_edges.number_of_edges)
    assert numpy.allclose(sums, input_edges.lengths, rtol=1e-12)


def test_later_flips_do_not_change_it(thin):
    t = it.Triangulation(*thin)
    s = t.common_subdivision()
    t.flip_to_delaunay()
    assert s.number_of_crossings == 0 and t.common_subdivision().number_of_crossings > 0
    assert numpy.array_equal(s.input_faces, s.intrinsic_faces)


def test_values(pair):
    t, s, (V, F) = pair
    assert numpy.allclose(s.from_input(V), s.positions)
    assert numpy.allclose(s.from_input(V[:, 0]), s.positions[:, 0])
    values = numpy.arange(t.number_of_vertices, dtype=numpy.int32)
    found = s.from_intrinsic(values)
    assert numpy.allclose(found[:len(values)], values)
    assert numpy.allclose(s.intrinsic_matrix.sum(axis=1), 1)
    for bad in (V[1:], V.astype(complex), "V", V[None]):
        with pytest.raises(ValueError):
            s.from_input(bad)


def test_texture_coordinates(pair):
    _, s, (V, F) = pair
    # A function on each face of its own: a seam at each edge.
    uv = numpy.random.default_rng(3).normal(size=(len(F), 3, 2))
    found = s.from_input_corners(uv)
    # It is linear on each face of the input, so an affine function of the position there.
    polygons = numpy.repeat(numpy.arange(s.number_of_polygons), numpy.diff(s.offsets))
    faces = s.input_faces[polygons]
    p, q, r = (V[F[faces, i]] for i in range(3))
    x = s.positions[s.corners] - p
    gram = numpy.stack([numpy.stack([((a - p) * (b - p)).sum(1) for b in (q, r)], -1) for a in (q, r)], -2)
    right = numpy.stack([((a - p) * x).sum(1) for a in (q, r)], -1)
    weights = numpy.linalg.solve(gram, right[..., None])[..., 0]
    expected = (1 - weights.sum(1))[:, None] * uv[faces, 0] + weights[:, :1] * uv[faces, 1] + weights[:, 1:] * uv[faces, 2]
    assert numpy.allclose(found, expected, atol=1e-8)
    assert numpy.array_equal(s.from_input_corners(uv[:, :, 0]), found[:, 0])
    for bad in (uv[1:], uv[:, :2], uv[None], "uv"):
        with pytest.raises(ValueError):
            s.from_input_corners(bad)


def position(V, F, faces, coordinates):
    return numpy.einsum("ij,ijk->ik", coordinates, V[F[faces]])


def test_points_both_ways(pair):
    t, s, (V, F) = pair
    random = numpy.random.default_rng(4)
    faces = random.integers(len(F), size=500)
    coordinates = random.dirichlet((1, 1, 1), size=500)
    there = s.to_intrinsic(faces, coordinates)
    assert there[0].max() < t.number_of_faces and numpy.allclose(there[1].sum(axis=1), 1)
    back = s.to_input(*there)
    assert numpy.allclose(position(V, F, *back), position(V, F, faces, coordinates), atol=1e-12)
    assert (there[0] != faces).any()
    # On both ways a vertex stays a vertex.
    corners = numpy.eye(3)[random.integers(3, size=len(F))]
    face, coordinate = s.to_intrinsic(numpy.arange(len(F)), corners)
    assert ((coordinate > 0).sum(axis=1) == 1).all()
    assert numpy.array_equal(t.faces[face][coordinate > 0], F[corners > 0])


def test_bad_points(pair):
    _, s, (_, F) = pair
    one = [[1 / 3, 1 / 3, 1 / 3]]
    for faces, coordinates in (([len(F)], one), ([-1], one), ([2**32], one), ([0], [[1, 1, -1]]), ([0], [[0, 0, 0]]),
                               ([0], [[1, 1, numpy.nan]]), ([0], [[1, 1, numpy.inf]]), ([0, 1], one), ([0.0], one), (0, one),
                               ([0], [[1, 1]])):
        with pytest.raises(ValueError):
            s.to_intrinsic(faces, coordinates)
    assert [len(x) for x in s.to_intrinsic([], numpy.zeros((0, 3)))] == [0, 0]


def test_mass_matrices(pair):
    t, s, (V, F) = pair
    one, two, mixed = s.mass_matrices()
    assert [m.sum() for m in (one, two, mixed)] == pytest.approx([t.areas.sum()] * 3)
    assert abs(two - t.laplacian("galerkin")[1]).max() < 1e-12 * abs(two).max()
    # The projection keeps the integral.
    u = V[:, 2]
    projected = scipy.sparse.linalg.spsolve(two, mixed @ u)
    assert (two @ projected).sum() == pytest.approx((one @ u).sum(), abs=1e-9)


def test_the_subdivision_outlives_the_triangulation():
    s = it.Triangulation(*icosphere(2)).common_subdivision()
    assert s.positions.shape == (s.number_of_vertices, 3)
    assert len(s.to_intrinsic([0], [[1, 1, 1]])[0]) == 1
    with pytest.raises(ValueError):
        s.corners[0] = 5
