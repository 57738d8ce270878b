# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Meshes from files, and their repair: each error leads to a function that ends in a triangulation.

import itertools

import numpy
import pytest

import intrinsic_triangulations as it


def boundary(cells):
    """the triangles around unit cells, which point outward, with a vertex for each corner."""
    number, V, F = {}, [], []
    for cell, axis, side in itertools.product(cells, range(3), (0, 1)):
        neighbor = list(cell)
        neighbor[axis] += 2 * side - 1
        if tuple(neighbor) in cells:
            continue
        square = []
        for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
            p = list(cell)
            p[axis] += side
            p[(axis + 1) % 3] += x
            p[(axis + 2) % 3] += y
            if tuple(p) not in number:
                number[tuple(p)] = len(V)
                V.append(p)
            square.append(number[tuple(p)])
        if side == 0:
            square.reverse()
        F += [[square[0], square[1], square[2]], [square[0], square[2], square[3]]]
    return numpy.array(V), numpy.array(F)


SIX_CELLS = {(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)}


def test_each_error_leads_to_a_function_that_mends_it():
    V, F = boundary(SIX_CELLS)
    F[10] = F[10][::-1]
    with pytest.raises(it.InvalidSurfaceError, match=r"orient\(V, F\)|repair\(V, F\)"):
        it.Triangulation(V, F)
    F, repairs = it.orient(V, F)
    assert [(r.kind, r.count, r.first) for r in repairs] == [("reversed faces", 1, [10])]
    with pytest.raises(it.InvalidSurfaceError, match=r"more than two faces; repair\(V, F\)"):
        it.Triangulation(V, F)
    mesh = it.repair(V, F)
    assert [r.kind for r in mesh.repairs] == ["split vertices"]
    assert len(mesh.F) == 72 and (V[mesh.vertices] == mesh.V).all() and (mesh.vertices[mesh.F] == F).all()
    triangulation = it.Triangulation(mesh.V, mesh.F)
    assert 2 * triangulation.number_of_edges == 3 * triangulation.number_of_faces    # closed
    triangulation.flip_to_delaunay()


def test_what_a_repair_opens_is_reported():
    V = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 0]]
    mesh = it.repair(V, [[0, 1, 2], [1, 0, 3], [0, 1, 4]])
    assert [(r.kind, r.count, r.first) for r in mesh.repairs] == [("split vertices", 2, [0, 1]), ("opened edges", 3, [0, 1, 2])]
    assert "edge 0-1 of face 0 became border" in mesh.repairs[1].message


def test_a_one_sided_surface_cannot_be_oriented_but_repaired():
    t = numpy.linspace(0, 2 * numpy.pi, 8)[:-1]
    V = numpy.concatenate([[((1 + s * numpy.cos(x / 2)) * numpy.cos(x), (1 + s * numpy.cos(x / 2)) * numpy.sin(x), s * numpy.sin(x / 2))
                            for s in (-0.3, 0.3)] for x in t])
    F = []
    for i in range(7):
        a, b = 2 * i, 2 * i + 1
        c, d = (a + 2, b + 2) if i < 6 else (1, 0)
        F += [[a, c, b], [b, c, d]]
    with pytest.raises(it.InvalidSurfaceError, match=r"one-sided.*repair\(V, F\)"):
        it.orient(V, F)
    mesh = it.repair(V, F)
    assert [r.count for r in mesh.repairs if r.kind == "opened edges"] == [2]
    it.Triangulation(mesh.V, mesh.F)


def test_polygons_of_a_file(tmp_path):
    path = tmp_path / "pyramid.off"
    path.write_text("OFF\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 1\n4 3 2 1 0\n3 0 1 4\n3 1 4 2\n3 2 3 4\n3 3 0 4\n")
    V, F = it.read_mesh(path)
    assert F == [[3, 2, 1, 0], [0, 1, 4], [1, 4, 2], [2, 3, 4], [3, 0, 4]]
    mesh = it.repair(V, F)
    assert [r.kind for r in mesh.repairs] == ["triangulated faces", "reversed faces"]
    assert mesh.faces.tolist() == [0, 0, 1, 2, 3, 4]
    assert it.Triangulation(mesh.V, mesh.F).number_of_faces == 6
    path = tmp_path / "kite.off"
    path.write_text("OFF\n4 2 0\n0 0 0\n4 0 0\n2 1 0\n2 -1 0\n3 0 1 2\n3 1 0 3\n")
    V, F = it.read_mesh(str(path))
    assert F.dtype == numpy.int64 and F.tolist() == [[0, 1, 2], [1, 0, 3]]
    with pytest.raises(it.InvalidSurfaceError, match="no_such.off") as error:
        it.read_mesh(tmp_path / "no_such.off")
    assert error.value.defect == "UNREADABLE"


@pytest.mark.parametrize("bad", [[[0, 1, 9]], [[0, 1, -1]], [[0, 1, 2], [0, 1, 2, 3, 4]]])
def test_indices_out_of_range(bad):
    with pytest.raises(it.InvalidSurfaceError, match=rf"F\[{len(bad) - 1}\] names vertex"):
        it.repair([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], bad)


@pytest.mark.parametrize("F", [[], [[]], numpy.zeros((0, 3), int), [[0, 0, 1]], "abc", 3, [[0.5, 1, 2]], numpy.zeros((2, 2, 2), int)])
def test_what_is_no_face(F):
    V = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    try:
        assert len(it.repair(V, F).F) == 0
    except ValueError:
        pass
    with pytest.raises(ValueError):
        it.repair([[0, 0, numpy.nan], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
