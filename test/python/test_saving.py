# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What is kept in files, sent to other processes, and copied, answers alike.

import copy
import multiprocessing
import pickle

import numpy
import pytest

import intrinsic_triangulations as it
from conftest import grid, icosphere


def same(t, u):
    assert t.faces.tolist() == u.faces.tolist()
    for name in ("lengths", "weights", "areas", "angles"):
        assert getattr(t, name).tobytes() == getattr(u, name).tobytes(), name
    for a, b in zip(t.inserted_vertices, u.inserted_vertices):
        assert a.tobytes() == b.tobytes()


def triangulations():
    V, F = grid(7, 1.3)
    t = it.Triangulation(V, F)
    yield t
    t = t.copy()
    t.flip_to_delaunay()
    yield t
    t = t.copy()
    t.refine(maximum_edge_length=0.4)
    assert t.number_of_vertices > len(V)
    yield t
    t = it.Triangulation.from_gluing([[0, 3], [1, 4], [2, 5]], [[3, 4, 5], [3, 4, 5]])
    yield t


@pytest.mark.parametrize("number", range(4))
def test_pickles_and_files(number, tmp_path):
    t = list(triangulations())[number]
    t.save(tmp_path / "t.idt")
    for u in (pickle.loads(pickle.dumps(t)), it.Triangulation.load(tmp_path / "t.idt"), copy.copy(t), copy.deepcopy(t)):
        same(t, u)
        v = t.copy()
        assert u.flip_to_delaunay() == v.flip_to_delaunay()
        same(u, v)
    if number < 3:
        assert it.Triangulation.load(tmp_path / "t.idt").positions.tobytes() == t.positions.tobytes()
        assert not pickle.loads(pickle.dumps(t))._points.flags.writeable
    else:
        with pytest.raises(ValueError):
            it.Triangulation.load(tmp_path / "t.idt").positions


class Named(it.Triangulation):
    pass


def test_copies_keep_the_class_and_what_it_has():
    t = Named(*icosphere(1))
    t.names = ["a", "b"]
    for u in (copy.copy(t), copy.deepcopy(t), pickle.loads(pickle.dumps(t))):
        assert type(u) is Named and u.names == t.names
    assert copy.copy(t).names is t.names and copy.deepcopy(t).names is not t.names


def test_subdivisions():
    for t in triangulations():
        s = t.common_subdivision()
        u = pickle.loads(pickle.dumps(s))
        assert u.corners.tobytes() == s.corners.tobytes() and u.offsets.tobytes() == s.offsets.tobytes()
        if t._points is not None:
            assert u.positions.tobytes() == s.positions.tobytes()


def test_solvers():
    V, F = icosphere(2)
    t = it.Triangulation(V, F)
    t.flip_to_delaunay()
    for solver in (it.MeshHeatMethodDistanceSolver(V, F, 2.0, boundary="dirichlet"), it.MeshHeatMethodDistanceSolver(V, F, use_robust=False),
                   it.MeshHeatMethodDistanceSolver.from_triangulation(t)):
        assert pickle.loads(pickle.dumps(solver)).compute_distance(3).tobytes() == solver.compute_distance(3).tobytes()
    solver = it.MeshVectorHeatSolver(V, F)
    assert pickle.loads(pickle.dumps(solver)).compute_log_map(3).tobytes() == solver.compute_log_map(3).tobytes()
    for cls, call in ((it.EdgeFlipGeodesicSolver, lambda s: s.find_geodesic_path(0, 20)),
                      (it.GeodesicTracer, lambda s: s.trace_geodesic_from_vertex(0, [1.0, 2.0, 3.0]))):
        solver = cls(V, F)
        assert call(pickle.loads(pickle.dumps(solver))).tobytes() == call(solver).tobytes()


def lengths_of(t):
    return t.lengths


def test_another_process():
    t = list(triangulations())[2]
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.apply(lengths_of, (t,)).tobytes() == t.lengths.tobytes()


def test_workers_of_dask():
    distributed = pytest.importorskip("distributed", reason="skipped: there is no package distributed (on Debian: apt install python3-distributed)")
    t = list(triangulations())[2]
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, distributed.Client(cluster) as client:
        one, two = client.scheduler_info()["workers"]
        there = client.submit(it.Triangulation.copy, t, workers=[one])
        assert client.submit(lengths_of, there, workers=[two]).result().tobytes() == t.lengths.tobytes()


def test_bytes_are_not_believed(tmp_path):
    t = list(triangulations())[2]
    t.save(tmp_path / "t.idt")
    content = bytearray((tmp_path / "t.idt").read_bytes())
    random = numpy.random.default_rng(1)
    begin = content.index(b"end_header") + 11
    for _ in range(300):
        changed = bytearray(content)
        for _ in range(random.integers(1, 4)):
            changed[random.integers(begin, len(changed))] = random.integers(256)
        (tmp_path / "u.idt").write_bytes(changed)
        try:
            u = it.Triangulation.load(tmp_path / "u.idt")
        except it.Error as error:
            assert "u.idt" in str(error)
        else:
            assert u.verify().inverted.size == 0
    with pytest.raises(it.Error):
        it.Triangulation.load(tmp_path / "nothing.idt")
    with pytest.raises(it.Error):
        t.save(tmp_path / "no_folder" / "t.idt")


@pytest.mark.parametrize("name", ["t.off", "t.ply", "t", "idt"])
def test_a_name_of_another_format_is_refused(tmp_path, name):
    t = list(triangulations())[0]
    with pytest.raises(it.InvalidArgumentError, match=f"has to end with .idt, not .*{name}.*write_mesh"):
        t.save(tmp_path / name)
    assert not list(tmp_path.iterdir())
