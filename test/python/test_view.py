# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Pages of surfaces, and arrays for viewers.

import json
import os
import shutil
import webbrowser

import numpy
import pytest

import intrinsic_triangulations as it
from conftest import icosphere
from intrinsic_triangulations._view import find_command, page_of

needs_command = pytest.mark.skipif(find_command() is None, reason="skipped: there is no command idt")


@needs_command
def test_pages(tmp_path, monkeypatch):
    V, F = icosphere(1)
    page = it.view(V, F, {"height": V[:, 2], "width": V[:, 0]})
    if "three.js" not in page.text:
        pytest.fail("the page has nothing that draws")
    assert "height" in page.text and "width" in page.text and "intrinsic Delaunay triangulation" in page.text
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


def fields_of(page):
    """The names of what colors the surface, and whether it is of vertices or faces."""
    text = page.text.split('<script type="application/json" id="page">')[1].split("</script>")[0]
    return [(field["name"], field["of"][0]) for field in json.loads(text)["fields"]]


@needs_command
def test_values_of_vertices_and_faces():
    V, F = icosphere(1)
    masked = numpy.ma.masked_greater(V[:, 0], 0.5)
    of_faces = numpy.where(numpy.arange(len(F)) < 3, numpy.nan, 1.0)
    values = {"masked": masked, "of faces": of_faces, "whole": numpy.arange(len(V)), "marks": V[:, 0] > 0.5}
    right = [("masked", "vertices"), ("of faces", "faces"), ("whole", "vertices"), ("marks", "vertices")]
    assert fields_of(it.view(V, F, values)) == right
    t = it.Triangulation(V, F)
    t.flip_to_delaunay()
    assert fields_of(page_of(t, values)) == right
    t.refine(maximum_edge_length=0.4)
    with pytest.raises(ValueError):
        page_of(t, of_faces)


@needs_command
def test_any_triangles():
    V = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 0]])
    F = [[0, 1, 2], [0, 1, 3], [0, 1, 4]]  # three at one edge
    page = it.view(V, F, [1, 2, 3])
    assert fields_of(page) == [("values", "faces")] and "intrinsic Delaunay" not in page.text.split("<script")[1]
    with pytest.raises(it.InvalidSurfaceError):
        it.view(V, [[0, 1, 5]])


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
