# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Triangulations: how they are made, flipped, refined and checked.

import copy
import math

import numpy
import pytest

import intrinsic_triangulations as it
from conftest import grid, icosphere


def test_numbers_of_elements(sphere):
    V, F = sphere
    t = it.Triangulation(V, F)
    assert (t.number_of_vertices, t.number_of_faces, t.number_of_edges) == (len(V), len(F), len(V) + len(F) - 2)
    assert numpy.array_equal(t.faces, F)
    assert str(len(V)) in repr(t)
    assert numpy.allclose(t.lengths, numpy.linalg.norm(V[t.edges[:, 0]] - V[t.edges[:, 1]], axis=1), rtol=1e-15)
    sides = t.edges[t.face_edges]
    for i in range(3):
        assert numpy.array_equal(numpy.sort(sides[:, i], axis=1), numpy.sort(F[:, [i, (i + 1) % 3]], axis=1))
    assert numpy.allclose(t.angles.sum(axis=1), math.pi, rtol=1e-13)
    assert t.areas.sum() == pytest.approx(t.mass.sum(), rel=1e-13)


def test_flips(thin):
    t = it.Triangulation(*thin)
    assert not t.verify().is_delaunay and t.weights.min() < 0
    area = t.areas.sum()
    report = t.flip_to_delaunay()
    assert report.is_delaunay and report.flips > 100 and report.tests > report.flips
    assert t.weights.min() >= 0
    assert t.verify() and t.verify().is_delaunay and len(t.verify().not_delaunay) == 0
    assert t.areas.sum() == pytest.approx(area, rel=1e-13)
    assert t.flip_to_delaunay().flips == 0
    L, M = t.laplacian()
    other, mass = it.laplacian(*thin)
    assert abs(L - other).max() < 1e-12 * abs(L).max() and abs(M - mass).max() < 1e-12 * abs(M).max()


def test_a_budget_of_flips(thin):
    t = it.Triangulation(*thin)
    report = t.flip_to_delaunay(max_flips=10)
    assert not report.is_delaunay and report.flips == 10
    assert not t.verify().is_delaunay
    for bad in (-1, 2**64, 1.5, "all"):
        with pytest.raises(ValueError):
            t.flip_to_delaunay(max_flips=bad)


def test_constrained_edges(thin):
    t = it.Triangulation(*thin)
    before = t.edges
    constrained = numpy.arange(t.number_of_edges) % 3 == 0
    t.flip_to_delaunay(constrained=constrained)
    assert numpy.array_equal(t.edges[constrained], before[constrained])
    assert t.verify(constrained).is_delaunay and not t.verify().is_delaunay
    for bad in (constrained[1:], constrained.astype(int), [constrained], "all"):
        with pytest.raises(ValueError):
            t.flip_to_delaunay(constrained=bad)


def test_copies_are_independent(thin):
    t = it.Triangulation(*thin)
    copies = [t.copy(), copy.copy(t), copy.deepcopy(t)]
    flips = t.flip_to_delaunay().flips
    assert [other.flip_to_delaunay().flips for other in copies] == [flips] * 3
    assert numpy.array_equal(copies[0].positions, t.positions)
    # A copy of a triangulation that was flipped has the same input.
    other = t.copy()
    assert numpy.array_equal(other.common_subdivision().positions, t.common_subdivision().positions)


def test_lengths_and_gluing(sphere):
    V, F = sphere
    sides = numpy.stack([numpy.linalg.norm(V[F[:, i]] - V[F[:, (i + 1) % 3]], axis=1) for i in range(3)], axis=1)
    t, u = it.Triangulation(V, F), it.Triangulation.from_lengths(F, sides)
    assert numpy.allclose(t.lengths, u.lengths, rtol=1e-15) and numpy.array_equal(t.faces, u.faces)
    with pytest.raises(ValueError, match="no positions"):
        u.positions
    sides[5, 1] *= 1.01
    with pytest.raises(it.InvalidSurfaceError, match="has length") as caught:
        it.Triangulation.from_lengths(F, sides)
    assert caught.value.defect == "INVALID_GLUING"
    for bad in (0, -1, numpy.nan, numpy.inf, 100):
        with pytest.raises(it.InvalidSurfaceError):
            it.Triangulation.from_lengths([[0, 1, 2]], [[1, 1, bad]])
    with pytest.raises(ValueError):
        it.Triangulation.from_lengths([[0, 1, 2**31]], [[1, 1, 1]])
    with pytest.raises(ValueError):
        it.Triangulation.from_lengths([[0, 1, 2]], [[1, 1, 1]] * 2)


def test_a_torus_of_one_vertex():
    # A sheared unit square, whose Delaunay triangulation is that of the square.
    t = it.Triangulation.from_gluing([[0, 3], [1, 4], [2, 5]], [[1, math.sqrt(17), math.sqrt(26)]] * 2)
    assert t.number_of_vertices == 1
    t.flip_to_delaunay()
    assert numpy.allclose(numpy.sort(t.lengths), [1, 1, math.sqrt(2)], rtol=1e-14)
    assert t.areas.sum() == pytest.approx(1)
    border = it.Triangulation.from_gluing([], [[3, 4, 5]])
    assert border.number_of_vertices == 3 and border.number_of_edges == 3
    for bad in ([[0, 6]], [[0, 0]], [[0, 1], [1, 2]], [[-1, 2]], [0, 1], [[0.0, 1.0]]):
        with pytest.raises(ValueError):
            it.Triangulation.from_gluing(bad, [[1, 1, 1]] * 2)


@pytest.mark.parametrize("defect, V, F", [
    ("NON_MANIFOLD_EDGE", numpy.random.default_rng(0).normal(size=(5, 3)), [[0, 1, 2], [1, 0, 3], [0, 1, 4]]),
    ("INCONSISTENT_ORIENTATION", numpy.eye(4)[:, :3], [[0, 1, 2], [0, 1, 3]]),
    ("NON_MANIFOLD_VERTEX", numpy.random.default_rng(0).normal(size=(5, 3)), [[0, 1, 2], [0, 3, 4]]),
    ("REPEATED_CORNER", numpy.eye(3), [[0, 1, 1]]),
    ("ZERO_LENGTH_EDGE", numpy.zeros((3, 3)), [[0, 1, 2]]),
    ("OUT_OF_RANGE", [[0, 0, 0], [1e300, 0, 0], [0, 1e-300, 0]], [[0, 1, 2]])])
def test_defects(defect, V, F):
    with pytest.raises(it.InvalidSurfaceError) as caught:
        it.Triangulation(V, F)
    assert caught.value.defect == defect


def test_refinement(thin):
    t = it.Triangulation(*thin)
    t.flip_to_delaunay()
    assert numpy.degrees(t.angles).min() < 20
    report = t.refine(minimum_angle=25)
    assert report.is_refined and report.insertions > 0 and len(report.unrefined) == 0
    assert numpy.degrees(t.angles).min() >= 25 - 1e-9
    assert t.verify().is_delaunay
    faces, coordinates = t.inserted_vertices
    V, F = thin
    assert len(faces) == report.insertions + report.segment_splits == t.number_of_vertices - len(V)
    assert numpy.allclose(coordinates.sum(axis=1), 1)
    expected = numpy.einsum("ij,ijk->ik", coordinates, V[F[faces]])
    assert numpy.allclose(t.positions[len(V):], expected, atol=1e-13)
    assert t.laplacian()[0].shape == (t.number_of_vertices,) * 2


def test_smallest_size_of_refinement():
    t = it.Triangulation([[0, 0, 0], [1, 0, 0], [1, 1e-9, 0], [0, 1e-9, 0]], [[0, 1, 2], [0, 2, 3]])
    report = t.refine(minimum_size=0.001)
    assert report.is_finished and not report.is_refined and report.insertions + report.segment_splits == 0
    assert list(report.unrefined) == [0, 1] and list(report.reasons) == [4, 4] and report.number_by_reason["too_small"] == 2
    assert report.minimum_size == 0.001
    for bad in (-1, "1"):
        with pytest.raises(ValueError):
            t.refine(minimum_size=bad)


def test_smallest_size_is_chosen():
    V, F = [[0, 0, 0], [2, 0, 0], [1.001, 5e-7, 0], [2, 1, 0]], [[0, 1, 2], [2, 1, 3]]
    report = it.Triangulation(V, F).refine()
    assert report.insertions + report.segment_splits == 0 and 5e-7 < report.minimum_size < 1e-3
    everything = it.Triangulation(V, F).refine(minimum_size=0)
    assert everything.segment_splits > 1000 and everything.minimum_size == 0


def test_bounds_of_refinement():
    V, F = grid(3)
    t = it.Triangulation(V, F)
    assert t.refine(0, maximum_edge_length=0.3).is_refined
    assert t.lengths.max() <= 0.3
    t = it.Triangulation(V, F)
    report = t.refine(25, maximum_circumradius=0.05, max_insertions=5)
    assert not report.is_finished and not report.is_refined and report.insertions + report.segment_splits == 5
    assert set(report.reasons) == {6} and report.number_by_reason["budget"] == len(report.unrefined) > 0
    for bad in (31, -1, numpy.nan, "25", None):
        with pytest.raises(ValueError):
            t.refine(bad)
    for bad in (0, -1, numpy.nan):
        with pytest.raises(ValueError):
            t.refine(maximum_circumradius=bad)
        with pytest.raises(ValueError):
            t.refine(maximum_edge_length=bad)


def test_constrained_edges_of_a_refinement():
    V, F = grid(3, shear=2)
    t = it.Triangulation(V, F)
    constrained = numpy.abs(V[t.edges[:, 0], 1] - V[t.edges[:, 1], 1]) == 0
    t.refine(20, constrained=constrained)
    # All horizontal lines are still lines of edges.
    positions = t.positions
    on_line = positions[:, 1] == 1
    along = on_line[t.edges].all(axis=1)
    assert t.lengths[along].sum() == pytest.approx(2)


def test_sharp_edges_are_kept():
    # Two strips of a roof with a sliver along the ridge.
    V = numpy.array([[0, -1, 0], [4, -1, 0], [0, 0, 1], [4, 0, 1], [0, 1e-6, 1], [4, 1e-6, 1], [0, 1, 0], [4, 1, 0]])
    F = [[0, 1, 3], [0, 3, 2], [2, 3, 5], [2, 5, 4], [4, 5, 7], [4, 7, 6]]
    t = it.Triangulation(V, F)
    assert t.lengths[t.sharp_edges(30)].sum() == pytest.approx(8)
    sharp = t.sharp_edges(30, minimum_size=1e-3)
    assert t.lengths[sharp].sum() == pytest.approx(4) and not t.sharp_edges(100, minimum_size=1e-3).any()
    ridge = t.edges[sharp]
    assert numpy.array_equal(t.edges_between(ridge[:, ::-1]), sharp)
    u, s = it.Triangulation(V, F), it.Triangulation(V, F)
    report = u.refine(sharp_edge_angle=30)
    assert report.is_finished and report.minimum_size > 1e-6
    again = s.refine(constrained=s.sharp_edges(30, report.minimum_size), minimum_size=report.minimum_size)
    assert numpy.array_equal(u.edges, s.edges) and again.flips == report.flips
    with pytest.raises(ValueError, match="between 0 and 180"):
        it.Triangulation(V, F).refine(sharp_edge_angle=200)
    assert t.refine(constrained=sharp, minimum_size=1e-3).is_finished
    flipped = it.Triangulation([[0, 0, 0], [1, 0.1, 0], [2, 0, 1], [1, -0.1, 0]], [[0, 1, 2], [0, 2, 3]])
    flipped.flip_to_delaunay()
    with pytest.raises(ValueError, match="before they are flipped"):
        flipped.refine(constrained=[True] * 5)
    for bad in (-1, 181, numpy.nan, "30"):
        with pytest.raises(ValueError):
            t.sharp_edges(bad)
    with pytest.raises(ValueError):
        t.sharp_edges(30, minimum_size=-1)
    with pytest.raises(ValueError, match="no edge joins the vertices 7 and 0"):
        it.Triangulation(V, F).edges_between([[7, 0], [0, 1]])
    with pytest.raises(it.InvalidSurfaceError):
        t.edges_between([[0, 800]])
    with pytest.raises(ValueError):
        it.Triangulation.from_lengths([[0, 1, 2]], [[1, 1, 1]]).sharp_edges(30)


def test_whole_edges():
    V, F = grid(4)
    t = it.Triangulation(V, F)
    border = numpy.bincount(t.face_edges.ravel()) == 1
    report = t.refine(maximum_edge_length=0.4, whole="border")
    assert report.is_finished and report.segment_splits == 0 and report.insertions > 20
    assert set(report.reasons) <= {list(report.number_by_reason).index("whole_edge")}
    assert numpy.allclose(t.lengths[:len(border)][border], 1)
    again = it.Triangulation(V, F)
    assert again.refine(maximum_edge_length=0.4, whole=border).insertions == report.insertions
    assert numpy.array_equal(again.edges, t.edges)
    for bad in ("inside", border[:5], numpy.ones(len(border))):
        with pytest.raises(ValueError):
            it.Triangulation(V, F).refine(whole=bad)


def test_sizes():
    V, F = grid(4)
    sizes = numpy.full(len(V), numpy.inf)
    sizes[0] = 0.02
    t = it.Triangulation(V, F)
    assert t.refine(sizes=sizes).is_refined
    ends = t.positions[t.edges]
    assert (t.lengths <= 0.021 + 0.3 * 1.42 * numpy.linalg.norm(ends - V[0], axis=2).mean(axis=1)).all()
    assert 50 < t.number_of_vertices < 3000
    steep = it.Triangulation(V, F)
    steep.refine(sizes=sizes, size_gradation=1)
    assert steep.number_of_vertices < t.number_of_vertices
    with pytest.raises(ValueError, match="vertex 3 is not positive"):
        it.Triangulation(V, F).refine(sizes=numpy.where(numpy.arange(len(V)) == 3, 0., 1.))
    for bad in (dict(sizes=sizes[1:]), dict(size_gradation=0), dict(maximum_normal_angle=-1)):
        with pytest.raises(ValueError):
            it.Triangulation(V, F).refine(**bad)
    V, F = icosphere(1)
    t, fine = it.Triangulation(V, F), it.Triangulation(V, F)
    t.refine(maximum_normal_angle=20)
    fine.refine(maximum_normal_angle=5)
    assert fine.number_of_vertices > 6 * t.number_of_vertices


def test_far_too_many_vertices():
    t = it.Triangulation(*grid(3))
    with pytest.raises(ValueError, match="about [0-9]+ new vertices"):
        t.refine(maximum_edge_length=1e-5)
    assert t.number_of_vertices == len(grid(3)[0])
    assert not t.refine(maximum_edge_length=1e-5, max_insertions=10).is_finished


def test_large_and_small_units():
    V, F = icosphere(1)
    for scale in (1e-140, 1e140):
        t = it.Triangulation(V * scale, F)
        assert t.flip_to_delaunay().is_delaunay
        assert numpy.allclose(t.lengths / scale, it.Triangulation(V, F).lengths)


def test_straight_triangles():
    V = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    F = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
    t = it.Triangulation(V, F)
    sharp = t.sharp_edges(30)
    assert t.refine(maximum_edge_length=0.3, constrained=sharp).is_refined
    mesh = t.straight_mesh(sharp)
    assert mesh.is_surface and mesh.message == "" and mesh.deviation < 1e-13 and mesh.minimum_angle > 24.99
    assert len(set(mesh.regions)) == 6 and len(set(mesh.lines)) == 12
    assert numpy.array_equal(mesh.triangles, t.faces) and numpy.array_equal(mesh.points, t.positions)
    corners = mesh.points[mesh.triangles]
    areas = numpy.linalg.norm(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    assert numpy.allclose(numpy.bincount(mesh.regions, areas), 1)
    assert numpy.array_equal(numpy.asarray(mesh.input_faces) // 2 == mesh.input_faces[0] // 2, mesh.regions == mesh.regions[0])
    assert len(t.straight_mesh(sharp, thin_angle=60).thin_triangles) > 0
    assert len(t.straight_mesh().lines) == 0
    with pytest.raises(ValueError):
        t.straight_mesh(sharp[:5])
    with pytest.raises(ValueError):
        it.Triangulation.from_lengths([[0, 1, 2]], [[1, 1, 1]]).straight_mesh()


def test_straight_triangles_of_a_thin_box_are_no_surface():
    V = [[x, y, z] for x in (0, 1) for y in (0, 0.1) for z in (0, 0.1)]
    F = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
    t = it.Triangulation(V, F)
    t.refine()
    mesh = t.straight_mesh()
    assert not mesh.is_surface and len(mesh.loops) > 0 and "faces" in mesh.message


def test_straight_triangles_without_films():
    polygon = [(0, 0), (1, 0), (1, 0.5), (2, 0.5), (2, 0.5000001), (1, 0.5000001), (1, 1), (0, 1)]
    V = [[x, y, z] for z in (0, 1) for x, y in polygon]
    F = [[v, (v + 1) % 8, (v + 1) % 8 + 8] for v in range(8)] + [[v, (v + 1) % 8 + 8, v + 8] for v in range(8)]
    for a, b, c in [[0, 1, 2], [0, 2, 5], [0, 5, 7], [5, 6, 7], [2, 3, 4], [2, 4, 5]]:
        F += [[a, c, b], [a + 8, b + 8, c + 8]]
    t = it.Triangulation(V, F)
    report = t.refine(maximum_deviation=0.01, sharp_edge_angle=30)
    mesh = t.straight_mesh(it.Triangulation(V, F).sharp_edges(30, report.minimum_size), maximum_deviation=0.01)
    assert mesh.can_be_filled and len(mesh.folded_edges) == 0 and abs(mesh.area_of_films - 1) < 0.01
    assert mesh.minimum_dihedral_angle > 80 and mesh.points[mesh.triangles].max() < 1.01


def test_straight_triangles_near_the_surface(sphere):
    V, F = sphere
    for deviation in (0.02, 0.005):
        t = it.Triangulation(V, F)
        assert t.refine(maximum_deviation=deviation).is_refined
        mesh = t.straight_mesh(maximum_deviation=deviation)
        assert mesh.is_surface and mesh.deviation <= deviation and mesh.sufficient_deviation == 0
        assert numpy.array_equal(mesh.points_of_vertices, numpy.arange(len(mesh.points))) and len(mesh.merged_vertices) == 0
    with pytest.raises(ValueError):
        t.refine(maximum_deviation=0)
