# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The tutorial draws its figures, and its numbers are those of the torus.

import importlib.util
import pathlib

import numpy
import pytest

pytest.importorskip("matplotlib", reason="skipped: there is no package matplotlib (on Debian: apt install python3-matplotlib)")

FIGURES = ("1_triangles.png", "2_eigenfunctions.png", "3_distances.png", "4_texture.png")


def test_tutorial(tmp_path):
    spec = importlib.util.spec_from_file_location("tutorial", pathlib.Path(__file__).parents[2] / "doc/examples/tutorial.py")
    tutorial = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(tutorial)
    angles, values, (coarse, fine, path, farthest), (uv, positions) = tutorial.main(tmp_path, 36, 8)
    import matplotlib.image
    for name in FIGURES:
        pixels = matplotlib.image.imread(tmp_path / name)[:, :, :3]
        assert pixels.shape[0] == 400 and (abs(pixels - 1).max(axis=2) > 0.1).mean() > 0.1  # something is drawn
    assert angles[0] < 10 and angles[1] > angles[0] and angles[2] > 24.9
    # The torus is symmetric, so its eigenvalues come in pairs; a finer triangulation separates them less.
    exact = torus_eigenvalues()
    error = {name: abs(found[1:6] - exact[1:6]).max() for name, found in values.items()}
    assert error["refined"] < 0.06 and error["refined"] < error["cotangents of the mesh"]
    assert path.is_geodesic and abs(fine[farthest] - path.length) < 0.05 * path.length
    # Texture coordinates are those of the points: on the chords of the mesh, as far as these are from the torus.
    v = 2 * numpy.pi * uv[:, :, 1]
    u = 2 * numpy.pi * (uv[:, :, 0] + 0.08 * numpy.sin(v))
    on_torus = numpy.stack([(2 + 0.8 * numpy.cos(v)) * numpy.cos(u), (2 + 0.8 * numpy.cos(v)) * numpy.sin(u), 0.8 * numpy.sin(v)], axis=2)
    assert numpy.linalg.norm(on_torus - positions, axis=2).max() < 0.2


def torus_eigenvalues():
    """For functions exp(i k u) f(v): one equation on a circle for each k, on a fine grid."""
    n = 400
    v = 2 * numpy.pi * numpy.arange(n) / n
    h = 0.8 * 2 * numpy.pi / n
    radius, between = 2 + 0.8 * numpy.cos(v), 2 + 0.8 * numpy.cos(v + numpy.pi / n)
    result = []
    for k in range(4):
        matrix = numpy.diag((between + numpy.roll(between, 1)) / h**2 + k**2 / radius)
        for i in range(n):
            matrix[i, (i + 1) % n] -= between[i] / h**2
            matrix[(i + 1) % n, i] -= between[i] / h**2
        root = numpy.sqrt(radius)
        found = numpy.linalg.eigvalsh(matrix / root[:, None] / root)[:4]
        result += list(found) * (1 if k == 0 else 2)
    return numpy.sort(result)
