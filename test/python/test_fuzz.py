# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Random arguments to every public function: a call returns, raises a documented exception, or is long and can be
# interrupted; and memory does not grow.
#
# IDT_FUZZ_CALLS says how many calls are made.

import faulthandler
import os
import signal
import warnings

import numpy
import pytest

import intrinsic_triangulations as it
from conftest import grid, icosphere

CALLS = int(os.environ.get("IDT_FUZZ_CALLS", "6000"))
ALLOWED = (ValueError, it.Error)

NUMBERS = (0, 1, -1, 2, 3, 7, 41, 42, 2**31 - 1, 2**31, 2**32 - 1, 2**32, 2**63 - 1, 2**63, 2**64, -2**31, -2**63, 0.5, -0.0, 1e-320,
           1e300, 1e-300, float("nan"), float("inf"), -float("inf"), None, True, "1", b"1", [], (), {}, [1], [[1]], 1j,
           numpy.float32(1), numpy.int8(-1), numpy.uint64(2**64 - 1), numpy.array(3), numpy.array([3]), object())
TYPES = ("int8", "uint8", "int16", "int32", "int64", "uint32", "uint64", "float16", "float32", "float64", "longdouble", "bool", "complex",
         "object", ">i4", ">f8", "U2")


class Maker:
    """makes arguments that are right, nearly right, or nothing of the kind."""

    def __init__(self, seed):
        self.random = numpy.random.default_rng(seed)

    def chance(self, p):
        return self.random.random() < p

    def pick(self, choices):
        return choices[self.random.integers(len(choices))]

    def number(self):
        return self.pick(NUMBERS)

    def spoiled(self, array):
        """with another type, shape, layout, or other numbers."""
        random = self.random
        if self.chance(0.6):
            return array
        for _ in range(1 + random.integers(2)):
            kind = random.integers(9)
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    if kind == 0:
                        array = array.astype(self.pick(TYPES))
                    elif kind == 1 and array.size:
                        array = array.copy()
                        array.reshape(-1)[random.integers(array.size)] = self.pick(NUMBERS[:26])
                    elif kind == 2:
                        array = numpy.asfortranarray(array)
                    elif kind == 3:
                        array = array[tuple(slice(None, None, self.pick((1, -1, 2))) for _ in array.shape)]
                    elif kind == 4:
                        array = array.reshape(self.pick(((-1,), (1, -1), (-1, 1), (-1, 3, 1), (3, -1), (-1, 2))))
                    elif kind == 5:
                        array = array[:random.integers(len(array) + 1)]
                    elif kind == 6:
                        array = array * self.pick((0, 1e160, 1e-170, -1))
                    elif kind == 7:
                        array = numpy.broadcast_to(array[:1], array.shape)
                    else:
                        array = array.view()
                        array.flags.writeable = False
            except (ValueError, TypeError, OverflowError, IndexError):
                pass
        return self.number() if self.chance(0.03) else array.tolist() if self.chance(0.1) else array

    def surface(self):
        kind = self.random.integers(5)
        if kind == 0:
            V, F = icosphere(self.random.integers(2))
        elif kind == 1:
            V, F = grid(2 + self.random.integers(4), self.pick((0.0, 1.0, 7.0)))
        elif kind == 2:
            n = 3 + self.random.integers(8)
            V, F = self.random.normal(size=(n, 3)), self.random.integers(n, size=(self.random.integers(12), 3))
        elif kind == 3:
            V, F = self.random.integers(-2, 3, size=(6, 3)), self.random.permutation(6)[:3][None]
        else:
            V, F = grid(3)
            V = V[:, :] * (1, 1e-9, 1)
        return self.spoiled(V), self.spoiled(F)

    def vertices(self, n=6):
        return self.spoiled(self.random.integers(n, size=self.random.integers(4)))

    def index(self):
        return self.number() if self.chance(0.3) else int(self.random.integers(12))

    def vector(self, n=3):
        return self.spoiled(self.random.normal(size=n))


def call_laplacians(make):
    kind = make.random.integers(5)
    if kind == 0:
        it.laplacian(*make.surface(), **({"mass": make.pick(("galerkin", "lumped", 1))} if make.chance(0.3) else {}))
    elif kind == 1:
        it.mesh_laplacian(*make.surface(), *([make.number()] if make.chance(0.3) else []))
    elif kind == 2:
        assert numpy.isfinite(it.cotan_laplacian(*make.surface(), *([make.number()] if make.chance(0.3) else [])).data).all()
    elif kind == 3:
        make.pick((it.face_areas, it.vertex_areas))(*make.surface())
    else:
        it.point_cloud_laplacian(make.surface()[0], *([make.number()] if make.chance(0.2) else []),
                                 **({"n_neighbors": make.pick((2, 5, make.number()))} if make.chance(0.5) else {}))


def make_triangulation(make):
    kind = make.random.integers(6)
    if kind == 0:
        V, F = make.surface()
        number = F.shape[0] if isinstance(F, numpy.ndarray) and F.ndim > 0 else 1
        return it.Triangulation.from_lengths(F, make.spoiled(numpy.ones((number, 3)) * make.pick((1, 2.5, 1e-3))))
    if kind == 1:
        n = 1 + make.random.integers(4)
        sides = make.random.permutation(3 * n)[:2 * make.random.integers(3 * n // 2 + 1)].reshape(-1, 2)
        return it.Triangulation.from_gluing(make.spoiled(sides), make.spoiled(numpy.ones((n, 3))))
    return it.Triangulation(*make.surface())


def constraint(make, t):
    return {"constrained": make.spoiled(make.random.random(t.number_of_edges) < 0.2)} if make.chance(0.3) else {}


def call_triangulation(make):
    t = make_triangulation(make)
    for _ in range(1 + make.random.integers(4)):
        kind = make.random.integers(8)
        if kind == 0:
            t.flip_to_delaunay(*([make.number()] if make.chance(0.3) else []), **constraint(make, t))
        elif kind == 1:
            t.verify(**constraint(make, t))
        elif kind == 2:
            t.refine(make.pick((20, 25, 30, make.number())), max_insertions=make.pick((0, 5, 20, make.pick(NUMBERS[:8]))), **constraint(make, t))
        elif kind == 3:
            t.laplacian(make.pick(("lumped", "galerkin", make.number())))
        elif kind == 4:
            [getattr(t, name) for name in ("faces", "edges", "face_edges", "lengths", "weights", "areas", "angles", "mass", "inserted_vertices",
                                           "positions")]
        elif kind == 5:
            t = t.copy()
        elif kind == 6:
            it.MeshHeatMethodDistanceSolver.from_triangulation(t).compute_distance(make.index())
        else:
            call_subdivision(make, t.common_subdivision())


def call_subdivision(make, s):
    faces, coordinates = make.vertices(20), make.vector((3, 3))
    for locate in (s.to_input, s.to_intrinsic):
        try:
            locate(faces, make.spoiled(numpy.abs(make.random.normal(size=(numpy.size(faces), 3)))))
        except ALLOWED:
            pass
    s.triangles()
    s.mass_matrices()
    s.from_input(make.spoiled(make.random.normal(size=s.number_of_input_vertices)))
    s.from_intrinsic(coordinates)
    s.from_input_corners(make.spoiled(make.random.normal(size=(s.input_faces.max() + 1, 3))))


def call_heat(make):
    options = {}
    if make.chance(0.3):
        options = {"t_coef": make.number(), "use_robust": make.pick((True, False)),
                   "boundary": make.pick(("neumann", "dirichlet", "averaged", 0)), "keeps_ridges": make.pick((True, False, None))}
    solver = it.MeshHeatMethodDistanceSolver(*make.surface(), **options)
    for _ in range(3):
        try:
            make.pick((lambda: solver.compute_distance(make.index()), lambda: solver.compute_distance_multisource(make.vertices()),
                       lambda: solver.extend_scalar(make.vertices(), make.vector())))()
        except ALLOWED:
            pass


def call_geodesics(make):
    surface = make.surface()
    paths, tracer = it.EdgeFlipGeodesicSolver(*surface), it.GeodesicTracer(*surface)
    for _ in range(3):
        try:
            make.pick((lambda: paths.find_geodesic_path(make.index(), make.index()),
                       lambda: paths.find_geodesic_path_poly(make.vertices()),
                       lambda: paths.find_geodesic_loop(make.vertices(), make.number() if make.chance(0.3) else None),
                       lambda: tracer.trace_geodesic_from_vertex(make.index(), make.vector(), *([make.number()] if make.chance(0.3) else [])),
                       lambda: tracer.trace_geodesic_from_face(make.index(), make.spoiled(make.random.dirichlet((1, 1, 1))),
                                                               make.vector())))()
        except ALLOWED:
            pass


def call_vectors(make):
    solver = it.MeshVectorHeatSolver(*make.surface(), *([make.number()] if make.chance(0.2) else []))
    solver.get_tangent_frames()
    solver.get_connection_laplacian()
    for _ in range(3):
        try:
            make.pick((lambda: solver.transport_tangent_vector(make.index(), make.vector(2)),
                       lambda: solver.transport_tangent_vectors(make.vertices(), make.vector((make.random.integers(4), 2))),
                       lambda: solver.compute_log_map(make.index(), *([make.number()] if make.chance(0.2) else [])),
                       lambda: solver.extend_scalar(make.vertices(), make.vector(make.random.integers(4)))))()
        except ALLOWED:
            pass


def resident_memory():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


class Interrupted(Exception):
    pass


def interrupt(*_):
    raise Interrupted


def run(first, last, calls):
    returned = 0
    for i in range(first, last):
        make = Maker(i)
        # A line around a needle can be a long one. What does not end three minutes after the signal ends the program.
        signal.setitimer(signal.ITIMER_REAL, 2)
        faulthandler.dump_traceback_later(180, exit=True)
        try:
            with numpy.errstate(all="ignore"):
                calls[i % len(calls)](make)
            returned += 1
        except ALLOWED:
            pass
        except Interrupted:
            print(f"call {i} was interrupted")
        except BaseException as error:
            raise AssertionError(f"call {i}") from error
    return returned


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="there is no /proc")
def test_random_arguments():
    calls = (call_laplacians, call_triangulation, call_heat, call_geodesics, call_vectors)
    before = signal.signal(signal.SIGALRM, interrupt)
    try:
        check_calls(calls)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        faulthandler.cancel_dump_traceback_later()
        signal.signal(signal.SIGALRM, before)


def check_calls(calls):
    # What is kept once and for all is there after a third of the calls.
    returned = run(0, CALLS // 3, calls)
    before = resident_memory()
    returned += run(CALLS // 3, CALLS, calls)
    grown = resident_memory() - before
    assert returned > 0.2 * CALLS  # else nothing but the checks of arguments is tested
    assert grown < 30e6 + 100 * CALLS, f"{grown} bytes more"
    print(f"{CALLS} calls, {returned} returned, {grown} bytes more")
