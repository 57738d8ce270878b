# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Arrays of any type, order and strides; what is refused, and how.

import numpy
import pytest

import intrinsic_triangulations as it


def matrices(V, F):
    L, M = it.laplacian(V, F)
    return L.toarray(), M.toarray()


@pytest.fixture
def whole(sphere):
    """with coordinates that every type can hold."""
    V, F = sphere
    return numpy.round(V * 100), F


@pytest.mark.parametrize("type", ["int16", "int32", "int64", "float16", "float32", "float64", "longdouble", ">f8", ">i4"])
def test_types_of_points(whole, type):
    V, F = whole
    for a, b in zip(matrices(V, F), matrices(V.astype(type), F)):
        assert numpy.array_equal(a, b)


@pytest.mark.parametrize("type", ["uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", ">i8"])
def test_types_of_indices(whole, type):
    V, F = whole
    for a, b in zip(matrices(V, F), matrices(V, F.astype(type))):
        assert numpy.array_equal(a, b)


def test_layouts(whole):
    V, F = whole
    expected = matrices(V, F)
    wide = numpy.full((len(V), 7), numpy.nan)
    wide[:, ::3] = V
    raw = numpy.zeros(V.nbytes + 1, dtype=numpy.uint8)
    unaligned = raw[1:].view(numpy.float64).reshape(V.shape)
    unaligned[:] = V
    read_only = V.copy()
    read_only.flags.writeable = False
    for points in (numpy.asfortranarray(V), wide[:, ::3], V[::-1].copy()[::-1], unaligned, read_only, V.tolist()):
        for faces in (F, numpy.asfortranarray(F), F[::-1].copy()[::-1], F.tolist()):
            for a, b in zip(expected, matrices(points, faces)):
                assert numpy.array_equal(a, b)


def test_arguments_are_not_changed(thin):
    V, F = thin
    before = V.copy(), F.copy()
    t = it.Triangulation(V, F)
    t.flip_to_delaunay()
    t.positions[:] = 0
    assert numpy.array_equal(V, before[0]) and numpy.array_equal(F, before[1])
    assert numpy.array_equal(t.positions, V)
    V[:] = 0
    assert numpy.array_equal(t.positions, before[0])


def test_results_own_their_memory(sphere):
    t = it.Triangulation(*sphere)
    lengths = t.lengths
    expected = lengths.copy()
    L, M = it.laplacian(*sphere)
    copy = L.copy()
    del t, M
    for _ in range(50):
        it.Triangulation(*sphere).lengths
    assert numpy.array_equal(lengths, expected)
    assert abs(L - copy).nnz == 0


@pytest.mark.parametrize("V", [None, 3, "points", [[0, 0], [1, 0]], [[0, 0, 0], [1, 0]], numpy.zeros((3, 3), dtype=complex),
                               numpy.zeros((3, 3), dtype=bool), numpy.zeros((3, 3), dtype=object), numpy.zeros((3, 3), dtype="U1"),
                               numpy.zeros((3, 3), dtype="M8[s]"), numpy.zeros((3, 4)), numpy.zeros(9), numpy.zeros((3, 3, 1)),
                               numpy.zeros((3, 3), dtype=[("x", float)]),
                               [[2**53 + 1, 0, 0], [1, 0, 0], [0, 1, 0]], numpy.full((3, 3), 2**64 - 1, dtype=numpy.uint64)])
def test_bad_points(V):
    with pytest.raises(ValueError):
        it.laplacian(V, [[0, 1, 2]])
    with pytest.raises(ValueError):
        it.Triangulation(V, [[0, 1, 2]])


@pytest.mark.parametrize("F", [None, [[0, 1]], [[0, 1, 2, 3]], [0, 1, 2], [[0.0, 1.0, 2.0]], [[0, 1, 3]], [[0, 1, -1]],
                               [[0, 1, 2**31]], [[0, 1, 2**32]], [[0, 1, 2**63]], [[0, 1, -2**63]], [[True, False, True]],
                               numpy.zeros((0, 3)), numpy.zeros((0, 3), dtype=int), []])
def test_bad_faces(F):
    V = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    with pytest.raises(ValueError):
        it.laplacian(V, F)
    if numpy.size(F) > 0:
        with pytest.raises(ValueError):
            it.Triangulation(V, F)


def test_a_longdouble_that_is_no_double():
    V = numpy.zeros((3, 3), dtype=numpy.longdouble)
    V[1, 0] = V[2, 1] = 1
    F = [[0, 1, 2]]
    it.laplacian(V, F)
    V[1, 0] += numpy.finfo(numpy.longdouble).eps
    if V[1, 0] != numpy.float64(V[1, 0]):
        with pytest.raises(ValueError, match="doubles cannot hold"):
            it.laplacian(V, F)


def test_errors_tell_the_element():
    V = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, numpy.nan]]
    with pytest.raises(it.InvalidSurfaceError, match=r"F\[1\] names vertex 4, but there are only 4") as caught:
        it.Triangulation(V, [[0, 1, 2], [1, 4, 2]])
    assert (caught.value.defect, caught.value.element, caught.value.count) == ("BAD_INDEX", 1, 1)
    with pytest.raises(it.InvalidSurfaceError, match="vertex 3") as caught:
        it.Triangulation(V, [[0, 1, 2], [2, 1, 3]])
    assert caught.value.defect == "NOT_FINITE"
    assert isinstance(caught.value, it.Error) and isinstance(caught.value, ValueError)


def test_masked_arrays():
    """What is masked is not used all the same."""
    V, F = numpy.eye(3), numpy.array([[0, 1, 2]])
    for bad in (lambda: it.laplacian(numpy.ma.masked_greater(V, 0.5), F), lambda: it.Triangulation(V, numpy.ma.masked_equal(F, 1))):
        with pytest.raises(ValueError, match="masked"):
            bad()
    assert it.Triangulation(numpy.ma.masked_array(V), F).number_of_faces == 1


@pytest.mark.parametrize("angle", [numpy.array([25.0]), [25], numpy.complex128(25), 25j, "25", None])
def test_what_is_no_number(angle):
    with pytest.raises(ValueError, match="minimum_angle has to be a number"):
        it.Triangulation(numpy.eye(3), [[0, 1, 2]]).refine(angle)


@pytest.mark.parametrize("value", [numpy.nan, numpy.inf, -numpy.inf])
def test_values_that_are_not_finite(value, sphere):
    for solver in (it.MeshHeatMethodDistanceSolver, it.MeshVectorHeatSolver):
        with pytest.raises(ValueError, match=r"values\[1\] has to be finite, not"):
            solver(*sphere).extend_scalar([3, 4], [1, value])
