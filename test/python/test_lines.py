# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Lines at a distance, borders of cells, and vertices far from each other."""

import numpy
import pytest

import intrinsic_triangulations as it


def plane(n):
    """A grid of n by n squares."""
    x, y = numpy.meshgrid(numpy.arange(n + 1.0), numpy.arange(n + 1.0))
    V = numpy.column_stack([x.ravel(), y.ravel(), numpy.zeros(x.size)])
    v = (numpy.arange(n)[:, None] * (n + 1) + numpy.arange(n)).ravel()
    return V, numpy.concatenate([numpy.column_stack([v, v + 1, v + n + 2]), numpy.column_stack([v, v + n + 2, v + n + 1])])


def test_isolines_are_circles():
    V, F = plane(10)
    lines = it.isolines(V, F, [60], [2, 1], tolerance=0, chord_tolerance=1e-3)
    assert [line.distance for line in lines] == [1, 2]
    for line in lines:
        assert numpy.allclose(numpy.linalg.norm(line.positions - V[60], axis=1), line.distance, rtol=0, atol=1e-13)
        assert numpy.array_equal(line.positions[0], line.positions[-1])
        places = (V[F[line.faces]] * line.coordinates[:, :, None]).sum(axis=1)
        assert numpy.allclose(places, line.positions, rtol=0, atol=1e-13)
        middles = (line.positions[1:] + line.positions[:-1]) / 2
        assert (numpy.linalg.norm(middles - V[60], axis=1) > line.distance - 1e-3).all()


def test_a_line_is_a_source():
    V, F = plane(10)
    line, = it.isolines(V, F, numpy.int32(60), [3], tolerance=0, chord_tolerance=1e-4)
    distances, _ = it.geodesic_distances_from(V, F, [line.places], tolerance=0)
    assert numpy.allclose(distances, abs(numpy.linalg.norm(V - V[60], axis=1) - 3), rtol=0, atol=2e-4)
    radii = numpy.linalg.norm(V - V[60], axis=1)
    clear = abs(radii - 3) > 1e-3
    assert numpy.array_equal(it.sides_of_curve(V, F, line.places)[clear], numpy.where(radii < 3, 1, -1)[clear])
    assert numpy.allclose(it.signed_distances(V, F, line.places, 0), 3 - radii, rtol=0, atol=2e-4)
    for found in it.offset_curves(V, F, line.places, [1, -1], chord_tolerance=1e-3):
        assert numpy.allclose(numpy.linalg.norm(found.positions - V[60], axis=1), 3 - found.distance, rtol=0, atol=5e-3)
    with pytest.raises(it.InvalidArgumentError, match="does not separate"):
        it.sides_of_curve(V, F, line.places[:5])
    rims = [rim.places for rim in it.offset_curves(V, F, line.places, [1, -1], 0, chord_tolerance=1e-4)]
    assert numpy.allclose(it.signed_distances(V, F, rims, 0), 1 - abs(radii - 3), rtol=0, atol=5e-4)
    with pytest.raises(it.InvalidArgumentError, match="to the left of curve 0 and to the right of curve 1"):
        it.signed_distances(V, F, [line.places, it.isolines(V, F, [60], [1])[0].places])


def test_offset_curves():
    V, F = plane(10)
    # Counterclockwise around a square of 4 by 4, so the left side is inside.
    steps = [(1, 0)] * 4 + [(0, 1)] * 4 + [(-1, 0)] * 4 + [(0, -1)] * 4
    corners = numpy.cumsum([(3, 3)] + steps, axis=0)
    loop = [int(numpy.flatnonzero((V[:, :2] == c).all(axis=1))[0]) for c in corners]
    places = []
    for v, w in zip(loop, loop[1:]):
        f = numpy.flatnonzero((F == v).any(axis=1) & (F == w).any(axis=1))[0]
        places.append([f, *(F[f] == v)])
    f = int(places[-1][0])
    places.append([f, *(F[f] == loop[-1])])
    lines = it.offset_curves(V, F, numpy.array(places, float), [1, -1], tolerance=0, chord_tolerance=1e-3)
    inner, = (line for line in lines if line.distance == 1)
    outer, = (line for line in lines if line.distance == -1)
    assert numpy.allclose(abs(inner.positions - V[60]).max(axis=1), 1, rtol=0, atol=1e-12)
    beyond = numpy.maximum(abs(outer.positions - V[60])[:, :2] - 2, 0)
    assert numpy.allclose(numpy.linalg.norm(beyond, axis=1), 1, rtol=0, atol=1e-12)


def test_borders_of_cells():
    V, F = plane(10)
    line, = it.borders_of_cells(V, F, [0, 10], tolerance=0)
    assert line.sources == (0, 1)
    assert numpy.allclose(line.positions[:, 0], 5, rtol=0, atol=1e-13)
    line, = it.borders_of_cells(V, F, [0, 10], tolerance=0, offsets=[2, 0])
    a, b = numpy.linalg.norm(line.positions - V[0], axis=1), numpy.linalg.norm(line.positions - V[10], axis=1)
    assert numpy.allclose(a + 2, b, rtol=0, atol=1e-12)


def test_farthest_vertices():
    V, F = plane(10)
    vertices, distances = it.farthest_vertices(V, F, 3, [0], tolerance=0)
    assert vertices[0] == 120
    assert set(vertices) == {120, 10, 110}
    assert numpy.allclose(distances, [numpy.sqrt(200), 10, 10])
    assert it.farthest_vertices(V, F, 1)[0].tolist() == [0]


def test_wrong_arguments():
    V, F = plane(2)
    with pytest.raises(it.InvalidArgumentError, match="positive"):
        it.isolines(V, F, 0, [-1])
    with pytest.raises(it.InvalidArgumentError, match="other than 0"):
        it.offset_curves(V, F, [[0, 1, 0, 0], [0, 0, 0, 1]], [0])
    with pytest.raises(it.InvalidArgumentError, match="does not separate"):
        it.offset_curves(V, F, [[0, 1, 0, 0], [0, 0, 0, 1]], [0.1])
    with pytest.raises(it.InvalidArgumentError, match="nothing lies to the right"):
        it.signed_distances(V, F, [[0, 1, 0, 0], [0, 0, 1, 0]])
    with pytest.raises(it.InvalidArgumentError, match="one in .* of the distances would do"):
        it.isolines(V, F, [0], numpy.arange(1, 100000) * 1e-5)
    with pytest.raises(it.InvalidArgumentError, match="sources is empty"):
        it.isolines(V, F, [], [1])
    with pytest.raises(ValueError, match="chord_tolerance"):
        it.isolines(V, F, [0], [1], chord_tolerance=0)
    with pytest.raises(ValueError, match="finite"):
        it.isolines(V, F, [0], [numpy.nan])
    with pytest.raises(ValueError, match="number"):
        it.farthest_vertices(V, F, -1)
