# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The operators, against independent sums and known eigenvalues.

import numpy
import pytest
import scipy.sparse
import scipy.sparse.linalg

import intrinsic_triangulations as it
from conftest import grid, icosphere


def cotangent_laplacian(V, F):
    """that of the triangles as they are, by the textbook."""
    L = numpy.zeros((len(V), len(V)))
    for i in range(3):
        a, b, c = V[F[:, i]], V[F[:, (i + 1) % 3]], V[F[:, (i + 2) % 3]]
        cotangents = ((a - c) * (b - c)).sum(axis=1) / numpy.linalg.norm(numpy.cross(a - c, b - c), axis=1) / 2
        for p, q, sign in ((i, i, 1), ((i + 1) % 3, (i + 1) % 3, 1), (i, (i + 1) % 3, -1), ((i + 1) % 3, i, -1)):
            numpy.add.at(L, (F[:, p], F[:, q]), sign * cotangents)
    return L


def test_a_delaunay_surface_has_the_operator_of_the_textbook(sphere):
    V, F = sphere
    L, M = it.laplacian(V, F)
    assert isinstance(L, scipy.sparse.csc_matrix) and isinstance(M, scipy.sparse.csc_matrix)
    assert numpy.allclose(L.toarray(), cotangent_laplacian(V, F), atol=1e-13)
    areas = numpy.linalg.norm(numpy.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]]), axis=1) / 2
    expected = numpy.bincount(F.ravel(), numpy.repeat(areas / 3, 3))
    assert numpy.allclose(M.diagonal(), expected, rtol=1e-13)
    assert M.nnz == len(V)


def test_properties_on_a_thin_surface(thin):
    V, F = thin
    L, M = it.laplacian(V, F)
    assert abs(L - L.T).max() == 0
    assert abs(L.sum(axis=1)).max() < 1e-11 * abs(L).max()
    off_diagonal = (L - scipy.sparse.diags(L.diagonal())).tocoo()
    assert off_diagonal.data.max() <= 0
    assert cotangent_laplacian(V, F)[~numpy.eye(len(V), dtype=bool)].max() > 0.01  # the textbook has positive entries
    assert L.has_sorted_indices and (numpy.diff(L.indices)[numpy.diff(L.indices) <= 0].size < len(V))


def test_galerkin_mass(sphere):
    V, F = sphere
    _, lumped = it.laplacian(V, F)
    _, galerkin = it.laplacian(V, F, mass="galerkin")
    assert numpy.allclose(galerkin.sum(axis=1).ravel(), lumped.diagonal(), rtol=1e-12)
    assert galerkin.nnz > lumped.nnz


def test_eigenvalues_of_the_sphere():
    L, M = it.mesh_laplacian(*icosphere(4))
    found = scipy.sparse.linalg.eigsh(L, 9, M, sigma=-0.01)[0]
    assert numpy.allclose(found, [0, 2, 2, 2, 6, 6, 6, 6, 6], rtol=0.01, atol=1e-9)


def test_any_triangles():
    random = numpy.random.default_rng(2)
    V = random.normal(size=(40, 3))
    F = numpy.array([random.choice(40, 3, replace=False) for _ in range(120)])
    L, M = it.laplacian(V, F)
    assert numpy.linalg.eigvalsh(L.toarray()).min() > -1e-12 * abs(L).max()
    areas = numpy.linalg.norm(numpy.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]]), axis=1) / 2
    assert M.sum() == pytest.approx(areas.sum(), rel=1e-12)


def test_unused_vertices():
    V, F = grid(4)
    V = numpy.concatenate([V, [[9, 9, 9]]])
    L, M = it.laplacian(V, F)
    assert abs(L[-1]).sum() == 0 and M[-1, -1] == 0
    L, M = it.mesh_laplacian(V, F)
    assert L[-1, -1] == 1 and M[-1, -1] == pytest.approx(1e-3 * M.diagonal()[:-1].min())
    scipy.sparse.linalg.splu((L + 1e-8 * M).tocsc())


def test_mollification():
    V = [[0, 0, 0], [1, 0, 0], [0.5, 1e-9, 0]]
    exact = it.mesh_laplacian(V, [[0, 1, 2]], mollify_factor=0)[1].sum()
    assert exact == pytest.approx(5e-10)
    assert it.mesh_laplacian(V, [[0, 1, 2]], mollify_factor=1e-2)[1].sum() > 1e-2
    for bad in (-1, numpy.nan, numpy.inf, "1", None, [1]):
        with pytest.raises(ValueError):
            it.mesh_laplacian(V, [[0, 1, 2]], bad)


def test_a_point_cloud():
    V, _ = icosphere(3)
    L, M = it.point_cloud_laplacian(V)
    assert abs(L.sum(axis=1)).max() < 1e-11
    assert M.sum() == pytest.approx(4 * numpy.pi, rel=0.02)
    V = numpy.concatenate([V, V[:1]])
    L, M = it.point_cloud_laplacian(V, n_neighbors=20)
    assert L[-1, -1] == 1 and 0 < M[-1, -1] < M.diagonal()[:-1].min()
    for bad in (1, -3, 2.5, None, "30"):
        with pytest.raises(ValueError):
            it.point_cloud_laplacian(V, n_neighbors=bad)
    with pytest.raises(it.InvalidSurfaceError, match="on a line"):
        it.point_cloud_laplacian([[0, 0, 0], [1, 0, 0], [2, 0, 0]])
    with pytest.raises(ValueError):
        it.laplacian(*icosphere(0), mass="none")
