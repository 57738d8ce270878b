# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Tangent vectors and logarithmic maps.

import numpy
import pytest

import intrinsic_triangulations as it
from conftest import grid, icosphere


@pytest.fixture
def solver_on_sphere():
    V, F = icosphere(3)
    return it.MeshVectorHeatSolver(V, F), V


def in_space(frames, vectors):
    return vectors[:, :1] * frames[0] + vectors[:, 1:] * frames[1]


def test_frames(solver_on_sphere):
    solver, V = solver_on_sphere
    x, y, normal = solver.get_tangent_frames()
    for one, two in ((x, y), (y, normal), (normal, x)):
        assert abs((one * two).sum(axis=1)).max() < 1e-14
    assert numpy.allclose(numpy.cross(x, y), normal) and abs(normal - V).max() < 0.05
    x[:] = 0
    assert solver.get_tangent_frames()[0].any()


def test_parallel_in_a_plane():
    V, F = grid(12, shear=0.6)
    solver = it.MeshVectorHeatSolver(V, F)
    frames = solver.get_tangent_frames()
    found = solver.transport_tangent_vector(70, [3, -4])
    expected = in_space(frames, numpy.tile([[3.0, -4.0]], (len(V), 1)))[70]
    assert numpy.allclose(in_space(frames, found), expected, atol=1e-9)
    logarithms = in_space([f[70][None] for f in frames], solver.compute_log_map(70))
    assert numpy.allclose(logarithms, V - V[70], atol=1e-8)


def test_transport_on_a_sphere(solver_on_sphere):
    solver, V = solver_on_sphere
    found = solver.transport_tangent_vector(0, (1, 0))
    assert numpy.array_equal(found[0], [1, 0])
    assert numpy.allclose(numpy.linalg.norm(found, axis=1), 1, atol=1e-6)
    # Along the great circle of the vector, it stays a tangent of that.
    frames = solver.get_tangent_frames()
    direction = in_space(frames, found)
    axis = numpy.cross(V[0], direction[0])
    near = (abs(V @ axis) < 0.05) & (V @ V[0] > -0.5)
    tangent = numpy.cross(axis, V[near])
    tangent /= numpy.linalg.norm(tangent, axis=1)[:, None]
    assert near.sum() > 10 and ((direction[near] * tangent).sum(axis=1) > 0.99).all()


def test_log_map_on_a_sphere(solver_on_sphere):
    solver, V = solver_on_sphere
    angles = numpy.arccos(numpy.clip(V @ V[5], -1, 1))
    found = solver.compute_log_map(5)
    near = angles < 1.5
    assert abs(numpy.linalg.norm(found, axis=1) - angles)[near].max() < 0.05
    frames = [f[5] for f in solver.get_tangent_frames()]
    direction = found[:, :1] * frames[0] + found[:, 1:] * frames[1]
    expected = V - (V @ V[5])[:, None] * V[5]
    cosines = (direction * expected).sum(axis=1)[near & (angles > 0)]
    cosines /= (numpy.linalg.norm(direction, axis=1) * numpy.linalg.norm(expected, axis=1))[near & (angles > 0)]
    assert cosines.min() > 0.99


def test_several_sources(solver_on_sphere):
    solver, V = solver_on_sphere
    other = int(numpy.argmin(V @ V[0]))
    found = solver.transport_tangent_vectors([0, other], [[1, 0], [0, 3]])
    assert numpy.array_equal(found[[0, other]], [[1, 0], [0, 3]])
    lengths = numpy.linalg.norm(found, axis=1)
    assert abs(lengths[V @ V[0] > 0.5] - 1).max() < 0.1 and abs(lengths[V @ V[0] < -0.5] - 3).max() < 0.1
    extended = solver.extend_scalar([0, other], [1, 3])
    assert abs(extended - lengths)[abs(V @ V[0]) > 0.5].max() < 0.1


def test_connection_laplacian(solver_on_sphere):
    solver, V = solver_on_sphere
    L = solver.get_connection_laplacian()
    assert L.shape == (len(V), len(V)) and L.dtype == complex
    assert abs(L - L.conj().T).max() < 1e-13
    # No tangent field on a sphere is parallel everywhere.
    assert numpy.linalg.eigvalsh(L.toarray()).min() > 1e-4


def test_bad_arguments(solver_on_sphere):
    solver, V = solver_on_sphere
    for call in (lambda: solver.transport_tangent_vector(-1, [1, 0]), lambda: solver.transport_tangent_vector(0, [1, 0, 0]),
                 lambda: solver.transport_tangent_vector(0, [numpy.nan, 0]), lambda: solver.transport_tangent_vector(0.0, [1, 0]),
                 lambda: solver.transport_tangent_vectors([0, 0], [[1, 0], [0, 1]]),
                 lambda: solver.transport_tangent_vectors([0, len(V)], [[1, 0], [0, 1]]),
                 lambda: solver.transport_tangent_vectors([0], [[1, 0], [0, 1]]), lambda: solver.compute_log_map(len(V)),
                 lambda: solver.compute_log_map(0, "Fast"), lambda: solver.extend_scalar([0, 1], [1]),
                 lambda: it.MeshVectorHeatSolver(*icosphere(1), t_coef=0), lambda: it.MeshVectorHeatSolver(*icosphere(1), 1.0, False)):
        with pytest.raises(ValueError):
            call()


def test_no_heat_arrives(sphere):
    with pytest.raises(it.NumericalError, match="too little heat"):
        it.MeshVectorHeatSolver(*sphere, t_coef=1e-300).compute_log_map(0)
