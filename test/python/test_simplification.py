# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Simplified surfaces, and distances by way of them.

import pickle

import numpy
import pytest

import intrinsic_triangulations as it


def bumpy_sheet(n=15):
    x, y = numpy.meshgrid(numpy.arange(n), numpy.arange(n))
    V = numpy.stack([x.ravel(), y.ravel(), 0.5 * numpy.sin(x.ravel()) * numpy.cos(0.7 * y.ravel())], axis=1)
    i = numpy.arange(n * n).reshape(n, n)
    a, b, c, d = (k.ravel() for k in (i[:-1, :-1], i[:-1, 1:], i[1:, 1:], i[1:, :-1]))
    return V, numpy.concatenate([numpy.stack([a, b, c], axis=1), numpy.stack([a, c, d], axis=1)])


def test_the_simplified_surface():
    V, F = bumpy_sheet()
    s = it.Triangulation(V, F).simplify(maximum_change=0.1)
    n, c = len(V), s.triangulation.number_of_vertices
    assert 4 <= c < n / 2 and len(s.kept) == c
    assert 1 / 1.1 <= s.shrink < 1 < s.stretch <= 1.1
    faces, coordinates = s.places
    assert faces.shape == (n,) and faces.min() >= 0 and faces.max() < s.triangulation.number_of_faces
    assert coordinates.shape == (n, 3) and coordinates.min() >= 0
    assert s.prolongation.shape == (n, c)
    assert s.reasons["by_bound"] > 0 and sum(s.reasons.values()) == c
    assert it.Triangulation(V, F).simplify(number_of_vertices=50).reasons["by_number"] > 0
    assert numpy.allclose(s.prolongation @ numpy.ones(c), 1)
    # Vertices that remain are where they are.
    assert numpy.array_equal(s.prolongation[s.kept] @ numpy.arange(c), numpy.arange(c))
    # The places are points of the input of the triangulation.
    there, _ = s.triangulation.common_subdivision().to_intrinsic(faces, coordinates)
    assert there.max() < s.triangulation.number_of_faces


def test_values_of_a_refined_surface_return():
    V, F = bumpy_sheet()
    s = it.Triangulation(V, F).simplify(maximum_change=0.1)
    assert abs(s.prolongation_from(s.triangulation) - s.prolongation).max() < 1e-14
    refined = s.triangulation.copy()
    refined.refine(minimum_angle=25, maximum_edge_length=1)
    assert refined.number_of_vertices > s.triangulation.number_of_vertices
    matrix = s.prolongation_from(refined)
    assert matrix.shape == (len(V), refined.number_of_vertices) and matrix.min() >= 0
    assert numpy.allclose(matrix.sum(axis=1), 1)
    # Vertices that remain have the first numbers, and nearby values for functions of the place on the input.
    values = numpy.random.default_rng(1).normal(size=s.triangulation.number_of_vertices)
    at_all = refined.common_subdivision().from_input(values)[:refined.number_of_vertices]
    found = matrix @ at_all
    assert numpy.array_equal(found[s.kept], values)
    assert abs(found - s.prolongation @ values).max() < 0.5 * numpy.ptp(values)


def test_values_come_from_a_triangulation_of_the_simplified_surface_alone():
    V, F = bumpy_sheet()
    t = it.Triangulation(V, F)
    s = t.simplify(maximum_change=0.1)
    for other in (t, s.triangulation.simplify(maximum_change=0.5).triangulation):
        with pytest.raises(it.InvalidArgumentError, match="vertices, where the simplified surface has"):
            s.prolongation_from(other)


def test_the_right_side_keeps_what_lies_between_the_vertices_that_are_left():
    V, F = bumpy_sheet(30)
    t = it.Triangulation(V, F)
    s = t.simplify(maximum_change=0.2)
    s.triangulation.refine()
    P = s.prolongation_from(s.triangulation)
    f = numpy.zeros(len(V))
    f[next(v for v in range(len(V)) if v not in s.kept)] = 1
    b = P.T @ (t.mass * f)
    assert abs(b.sum() - t.mass @ f) < 1e-12 * b.sum()
    L, M = s.triangulation.laplacian()
    assert len(b) == L.shape[0]


def test_the_default_is_five_percent_or_the_number():
    V, F = bumpy_sheet()
    t = it.Triangulation(V, F)
    assert t.simplify().stretch <= 1.05
    assert t.simplify(number_of_vertices=30).triangulation.number_of_vertices == 30
    assert t.simplify(0, number_of_vertices=30).triangulation.number_of_vertices > 30


def test_vertices_and_edges_are_kept():
    V, F = bumpy_sheet()
    t = it.Triangulation(V, F)
    kept = numpy.zeros(len(V), bool)
    kept[[40, 100]] = True
    assert {40, 100} <= set(t.simplify(1, kept=kept).kept.tolist())
    assert t.simplify(1, sharp_angle=10).triangulation.number_of_vertices > t.simplify(1).triangulation.number_of_vertices
    with pytest.raises(ValueError):
        t.simplify(kept=kept[1:])
    with pytest.raises(ValueError):
        t.simplify(-1)
    with pytest.raises(it.InvalidArgumentError):
        it.Triangulation.from_lengths([[0, 1, 2]], [[3, 4, 5]]).simplify(sharp_angle=30)


def test_it_can_be_sent():
    V, F = bumpy_sheet()
    s = it.Triangulation(V, F).simplify()
    u = pickle.loads(pickle.dumps(s))
    assert numpy.array_equal(u.triangulation.lengths, s.triangulation.lengths)
    assert numpy.array_equal(u.kept, s.kept) and (u.shrink, u.stretch) == (s.shrink, s.stretch)
    assert (u.prolongation != s.prolongation).nnz == 0


def test_an_isolated_vertex_is_nowhere():
    V, F = bumpy_sheet()
    s = it.Triangulation(numpy.concatenate([V, [[50, 50, 50]]]), F).simplify()
    assert s.places[0][-1] == -1
    assert s.prolongation[-1].nnz == 0


def test_intervals_contain_exact_distances():
    V, F = bumpy_sheet()
    d = it.SimplifiedDistances(V, F, 0.1)
    for source in (0, 37, [3, 200]):
        found, exact = d.distances(source), it.geodesic_distances(V, F, source, tolerance=0)
        assert (found.lower <= exact * (1 + 1e-9)).all() and (found.upper >= exact * (1 - 1e-9)).all()
        assert (found.upper <= 1.21 * found.lower * (1 + 1e-9)).all()
        assert not numpy.array_equal(found.distances, exact)
    again = pickle.loads(pickle.dumps(d))
    assert numpy.array_equal(again.distances(5).lower, d.distances(5).lower)
    with pytest.raises(ValueError):
        d.distances(len(V))
