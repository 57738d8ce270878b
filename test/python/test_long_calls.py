# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Long calls: Ctrl-C ends them, and other threads go on.

import os
import signal
import subprocess
import sys
import textwrap
import threading
import time

import numpy
import pytest

import intrinsic_triangulations as it
from conftest import grid

TESTS = os.path.dirname(__file__)


@pytest.mark.skipif(os.name != "posix", reason="there are no POSIX signals")
@pytest.mark.parametrize("call", [
    "t = it.Triangulation(*grid(300)); call = lambda: t.refine(30, maximum_edge_length=0.02, max_insertions=10**9)",
    "V, F = grid(500, 30.0); call = lambda: it.laplacian(V, F)",
    "t = it.Triangulation(*grid(500, 30.0)); call = lambda: t.flip_to_delaunay()",
    "t = it.Triangulation(*grid(800, 5.0)); t.flip_to_delaunay(); call = lambda: t.verify()",
    "V, F = grid(500); F[::2] = F[::2, ::-1]; call = lambda: it.repair(V, F)",
    "V, _ = grid(150, 0.3); call = lambda: it.point_cloud_laplacian(V)",
    "V, F = grid(150, 30.0); t = it.Triangulation(V, F); call = lambda: t.straight_mesh(maximum_deviation=0.05)",
    "s = it.MeshHeatMethodDistanceSolver(*grid(250)); call = lambda: s.compute_distance_multisource(range(0, 60000, 2000))"])
def test_ctrl_c(call):
    program = textwrap.dedent(f"""
        import os, signal, threading, time
        import intrinsic_triangulations as it
        from conftest import grid
        signal.signal(signal.SIGINT, signal.default_int_handler)  # in the background it is ignored
        {call}
        sent = []
        def send():
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)
        threading.Timer(0.3, send).start()
        try:
            call()
            print("finished before")
        except KeyboardInterrupt:
            print("interrupted", time.monotonic() - sent[0])
        """)
    done = subprocess.run([sys.executable, "-c", program], cwd=TESTS, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("interrupted"), done.stdout
    assert float(done.stdout.split()[1]) < 2


def test_an_interrupted_triangulation_is_valid():
    V, F = grid(60, 30.0)
    t = it.Triangulation(V, F)

    class Stop(Exception):
        pass

    def handler(*_):
        raise Stop

    before = signal.signal(signal.SIGALRM, handler)
    try:
        for delay in (0.005, 0.01, 0.02, 0.04, 0.06, 0.1, 0.15):
            signal.setitimer(signal.ITIMER_REAL, delay)
            try:
                t.flip_to_delaunay()
            except Stop:
                pass
            finally:
                signal.setitimer(signal.ITIMER_REAL, 0)
    finally:
        signal.signal(signal.SIGALRM, before)
    assert t.areas.sum() == pytest.approx(59 * 59)
    assert t.flip_to_delaunay().is_delaunay and t.verify().is_delaunay


def test_a_heat_solver_goes_on_after_an_interruption():
    solver = it.MeshHeatMethodDistanceSolver(*grid(120))
    sources = range(0, 14400, 500)

    class Stop(Exception):
        pass

    def handler(*_):
        raise Stop

    before = signal.signal(signal.SIGALRM, handler)
    stops = 0
    try:
        for delay in (0.005, 0.01, 0.02, 0.04, 0.06, 0.1, 0.15):
            signal.setitimer(signal.ITIMER_REAL, delay)
            try:
                solver.compute_distance_multisource(sources)
            except Stop:
                stops += 1
            finally:
                signal.setitimer(signal.ITIMER_REAL, 0)
    finally:
        signal.signal(signal.SIGALRM, before)
    assert stops > 0
    expected = it.MeshHeatMethodDistanceSolver(*grid(120)).compute_distance_multisource(sources)
    assert numpy.allclose(solver.compute_distance_multisource(sources), expected, rtol=1e-12, atol=1e-12)


def test_refinement_at_the_tips_of_needles_ends():
    """A vertex far away makes corners that doubles do not resolve: each step is short all the same."""
    V, F = grid(4)
    V[10, 0] = 2.0**31
    t = it.Triangulation(V, F)
    t.refine(25, max_insertions=1)
    constrained = numpy.zeros(t.number_of_edges, dtype=bool)
    constrained[::5] = True
    t.refine(25, max_insertions=42, constrained=constrained)
    assert t.number_of_vertices <= 16 + 43 and numpy.isfinite(t.lengths).all()


def test_other_threads_go_on():
    t = it.Triangulation(*grid(300, 10.0))
    thread = threading.Thread(target=t.flip_to_delaunay)
    thread.start()
    steps = 0
    while thread.is_alive():
        steps += 1
        time.sleep(0.001)
    assert steps > 20


def test_calls_of_several_threads_on_one_object():
    V, F = grid(40, 10.0)
    t = it.Triangulation(V, F)
    solver = it.MeshHeatMethodDistanceSolver(V, F)
    paths = it.EdgeFlipGeodesicSolver(V, F)
    expected = solver.compute_distance(7), paths.find_geodesic_path(0, 555)
    errors = []

    def work(number):
        try:
            for i in range(10):
                t.flip_to_delaunay(max_flips=50)
                assert len(t.faces) == len(F) and len(t.lengths) == t.number_of_edges
                t.copy().common_subdivision().to_input([0], [[1, 2, 3]])
                assert numpy.array_equal(solver.compute_distance(7), expected[0])
                assert numpy.array_equal(paths.find_geodesic_path(0, 555), expected[1])
        except BaseException as error:
            errors.append(error)

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not errors
    t.flip_to_delaunay()
    assert t.verify().is_delaunay
