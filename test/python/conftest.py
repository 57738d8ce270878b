# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Surfaces for the tests.

import numpy
import pytest


def icosphere(number_of_splits):
    """a sphere of radius 1 of 10 * 4 ** number_of_splits + 2 vertices."""
    t = (1 + 5 ** 0.5) / 2
    V = numpy.array([(-1, t, 0), (1, t, 0), (-1, -t, 0), (1, -t, 0), (0, -1, t), (0, 1, t), (0, -1, -t), (0, 1, -t),
                     (t, 0, -1), (t, 0, 1), (-t, 0, -1), (-t, 0, 1)], dtype=float)
    F = numpy.array([(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
                     (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
                     (8, 6, 7), (9, 8, 1)])
    for _ in range(number_of_splits):
        n = len(V)
        ends = numpy.sort(numpy.concatenate([F[:, [0, 1]], F[:, [1, 2]], F[:, [2, 0]]]), axis=1)
        edges, number = numpy.unique(ends, axis=0, return_inverse=True)
        V = numpy.concatenate([V, (V[edges[:, 0]] + V[edges[:, 1]]) / 2])
        x, y, z = n + number.reshape(3, -1)
        a, b, c = F.T
        F = numpy.concatenate([numpy.stack(t, axis=1) for t in ((a, x, z), (b, y, x), (c, z, y), (x, y, z))])
    return V / numpy.linalg.norm(V, axis=1)[:, None], F


def grid(n, shear=0.0):
    """a square of n * n vertices in a plane, sheared."""
    x, y = (a.ravel().astype(float) for a in numpy.meshgrid(numpy.arange(n), numpy.arange(n)))
    i = numpy.arange(n * n).reshape(n, n)
    a, b, c, d = i[:-1, :-1].ravel(), i[:-1, 1:].ravel(), i[1:, 1:].ravel(), i[1:, :-1].ravel()
    F = numpy.concatenate([numpy.stack([a, b, c], axis=1), numpy.stack([a, c, d], axis=1)])
    return numpy.stack([x + shear * y, y, 0 * x], axis=1), F


@pytest.fixture
def sphere():
    return icosphere(2)


@pytest.fixture
def thin():
    """a surface that is far from Delaunay."""
    V, F = icosphere(3)
    return V * (1, 1, 8) + 0.02 * numpy.random.default_rng(1).normal(size=V.shape), F
