# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Pages of surfaces, and arrays for viewers.

import os
import shutil
import webbrowser

import numpy
import pytest

import intrinsic_triangulations as it
from conftest import icosphere
from intrinsic_triangulations._view import find_command

needs_command = pytest.mark.skipif(find_command() is None, reason="skipped: there is no command idt")


@needs_command
def test_pages(tmp_path, monkeypatch):
    V, F = icosphere(1)
    page = it.view(V, F, {"height": V[:, 2], "width": V[:, 0]})
    if "three.js" not in page.text:
        pytest.fail("the page has nothing that draws")
    assert "height" in page.text and "width" in page.text and "saved triangulation" in page.text
    assert "<iframe" in page._repr_html_() and "<script" not in page._repr_html_()
    page.save(tmp_path / "p.html")
    assert (tmp_path / "p.html").read_text() == page.text
    opened = []
    monkeypatch.setattr(webbrowser, "open", opened.append)
    t = it.Triangulation(V, F)
    t.refine(maximum_edge_length=0.4)
    t.show(V[:, 1])
    assert len(opened) == 1 and opened[0].startswith("file:///")
    os.remove(opened[0][len("file://"):])


@needs_command
def test_bad_values():
    V, F = icosphere(1)
    with pytest.raises(ValueError):
        it.view(V, F, V)
    with pytest.raises(ValueError):
        it.Triangulation.from_gluing([[0, 3], [1, 4], [2, 5]], [[3, 4, 5], [3, 4, 5]]).show()


def test_without_the_command(monkeypatch):
    monkeypatch.delenv("IDT_COMMAND", raising=False)
    monkeypatch.setattr(shutil, "which", lambda *_, **__: None)
    with pytest.raises(it.Error, match="IDT_COMMAND"):
        it.view(*icosphere(0))


def test_arrays_for_viewers(thin):
    t = it.Triangulation(*thin)
    t.flip_to_delaunay()
    points, triangles, input_faces, intrinsic_faces = t.common_subdivision().mesh()
    assert triangles.max() == len(points) - 1 and len(triangles) == len(input_faces) == len(intrinsic_faces)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    areas = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1) / 2
    assert numpy.allclose(numpy.bincount(intrinsic_faces, areas), t.areas)
