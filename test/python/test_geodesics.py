# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Paths, closed curves and lines in a direction.

import math
from concurrent.futures import ThreadPoolExecutor

import numpy
import pytest

import intrinsic_triangulations as it
from conftest import grid, icosphere


def length(positions):
    return numpy.linalg.norm(numpy.diff(positions, axis=0), axis=1).sum()


def test_paths_in_a_plane():
    V, F = grid(9, shear=0.7)
    solver = it.EdgeFlipGeodesicSolver(V, F)
    for a, b in ((0, 80), (3, 50), (17, 60), (8, 72)):
        path = solver.find_geodesic_path(a, b)
        assert numpy.array_equal(path[0], V[a]) and numpy.array_equal(path[-1], V[b])
        assert length(path) == pytest.approx(numpy.linalg.norm(V[a] - V[b]), rel=1e-13)


def test_paths_on_a_sphere():
    V, F = icosphere(3)
    solver = it.EdgeFlipGeodesicSolver(V, F)
    for target in range(1, 600, 60):
        path = solver.find_path([0, target])
        angle = math.acos(numpy.clip(V[0] @ V[target], -1, 1))
        assert path.is_geodesic and path.status == "geodesic"
        assert 0.97 * angle < path.length <= min(path.initial_length, 1.02 * angle)
        assert path.length == pytest.approx(length(path.positions), rel=1e-12)
        assert numpy.allclose(numpy.einsum("ij,ijk->ik", path.coordinates, V[F[path.faces]]), path.positions, atol=1e-14)


def test_a_query_does_not_depend_on_others(thin):
    solver = it.EdgeFlipGeodesicSolver(*thin)
    first = solver.find_geodesic_path(3, 400)
    for target in range(20, 300, 40):
        solver.find_geodesic_path(1, target)
    assert numpy.array_equal(solver.find_geodesic_path(3, 400), first)
    assert numpy.array_equal(it.geodesic_path(*thin, 3, 400).positions, first)


def test_threads_find_the_paths_that_one_finds(thin):
    solver = it.EdgeFlipGeodesicSolver(*thin)
    pairs = [(source, target) for source in (1, 3) for target in range(20, 300, 20)]
    alone = [solver.find_geodesic_path(*pair) for pair in pairs]
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(lambda pair: solver.find_geodesic_path(*pair), pairs))
    assert all(map(numpy.array_equal, alone, together))


def test_paths_through_several_vertices():
    V, F = grid(9)
    path = it.EdgeFlipGeodesicSolver(V, F).find_geodesic_path_poly([0, 40, 8])
    # The one in between is passed on a straight line in the end.
    assert length(path) == pytest.approx(8)


def test_closed_curves():
    # A tube, and a curve around it that begins as a zigzag.
    n, m = 12, 6
    angles = 2 * math.pi * numpy.arange(n) / n
    V = numpy.array([[math.cos(a), math.sin(a), z * (1 + (z - 3) ** 2 / 9)] for z in range(m) for a in angles])
    V[:, :2] *= (1 + 0.2 * (V[:, 2:] - V[:, 2].mean()) ** 2 / V[:, 2].max())
    quads = [(z * n + i, z * n + (i + 1) % n, (z + 1) * n + (i + 1) % n, (z + 1) * n + i) for z in range(m - 1) for i in range(n)]
    F = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    solver = it.EdgeFlipGeodesicSolver(V, F)
    curve = solver.find_path([2 * n, 3 * n + 4, 2 * n + 8], is_closed=True)
    assert curve.is_geodesic and curve.status == "geodesic" and 5 < curve.length < curve.initial_length
    assert numpy.allclose(curve.positions[0], curve.positions[-1])
    assert numpy.array_equal(solver.find_geodesic_loop([2 * n, 3 * n + 4, 2 * n + 8]), curve.positions)
    # Around a vertex of a sphere, it can be shrunk to a point.
    V, F = icosphere(2)
    star = F[(F == 0).any(axis=1)]
    ring = [int(v) for v in numpy.unique(star) if v != 0]
    shrunk = it.EdgeFlipGeodesicSolver(V, F).find_path(ring[:3], is_closed=True)
    assert shrunk.status == "contractible" and shrunk.length == 0 and shrunk.positions.shape == (1, 3)


def test_bad_paths():
    V, F = icosphere(1)
    solver = it.EdgeFlipGeodesicSolver(numpy.concatenate([V, V + 3]), numpy.concatenate([F, F + len(V)]))
    for a, b in ((0, 84), (-1, 2), (0, 50), (0, 1.5), (0, None)):
        with pytest.raises(ValueError):
            solver.find_geodesic_path(a, b)
    for stops in ([], [3], [[0, 1]], [4, 4], "01", None):
        with pytest.raises(ValueError):
            solver.find_geodesic_loop(stops)
    with pytest.raises(ValueError):
        solver.find_geodesic_path(0, 5, max_relative_length_decrease=0.5)
    with pytest.raises(ValueError):
        it.EdgeFlipGeodesicSolver(V, numpy.concatenate([F, F]))


def test_a_path_to_itself_is_empty():
    V, F = icosphere(1)
    for is_shortest in (False, True):
        path = it.geodesic_path(V, F, 7, 7, is_shortest)
        assert path.positions.shape == (0, 3) and path.length == 0 and path.is_geodesic


def test_the_shortest_path():
    # A pyramid with a peak near its front: edges lead over its back.
    V = [[-5, 0, 0], [5, 0, 0], [0, 1, 6], [0, -4, 0], [0, 4.5, 0]]
    F = [[0, 2, 4], [2, 1, 4], [0, 3, 2], [3, 1, 2]]
    path = it.geodesic_path(V, F, 0, 1, is_shortest=True)
    assert path.distance == pytest.approx(it.geodesic_distances(V, F, [0], tolerance=0)[1], rel=1e-12)
    assert path.length == pytest.approx(path.distance, rel=1e-12) and path.is_geodesic
    assert it.geodesic_path(V, F, 0, 1).distance is None
    with pytest.raises(ValueError):
        it.EdgeFlipGeodesicSolver(V, F).find_path([0, 1, 2], is_closed=True, is_shortest=True)


def test_the_shortest_path_where_three_faces_meet():
    V = [[0, 0, 0], [0, 0, 1], [1, 0, 0.5], [-1, 2, 0.5], [-1, -2, 0.5]]
    F = [[0, 1, 2], [0, 1, 3], [1, 0, 4]]
    path = it.shortest_path(V, F, 2, 4)
    assert path.is_complete and path.length == pytest.approx(1 + 5 ** 0.5) and path.distance == pytest.approx(path.length)
    assert path.positions == pytest.approx(numpy.array([V[2], [0, 0, 0.5], V[4]])) and list(path.faces) == [0, 2, 2]
    for bad in (5, -1, 1.5, [0, 0, 1]):
        with pytest.raises(ValueError, match="^(there is no vertex|target has to be an integer)"):
            it.shortest_path(V, F, 0, bad)


def test_a_path_from_page_to_page_is_a_source():
    V = numpy.array([[0, 0, 0], [0, 0, 1], [1, 0, 0.5], [-1, 2, 0.5], [-1, -2, 0.5]])
    F = [[0, 1, 2], [0, 1, 3], [1, 0, 4]]
    path = it.shortest_path(V, F, [0, 0.25, 0.25, 0.5], [1, 0.375, 0.375, 0.25], via=[[2, 0.5, 0.5, 0]])
    assert path.length == pytest.approx(0.5 + 5 ** 0.5 / 4) and path.is_complete
    for point, face, coordinates in zip(path.positions, path.faces, path.coordinates):
        assert coordinates @ V[F[face]] == pytest.approx(point)
    distances, _ = it.geodesic_distances_from(V, F, [path.places], 0)
    assert distances == pytest.approx([0.5, 0.5, 0.5, 0.75 * 5 ** 0.5, 5 ** 0.5], rel=1e-14)
    assert len(it.shortest_path(V, F, 2, 2).positions) == 1
    with pytest.raises(ValueError, match="have to be vertices, or points"):
        it.shortest_path(V, F, [0, 1], 2)
    with pytest.raises(it.InvalidPointError, match="triangle 2 that is not in the former"):
        it.geodesic_distances_from(V, F, [[[0, 1, 1, 1], [2, 1, 1, 1]]])


def test_shortest_from_stop_to_stop():
    # A part flips edges of those before.
    V, F = icosphere(2)
    solver = it.EdgeFlipGeodesicSolver(V, F)
    stops = [3, [1, 0.3, 0.2], 90, 41, [-1, 0.2, 0.5], 12, 77]
    path = solver.find_path(stops, is_shortest=True)
    length = sum(solver.find_path(stops[i:i + 2], is_shortest=True).length for i in range(len(stops) - 1))
    assert path.is_geodesic and path.length == pytest.approx(length, rel=1e-12)
    assert path.distance == pytest.approx(length, rel=1e-12)
    assert numpy.linalg.norm(numpy.diff(path.positions, axis=0), axis=1).sum() == pytest.approx(length, rel=1e-12)
    two = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 0, 0], [6, 0, 0], [5, 1, 0]], [[0, 1, 2], [3, 4, 5]]
    for is_shortest in (False, True):
        with pytest.raises(it.InvalidArgumentError, match="from stop 1 to the next one"):
            it.EdgeFlipGeodesicSolver(*two).find_path([0, 1, 3], is_shortest=is_shortest)


def test_paths_between_points():
    V, F = grid(9)
    solver = it.EdgeFlipGeodesicSolver(V, F)
    face, coordinates = solver.locate([2.25, 3.5, 7])
    assert numpy.allclose(coordinates @ V[F[face]], [2.25, 3.5, 0]) and coordinates.sum() == pytest.approx(1)
    for is_shortest in (False, True):
        path = solver.find_path([[2.25, 3.5, 7], 0, numpy.array([6.5, 3, -1])], is_shortest=is_shortest)
        assert numpy.allclose(path.positions[0], [2.25, 3.5, 0]) and numpy.allclose(path.positions[-1], [6.5, 3, 0])
    with pytest.raises(ValueError):
        solver.locate([0, numpy.inf, 0])
    with pytest.raises(ValueError):
        solver.find_path([[0, 0], 1])


def test_a_cut():
    V, F = icosphere(2)
    V = numpy.asarray(V)
    path = it.geodesic_path(V, F, 3, [1, 0.3, 0.2], is_shortest=True)
    cut = it.cut_along_path(V, F, path)
    sides = {(int(a), int(b)) for t in cut.triangles for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))}
    assert len(sides) == 3 * len(cut.triangles)
    border = [(a, b) for a, b in sides if (b, a) not in sides]
    assert sum(numpy.linalg.norm(cut.positions[a] - cut.positions[b]) for a, b in border) == pytest.approx(2 * path.length)
    assert numpy.array_equal(cut.positions[: len(V)], V) and cut.input_faces.shape == (len(cut.triangles),)
    corners = V[numpy.asarray(F)[cut.faces]]
    assert numpy.allclose((cut.coordinates[:, :, None] * corners).sum(axis=1), cut.positions[len(V) :])
    with pytest.raises(ValueError):
        it.cut_along_path(V, F, path._replace(faces=path.faces[:1]))


def test_a_budget_of_flips(thin):
    path = it.EdgeFlipGeodesicSolver(*thin).find_path([3, 400], max_iterations=1)
    assert path.flips <= 1 and path.status == "unfinished" and not path.is_geodesic


def test_lines_in_a_plane():
    V, F = grid(8, shear=0.3)
    tracer = it.GeodesicTracer(V, F)
    direction = numpy.array([1.3, 0.77, 5.0])  # what leads away from the plane does not count
    line = tracer.trace_geodesic_from_face(8, [0.2, 0.3, 0.5], direction)
    start = numpy.array([0.2, 0.3, 0.5]) @ V[F[8]]
    assert numpy.allclose(line[0], start) and numpy.allclose(line[-1], start + direction * (1, 1, 0))
    for v in (9, 27):
        for angle in numpy.arange(0.05, 6.2, 0.3):
            direction = 0.9 * numpy.array([math.cos(angle), math.sin(angle), 0])
            line = tracer.trace_geodesic_from_vertex(v, direction)
            assert numpy.allclose(line[-1], V[v] + direction, atol=1e-13)
    # At a corner of the border, too, where only some directions lead along the surface.
    line = tracer.trace_geodesic_from_vertex(0, [1, 0.5, 0])
    assert numpy.allclose(line[-1], [1, 0.5, 0])
    with pytest.raises(it.InvalidPointError, match="leads away"):
        tracer.trace_geodesic_from_vertex(0, [-1, -1, 0])
    assert len(tracer.trace_geodesic_from_vertex(0, [5, 3, 0], max_iterations=2)) == 3


def test_lines_on_a_sphere():
    V, F = icosphere(4)
    tracer = it.GeodesicTracer(V, F)
    direction = numpy.cross(V[200], [0, 0, 1])
    direction *= math.pi / numpy.linalg.norm(direction)
    line = tracer.trace_geodesic_from_vertex(200, direction)
    assert length(line) == pytest.approx(math.pi, rel=1e-6)  # projected to the tangent plane
    assert numpy.linalg.norm(line[-1] + V[200]) < 0.1  # at the other side


def test_bad_lines(sphere):
    tracer = it.GeodesicTracer(*sphere)
    for v, direction in ((-1, [1, 0, 0]), (200, [1, 0, 0]), (0, [1, 0]), (0, [0, 0, 0]), (0, [numpy.nan, 0, 0]),
                         (0, [numpy.inf, 0, 0]), (0, "x"), (0.0, [1, 0, 0])):
        with pytest.raises(ValueError):
            tracer.trace_geodesic_from_vertex(v, direction)
    for f, coordinates, direction in ((-1, [1, 1, 1], [1, 0, 0]), (10**6, [1, 1, 1], [1, 0, 0]), (0, [1, 1, -1], [1, 0, 0]),
                                      (0, [0, 0, 0], [1, 0, 0]), (0, [1, 1, numpy.nan], [1, 0, 0]), (0, [1, 1, 1], [0, 0, 0]), (0, [1, 1, 1], [7e9, 1e9, 0])):
        with pytest.raises(ValueError):
            tracer.trace_geodesic_from_face(f, coordinates, direction)


def test_lines_are_cut_off(sphere):
    tracer = it.GeodesicTracer(*sphere)
    start = 5, [0.3, 0.3, 0.4]
    with pytest.raises(it.InvalidPointError, match="more than a million faces within"):
        tracer.trace_geodesic_from_face(*start, [7e8, 2e8, 1e8])
    line = tracer.trace_geodesic_from_face(*start, [7, 2, 1])
    for number in (1, 10):
        assert numpy.array_equal(tracer.trace_geodesic_from_face(*start, [7, 2, 1], max_iterations=number), line[:number + 1])
        assert len(tracer.trace_geodesic_from_face(*start, [7e8, 2e8, 1e8], max_iterations=number)) == number + 1
    for number in (0, -1, 1.5):
        with pytest.raises(ValueError):
            tracer.trace_geodesic_from_face(*start, [7, 2, 1], max_iterations=number)
