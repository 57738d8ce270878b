# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The same calls of the packages whose names ours have, where they are installed.

import numpy
import pytest
import scipy.sparse.linalg

import intrinsic_triangulations as it
from conftest import grid, icosphere


@pytest.fixture(params=["ellipsoid", "sheet"])
def surface(request):
    random = numpy.random.default_rng(0)
    V, F = icosphere(4) if request.param == "ellipsoid" else grid(40)
    V = V * ((1, 2, 0.5) if request.param == "ellipsoid" else (1, 0.3, 1))
    return V + 0.01 * random.normal(size=V.shape), F


def test_laplacians(surface):
    robust_laplacian = pytest.importorskip("robust_laplacian")
    V, F = surface
    for ours, theirs in zip(it.mesh_laplacian(V, F), robust_laplacian.mesh_laplacian(V, F)):
        assert abs(ours - theirs).max() < 1e-12 * abs(theirs).max()
    L, M = it.mesh_laplacian(V, F)
    features = scipy.sparse.linalg.eigsh(L, 10, M, sigma=-1e-8)[0]
    L, M = robust_laplacian.mesh_laplacian(V, F)
    assert features == pytest.approx(scipy.sparse.linalg.eigsh(L, 10, M, sigma=-1e-8)[0], rel=1e-6, abs=1e-9)


def test_any_triangles_and_points():
    robust_laplacian = pytest.importorskip("robust_laplacian")
    random = numpy.random.default_rng(0)
    V = random.normal(size=(60, 3))
    F = numpy.array([random.choice(60, 3, replace=False) for _ in range(150)])
    for ours, theirs in zip(it.mesh_laplacian(V, F), robust_laplacian.mesh_laplacian(V, F)):
        assert abs(ours - theirs).max() < 1e-12 * abs(theirs).max()
    V = icosphere(3)[0]
    for ours, theirs in zip(it.point_cloud_laplacian(V), robust_laplacian.point_cloud_laplacian(V)):
        assert abs(ours - theirs).max() < 1e-12 * abs(theirs).max()


def test_distances(surface):
    potpourri3d = pytest.importorskip("potpourri3d")
    theirs = potpourri3d.MeshHeatMethodDistanceSolver(*surface).compute_distance(3)
    ours = it.MeshHeatMethodDistanceSolver(*surface, keeps_ridges=False).compute_distance(3)
    # It adds 1e-6 to its matrix.
    assert abs(ours - theirs).max() < 1e-3 * theirs.max()


def test_tangent_vectors(surface):
    potpourri3d = pytest.importorskip("potpourri3d")
    ours, theirs = it.MeshVectorHeatSolver(*surface), potpourri3d.MeshVectorHeatSolver(*surface)
    # The normals are the same; the axes are not.
    frames, their_frames = ours.get_tangent_frames(), theirs.get_tangent_frames()
    vector = 0.6 * frames[0][7] + 0.8 * frames[1][7]
    one = ours.transport_tangent_vector(7, [0.6, 0.8])
    two = theirs.transport_tangent_vector(7, [vector @ their_frames[0][7], vector @ their_frames[1][7]])
    a, b = (v[:, :1] * f[0] + v[:, 1:] * f[1] for v, f in ((one, frames), (two, their_frames)))
    assert numpy.median((a * b).sum(axis=1)) > 0.99


def test_lines(surface):
    potpourri3d = pytest.importorskip("potpourri3d")
    one, two = it.EdgeFlipGeodesicSolver(*surface), potpourri3d.EdgeFlipGeodesicSolver(*surface)
    for target in range(10, 400, 39):
        ours, theirs = (numpy.linalg.norm(numpy.diff(s.find_geodesic_path(0, target), axis=0), axis=1).sum() for s in (one, two))
        assert ours == pytest.approx(theirs, rel=1e-9)
    ours, theirs = (t(*surface).trace_geodesic_from_face(5, [0.3, 0.3, 0.4], [0.5, 0.4, 0.3])
                    for t in (it.GeodesicTracer, potpourri3d.GeodesicTracer))
    assert numpy.allclose(ours, theirs, atol=1e-9)
