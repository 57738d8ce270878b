# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Distances, and functions that spread from vertices.

import numpy
import pytest

import intrinsic_triangulations as it
from conftest import grid, icosphere


def test_distances_on_a_sphere():
    V, F = icosphere(4)
    expected = numpy.arccos(numpy.clip(V @ V[0], -1, 1))
    solver = it.MeshHeatMethodDistanceSolver(V, F)
    found = solver.compute_distance(0)
    assert found[0] == 0 and abs(found - expected).mean() < 0.015
    assert numpy.array_equal(found, it.compute_distance(V, F, 0))
    assert numpy.array_equal(solver.compute_distance(numpy.int8(0)), found)


def test_several_sources():
    V, F = icosphere(4)
    sources = [0, 3, 77]
    expected = numpy.arccos(numpy.clip(V @ V[sources].T, -1, 1)).min(axis=1)
    found = it.compute_distance_multisource(V, F, sources)
    assert (found[sources] == 0).all() and abs(found - expected).mean() < 0.02
    solver = it.MeshHeatMethodDistanceSolver(V, F)
    assert numpy.array_equal(solver.compute_distance_multisource(numpy.array(sources, dtype=">u2")), found)
    with pytest.raises(it.InvalidArgumentError, match="at least one source"):
        solver.compute_distance_multisource([])
    # The sources of a call are forgotten.
    assert numpy.array_equal(solver.compute_distance_multisource([5]), solver.compute_distance(5))


def test_unreachable_vertices():
    V, F = icosphere(1)
    V, F = numpy.concatenate([V, V + 5, [[0, 0, 0]]]), numpy.concatenate([F, F + len(V)])
    found = it.compute_distance(V, F, 0)
    n = len(V) // 2
    assert numpy.isfinite(found[:n]).all() and numpy.isinf(found[n:]).all()


def test_shortest_paths():
    V, F = icosphere(4)
    expected = numpy.arccos(numpy.clip(V @ V[[0, 77]].T, -1, 1)).min(axis=1)
    exact, found = it.geodesic_distances(V, F, [0, 77], tolerance=0), it.geodesic_distances(V, F, [0, 77])
    assert (found[[0, 77]] == 0).all() and abs(exact - expected).max() < 0.01 and abs(found - exact).max() < 0.01 * exact.max()
    # A plane fan of slivers, on which the spread of heat says nothing.
    n = 200
    V = numpy.array([(numpy.cos(a), numpy.sin(a), 0) for a in 2 * numpy.pi * numpy.arange(n) / n])
    F = numpy.array([(0, i, i + 1) for i in range(1, n - 1)])
    straight = numpy.linalg.norm(V - V[3], axis=1)
    assert abs(it.geodesic_distances(V, F, [3]) - straight).max() < 1e-12
    # Other parts of the surface play no role.
    far = numpy.concatenate([V, 1000 * V + 5000])
    assert numpy.array_equal(it.geodesic_distances(far, numpy.concatenate([F, F + n]), [3])[:n], it.geodesic_distances(V, F, [3]))
    with pytest.raises(it.InvalidArgumentError, match="v_inds is empty"):
        it.geodesic_distances(V, F, [])
    for bad in (-1, 1, numpy.nan, "0", None):
        with pytest.raises(ValueError):
            it.geodesic_distances(V, F, [3], tolerance=bad)
    for bad in ([n], [-1], [0.5]):
        with pytest.raises(ValueError):
            it.geodesic_distances(V, F, bad)


def test_distances_from_curves():
    # On a plane: from a line through triangles, an edge, a vertex with an offset.
    V, F = grid(8)
    spread = V.max(axis=0)
    triangle, middle = 2 * 8 * 3 + 6, numpy.array([[0.2, 0.3, 0.5], [0.6, 0.3, 0.1]])
    curve = numpy.column_stack([[triangle] * 2, middle])
    a, b = middle @ V[F[triangle]]
    edge = F[40][[0, 1]]
    distances, nearest = it.geodesic_distances_from(V, F, [curve, edge, 5], 0, offsets=[0, 0.25 * spread[0], 0])

    def to_segment(p, q):
        d = q - p
        t = numpy.clip((V - p) @ d / max(d @ d, 1e-300), 0, 1)
        return numpy.linalg.norm(V - p - t[:, None] * d, axis=1)
    each = numpy.array([to_segment(a, b), 0.25 * spread[0] + to_segment(*V[edge]), to_segment(V[5], V[5])])
    if numpy.ptp(V[:, 2]) == 0:
        assert abs(distances - each.min(axis=0)).max() < 1e-12
        assert (each[nearest, numpy.arange(len(V))] - each.min(axis=0)).max() < 1e-12
    point, _ = it.geodesic_distances_from(V, F, [[triangle, 1, 0, 0]], 0)
    assert abs(point - it.geodesic_distances(V, F, F[triangle][0], 0)).max() < 1e-14
    for bad in ([], [numpy.empty((0, 4))], [len(V)], [[0, len(V) - 1]], [[0.5, 1, 0, 0]], [[len(F), 1, 0, 0]], [[0, -1, 1, 1]], [[0, numpy.nan, 0, 1]],
                [[[0, 1, 0, 0], [len(F) - 1, 0, 0, 1]]]):
        with pytest.raises(ValueError):
            it.geodesic_distances_from(V, F, bad)
    for bad in (len(F), -1):
        with pytest.raises(it.InvalidPointError, match=rf"sources\[1\]: there is no triangle {bad}: there are {len(F)}, counted"):
            it.geodesic_distances_from(V, F, [0, [[0, 1, 0, 0], [bad, 1, 0, 0]]])
    for bad in ([0], [0, 0, 0], [[0, 1, 2]]):
        with pytest.raises(ValueError, match=r"sources\[1\] has to be an integer \(a vertex\).*locate.*has the shape \("):
            it.geodesic_distances_from(V, F, [0, bad])
    with pytest.raises(ValueError):
        it.geodesic_distances_from(V, F, [0], offsets=[-1])


def test_points_near_edges_lie_on_them():
    V, F = grid(8)
    path = it.geodesic_path(V, F, 1, len(V) - 14)
    places = numpy.column_stack([path.faces, path.coordinates])
    near = places.copy()
    for row in near:
        outside = numpy.nonzero(row[1:] == 0)[0]
        if len(outside) == 1:
            row[1 + outside] = 1e-14
    assert (near != places).any()
    expected, _ = it.geodesic_distances_from(V, F, [places], 0)
    assert it.geodesic_distances_from(V, F, [near], 0)[0] == pytest.approx(expected, abs=1e-10)
    assert it.geodesic_distances_from(V, F, [near], 0, barriers=[[0, 1]])[0] == pytest.approx(
        it.geodesic_distances_from(V, F, [places], 0, barriers=[[0, 1]])[0], abs=1e-10)


def test_heat_from_curves():
    V, F = grid(16)
    triangle = 2 * 16 * 7 + 14
    curve = numpy.array([[triangle, 0.2, 0.3, 0.5], [triangle, 0.6, 0.3, 0.1]])
    step = numpy.linalg.norm(V[F[0][0]] - V[F[0][1]])
    for robust in (True, False):
        solver = it.MeshHeatMethodDistanceSolver(V, F, use_robust=robust)
        for sources, offsets in (([curve], None), ([curve, 5], [0, step]), ([F[triangle][:2]], None)):
            exact, _ = it.geodesic_distances_from(V, F, sources, 0, offsets=offsets)
            found = solver.compute_distance_from(sources, offsets)
            assert abs(found - exact).mean() < step
            assert (found[exact == 0] == 0).all()
        vertex = int(F[triangle][0])
        assert numpy.array_equal(solver.compute_distance_from([vertex]), solver.compute_distance(vertex))
        with pytest.raises(ValueError):
            solver.compute_distance_from([len(V)])
    with pytest.raises(ValueError):
        it.MeshHeatMethodDistanceSolver.from_triangulation(it.Triangulation(V, F)).compute_distance_from([0])


def test_barriers():
    V, F = grid(8)
    column = int(numpy.flatnonzero((V[:, 1] == 0) & (V[:, 0] > V[:, 0].min()))[2])
    x = V[column, 0]
    wall = [int(v) for v in numpy.flatnonzero(abs(V[:, 0] - x) < 1e-12) if V[v, 1] < 0.6 * V[:, 1].max()]
    wall.sort(key=lambda v: V[v, 1])
    edges = list(zip(wall, wall[1:]))
    source = 0
    free, _ = it.geodesic_distances_from(V, F, [source], 0)
    for tolerance, most in ((0, 1e-12), (0.001, 1e-2)):
        found, nearest = it.geodesic_distances_from(V, F, [source], tolerance, barriers=edges)
        assert len(found) == len(V) and (nearest == 0).all() and (found >= free - most).all()
        end = V[wall[-1]]
        behind = numpy.flatnonzero((V[:, 0] > x) & (V[:, 1] == 0))
        around = numpy.linalg.norm(V[source] - end) + numpy.linalg.norm(V[behind] - end, axis=1)
        assert abs(found[behind] - around).max() < most
    curve = numpy.array([[0, 1, 0, 0], [0, 0, 1, 0]], dtype=float)
    assert (it.geodesic_distances_from(V, F, [curve], 0, barriers=[curve])[0][F[0][:2]] == 0).all()
    for bad in ([0, len(V) - 1], [1e9, 0.5, 0.5, 0], "x"):
        with pytest.raises(ValueError):
            it.geodesic_distances_from(V, F, [0], barriers=[bad])


def test_distance_matrix():
    V, F = grid(12)
    for tolerance in (0, 0.001):
        found = it.geodesic_distance_matrix(V, F, [0, 7, 7], [3, 50, 100, 0], tolerance)
        assert found.shape == (3, 4) and numpy.array_equal(found[1], found[2]) and found[0, 3] == 0
        for row, source in zip(found, (0, 7, 7)):
            assert numpy.array_equal(row, it.geodesic_distances(V, F, source, tolerance)[[3, 50, 100, 0]])
    assert it.geodesic_distance_matrix(V, F, [], [1]).shape == (0, 1)
    with pytest.raises(ValueError):
        it.geodesic_distance_matrix(V, F, [0], [len(V)])


def test_options(thin):
    V, F = grid(12)
    neumann, dirichlet, averaged = (it.MeshHeatMethodDistanceSolver(V, F, use_robust=False, boundary=b).compute_distance(40)
                                    for b in ("neumann", "dirichlet", "averaged"))
    assert abs(neumann - dirichlet).max() > 1e-3 and abs(neumann - averaged).max() > 1e-3
    smooth = it.MeshHeatMethodDistanceSolver(V, F, 100.0).compute_distance(40)
    assert abs(smooth - it.compute_distance(V, F, 40)).max() > 1e-3
    rounded = it.MeshHeatMethodDistanceSolver(*thin, keeps_ridges=False).compute_distance(0)
    assert (rounded <= it.compute_distance(*thin, 0) + 1e-12).all()
    for bad in (0, -1, numpy.nan, numpy.inf, "1", None):
        with pytest.raises(ValueError):
            it.MeshHeatMethodDistanceSolver(V, F, t_coef=bad)
    with pytest.raises(ValueError):
        it.MeshHeatMethodDistanceSolver(V, F, boundary="robin")
    with pytest.raises(it.InvalidSurfaceError):
        it.MeshHeatMethodDistanceSolver(V, numpy.concatenate([F, F]), use_robust=False)


def test_on_a_refined_triangulation(thin):
    t = it.Triangulation(*thin)
    t.refine()
    solver = it.MeshHeatMethodDistanceSolver.from_triangulation(t)
    found = solver.compute_distance(0)
    assert len(found) == t.number_of_vertices > len(thin[0])
    coarse = it.compute_distance(*thin, 0)
    assert abs(found[:len(coarse)] - coarse).max() < 0.1 * coarse.max()
    with pytest.raises(ValueError):
        it.MeshHeatMethodDistanceSolver.from_triangulation(thin)


def test_extension():
    V, F = icosphere(3)
    solver = it.MeshHeatMethodDistanceSolver(V, F)
    a, b = 0, int(numpy.argmin(V @ V[0]))
    found = solver.extend_scalar([a, b], [2, -1.5])
    assert found[a] == 2 and found[b] == -1.5
    assert found.max() <= 2 + 1e-12 and found.min() >= -1.5 - 1e-12
    assert abs(found[V @ V[0] > 0.5] - 2).max() < 0.1
    for vertices, values in (([0], [1, 2]), ([len(V)], [1]), ([0], ["x"]), ([0.5], [1]), ([[0]], [1])):
        with pytest.raises(ValueError):
            solver.extend_scalar(vertices, values)


@pytest.mark.parametrize("source", [-1, 42, 2**70, 1.0, None, "0", [0]])
def test_bad_sources(source):
    V, F = icosphere(1)
    solver = it.MeshHeatMethodDistanceSolver(V, F)
    with pytest.raises(ValueError):
        solver.compute_distance(source)
    if source != [0]:
        with pytest.raises(ValueError):
            solver.compute_distance_multisource([source])
