# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Straight triangles: those of Python are those of the command, bit for bit.

import json
import os
import shutil
import subprocess

import numpy
import pytest

import intrinsic_triangulations as it

IDT = os.environ.get("IDT_COMMAND") or shutil.which("idt")
pytestmark = pytest.mark.skipif(not IDT, reason="skipped: there is no command idt")


def prism(n, height, radius=1.0):
    """a closed cylinder of n facets, its ends fans of slivers, coordinates as in an STL file."""
    angle = 2 * numpy.pi * numpy.arange(n) / n
    ring = numpy.stack([radius * numpy.cos(angle), radius * numpy.sin(angle)], axis=1)
    V = numpy.concatenate([numpy.c_[ring, numpy.zeros(n)], numpy.c_[ring, numpy.full(n, height)]])
    V = V @ numpy.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0], [0.48, 0.64, 0.6]])
    i = numpy.arange(n)
    j, k = (i + 1) % n, i[1:-1]
    F = numpy.concatenate([numpy.c_[i, j, n + j], numpy.c_[i, n + j, n + i], numpy.c_[0 * k, k + 1, k], numpy.c_[n + 0 * k, n + k, n + k + 1]])
    return V.astype(numpy.float32).astype(float), F


@pytest.mark.parametrize("V, F, percent", [
    (*prism(60, 2.0), 0.1), (*prism(200, 0.02), 0.02),
    (*prism(40, 0.01), 1), (*prism(8, 2.0, 0.01), 1)])  # thinner than the deviation: a plate and a wire
def test_as_the_command(V, F, percent, tmp_path):
    it.write_mesh(V, F, tmp_path / "part.off")
    done = subprocess.run([IDT, "refine", "part.off", "--constrain-angle", "30", "--maximum-deviation", f"{percent}%",
                           "--flatten", "straight.off", "--stats", "s.json"], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode in (0, 4), done.stderr
    statistics = json.loads((tmp_path / "s.json").read_text())
    deviation = percent / 100 * (V.max(axis=0) - V.min(axis=0)).max()
    t = it.Triangulation(V, F)
    report = t.refine(maximum_deviation=deviation, sharp_edge_angle=30)
    assert report.minimum_size == statistics["minimum_size"]
    mesh = t.straight_mesh(it.Triangulation(V, F).sharp_edges(30, report.minimum_size), maximum_deviation=deviation)
    points, triangles = it.read_mesh(tmp_path / "straight.off")[:2]
    assert numpy.array_equal(mesh.triangles, triangles) and numpy.array_equal(mesh.points, points)
    assert (mesh.is_surface and len(mesh.thin_triangles) == mesh.sharp_corners) == (done.returncode == 0)
