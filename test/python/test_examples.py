# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The example programs that are written as for other packages, against formulas that are evaluated here, with dense matrices.

import importlib.util
import os
import pathlib
import subprocess
import sys

import numpy
import pytest
import scipy.linalg

import intrinsic_triangulations as it
from conftest import grid, icosphere

EXAMPLES = pathlib.Path(__file__).parents[2] / "doc/examples"


def example(name):
    if str(EXAMPLES) not in sys.path:  # as when it is run
        sys.path.append(str(EXAMPLES))
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def ellipsoid():
    """whose edges are Delaunay, so that the intrinsic triangulation is the mesh itself."""
    V, F = icosphere(3)
    V = V * (1, 1.1, 0.95)
    L = dense_laplacian(V, F)[0]
    assert (L - numpy.diag(L.diagonal())).max() < 1e-12
    return V, F


def dense_laplacian(V, F):
    """cotangents by the law of cosines and Heron's formula, and the masses."""
    n = len(V)
    L, mass = numpy.zeros((n, n)), numpy.zeros(n)
    for face in F:
        lengths = [numpy.linalg.norm(V[face[(i + 1) % 3]] - V[face[(i + 2) % 3]]) for i in range(3)]
        s = sum(lengths) / 2
        area = numpy.sqrt(s * numpy.prod([s - length for length in lengths]))
        mass[face] += area / 3
        for i in range(3):
            j, k = face[(i + 1) % 3], face[(i + 2) % 3]
            half = (lengths[i - 1]**2 + lengths[i - 2]**2 - lengths[i]**2) / (8 * area)
            L[[j, k], [k, j]] -= half
            L[[j, k], [j, k]] += half
    return L, mass


def off_file(folder, V, F):
    path = folder / "mesh.off"
    path.write_text(f"OFF\n{len(V)} {len(F)} 0\n" + "".join("%.17g %.17g %.17g\n" % tuple(v) for v in V)
                    + "".join("3 %d %d %d\n" % tuple(f) for f in F))
    return path


@pytest.mark.parametrize("name", ["spectral_features", "distances_and_vectors", "diffusion_operators"])
def test_programs(name, tmp_path):
    V, F = icosphere(2)
    output = tmp_path / "results.npz"
    done = subprocess.run([sys.executable, str(EXAMPLES / f"{name}.py"), str(off_file(tmp_path, V, F)), str(output)], capture_output=True,
                          text=True, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
    assert done.returncode == 0, done.stderr
    with numpy.load(output) as results:
        assert len(results.files) > 3 and all(numpy.isfinite(results[key]).all() for key in results.files)


def test_programs_say_which_arguments_they_take():
    for path in EXAMPLES.glob("*.py"):
        if path.name == "tutorial.py":
            pytest.importorskip("matplotlib")
        done = subprocess.run([sys.executable, str(path)], capture_output=True, text=True, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
        assert done.returncode in (1, 2) and done.stderr.startswith("usage: "), path


def test_spectral_features(ellipsoid):
    V, F = ellipsoid
    features = example("spectral_features").features(V, F)
    L, mass = dense_laplacian(V, F)
    evals, evecs = scipy.linalg.eigh(L, numpy.diag(mass), subset_by_index=[0, 39])
    area = mass.sum()
    assert features["evals"] == pytest.approx(evals * area, rel=1e-6, abs=1e-6)
    for i, t in enumerate(numpy.geomspace(0.01, 1, 16) * area / (4 * numpy.pi)):
        assert features["hks"][:, i] == pytest.approx(area * (numpy.exp(-t * evals) * evecs**2).sum(axis=1), rel=1e-6)
    assert (features["mass"] @ features["wks"]) / area == pytest.approx(numpy.ones(16))  # each function has norm 1


def test_spectral_features_of_points():
    V, _ = icosphere(4)
    evals = example("spectral_features").features(V, [], 16)["evals"] / (4 * numpy.pi)
    assert evals == pytest.approx([0] + 3 * [2] + 5 * [6] + 7 * [12], rel=0.02, abs=1e-6)


def test_distances_are_those_of_the_formula(ellipsoid):
    V, F = ellipsoid
    L, mass = dense_laplacian(V, F)
    ends = numpy.unique(numpy.sort(F[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1), axis=0)
    t = numpy.linalg.norm(V[ends[:, 0]] - V[ends[:, 1]], axis=1).mean()**2
    heat = numpy.linalg.solve(numpy.diag(mass) + t * L, numpy.eye(len(V))[7])
    flux = numpy.zeros(len(V))
    for face in F:
        p = V[face]
        normal = numpy.cross(p[1] - p[0], p[2] - p[0])
        gradients = numpy.cross(normal, p[[2, 0, 1]] - p[[1, 2, 0]]) / (normal @ normal)
        direction = -heat[face] @ gradients
        flux[face] += gradients @ direction / numpy.linalg.norm(direction) * numpy.linalg.norm(normal) / 2
    expected = numpy.linalg.lstsq(L, flux, rcond=None)[0]
    expected -= expected[7]
    smooth = it.MeshHeatMethodDistanceSolver(V, F, keeps_ridges=False).compute_distance(7)
    lines = numpy.linalg.norm(V - V[7], axis=1) # which no distance is below
    assert (expected > lines).sum() > 0.5 * len(V)
    assert abs(smooth - numpy.maximum(expected, lines)).max() < 1e-6 * expected.max()
    found = example("distances_and_vectors").distances(V, F, [7, 100])
    assert numpy.array_equal(found["one"], found["again"])
    assert abs(found["one"] - expected).max() < 0.02 * expected.max()
    assert found["nearest"][7] == found["nearest"][100] == 0


def test_distances_and_vectors_in_the_plane():
    """Everything is known there."""
    V, F = grid(12, 0.7)
    sources = [14, 129, 79]
    found = example("distances_and_vectors").everything(V, F, sources)
    to = lambda i: numpy.linalg.norm(V - V[sources[i]], axis=1)
    assert abs(found["one"] - to(0)).max() < 0.05 * to(0).max()
    assert found["radius"] == pytest.approx(to(0), abs=1e-6)
    assert found["carried_length"] == pytest.approx(numpy.ones(len(V)), abs=1e-6)
    assert found["several_length"] == pytest.approx(numpy.ones(len(V)), abs=1e-6)
    assert found["values"][sources] == pytest.approx([0, 1, 2])
    assert abs(found["normal"]) == pytest.approx(numpy.tile([0, 0, 1], (len(V), 1)))
    assert found["path"] == pytest.approx(to(0)[sources[1]], rel=1e-9)
    assert found["path_through"] == pytest.approx(to(0)[sources[2]], rel=1e-9)
    assert found["loop"] == 0  # shrunk to a point
    a, b, c = V[F[0]]
    assert found["line_end"] == pytest.approx(0.2 * a + 0.3 * b + 0.5 * c + 5 * (b - a) + (c - a), abs=1e-9)


def test_operators_of_a_mesh(ellipsoid):
    V, F = ellipsoid
    frames, mass, L, evals, evecs, grad_x, grad_y = example("diffusion_operators").compute_operators(V, F)
    expected, masses = dense_laplacian(V, F)
    assert abs(L.toarray() - expected).max() < 1e-6 * abs(expected).max()
    assert mass == pytest.approx(masses, rel=1e-6)
    small = 1e-8 * numpy.eye(len(V))
    assert evals == pytest.approx(scipy.linalg.eigh(expected + small, numpy.diag(masses), subset_by_index=[0, 31])[0], rel=1e-6, abs=1e-6)
    assert (evecs.T * mass) @ evecs == pytest.approx(numpy.eye(32), abs=1e-6)
    assert frames @ frames.transpose(0, 2, 1) == pytest.approx(numpy.tile(numpy.eye(3), (len(V), 1, 1)), abs=1e-12)
    # The gradient fits the differences along edges best in each tangent plane: here by a general least-squares solver.
    u = numpy.sin(3 * V[:, 0]) + V[:, 1]
    for v in range(0, len(V), 50):
        near = numpy.flatnonzero(expected[v])
        near = near[near != v]
        rows = (V[near] - V[v]) @ frames[v, :2].T
        gradient = numpy.linalg.lstsq(numpy.vstack([rows, 1e-5**0.5 * numpy.eye(2)]), numpy.append(u[near] - u[v], [0, 0]), rcond=None)[0]
        assert [(grad_x @ u)[v], (grad_y @ u)[v]] == pytest.approx(gradient, rel=1e-6, abs=1e-9)


def test_operators_of_points():
    V, F = icosphere(3)
    frames, mass, _, evals, _, grad_x, grad_y = example("diffusion_operators").compute_operators(V, numpy.zeros((0, 3), int), 9)
    assert mass.sum() == pytest.approx(4 * numpy.pi, rel=0.03)
    assert evals == pytest.approx([0] + 3 * [2] + 5 * [6], rel=0.05, abs=1e-6)
    assert abs((frames[:, 2] * V).sum(axis=1)) == pytest.approx(numpy.ones(len(V)), abs=0.01)
    in_space = (grad_x @ V[:, 2])[:, None] * frames[:, 0] + (grad_y @ V[:, 2])[:, None] * frames[:, 1]
    assert abs(in_space - (numpy.array([0, 0, 1]) - V[:, 2:] * V)).max() < 0.1


def test_areas_and_cotangents():
    V, F = grid(5, 1.5)
    V = V + 0.1 * numpy.random.default_rng(0).normal(size=V.shape)
    L, mass = dense_laplacian(V, F)
    assert abs(it.cotan_laplacian(V, F).toarray() - L).max() < 1e-12 * abs(L).max()
    assert it.vertex_areas(V, F) == pytest.approx(mass, rel=1e-12)
    assert it.face_areas(V, F).sum() == pytest.approx(mass.sum(), rel=1e-12)
    thin = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]
    with pytest.raises(it.InvalidSurfaceError, match="face 0 has no area"):
        it.cotan_laplacian(thin, [[0, 1, 2]])
    assert numpy.isfinite(it.cotan_laplacian(thin, [[0, 1, 2]], denom_eps=1e-6).data).all()
    for bad in ([[0, 0, numpy.nan]] * 3, [[0, 0, 0], [1e200, 0, 0], [0, 1e200, 0]]):
        with pytest.raises(it.InvalidSurfaceError, match="not finite|beyond"):
            it.cotan_laplacian(bad, [[0, 1, 2]])
    for bad in (-1, numpy.inf, "1"):
        with pytest.raises(ValueError):
            it.cotan_laplacian(V, F, denom_eps=bad)
