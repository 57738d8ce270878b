# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Meshes from files, and their repair: each error leads to a function that ends in a triangulation.

import itertools
import re

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
    assert "(1 component became 3)" in mesh.repairs[0].message
    # Two squares that touch at a corner, of three parts.
    V = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [-1, -1, 0], [9, 0, 0], [9, 1, 0], [8, 0, 0]]
    mesh = it.repair(V, [[0, 1, 2], [0, 3, 4], [5, 6, 7]])
    assert "(2 components became 3)" in mesh.repairs[0].message
    assert it.component_labels(mesh.V, mesh.F).max() == 2
    assert "component" not in it.repair(V, [[0, 1, 2], [0, 2, 3], [0, 1, 4], [5, 6, 7]]).repairs[0].message


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


def test_what_is_unusual_about_a_file(tmp_path):
    path = tmp_path / "facet.stl"
    path.write_text("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n")
    with pytest.warns(UserWarning, match=r"facet.stl: the file ends without a line endsolid"):
        assert len(it.read_mesh(path)[1]) == 1


@pytest.mark.parametrize("advice", [r"F\[:, 1:\]", r"F\.reshape\(-1, 4\)\[:, 1:\]"])
def test_rows_that_begin_with_a_number_of_corners(advice):
    V = [[x, y, 0] for y in range(3) for x in range(3)]
    F = numpy.array([[0, 1, 4], [1, 2, 5], [3, 4, 7], [4, 5, 8]])
    rows = numpy.insert(F, 0, 3, axis=1)
    is_flat = "reshape" in advice
    for given in [rows.ravel()] if is_flat else [rows, rows.tolist()]:
        for function in [it.laplacian, it.Triangulation, it.repair]:
            with pytest.raises(it.InvalidSurfaceError, match=r"all 4 rows of F begin with 3, .*: leave this column out, " + advice):
                function(V, given)
    assert (eval(advice.replace("\\", ""), {"F": rows.ravel() if is_flat else rows}) == F).all()
    # Which is no such number: of one face, or where the faces have another one of corners.
    assert len(it.repair(V, [[3, 0, 1, 4]]).F) == 2
    assert len(it.repair(V, [[4, 3, 0, 1], [4, 1, 2, 5]]).F) == 4


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


KITE = [[0.0, 0, 0], [4, 0, 0], [2, 1, 0], [2, -1, 0]], [[0, 1, 2], [1, 0, 3]]
BAD = {
    "a polygon": ([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], numpy.array([[0, 1, 2, 3]])),
    "polygons": (KITE[0], [[0, 1, 2], [1, 0, 3], [0, 3, 1, 2]]),
    "a face of two corners": (KITE[0], KITE[1] + [[0, 1]]),
    "a vertex twice": (KITE[0], KITE[1] + [[0, 0, 1]]),
    "a face twice": (KITE[0], KITE[1] + [[0, 1, 2]]),
    "three faces at an edge": (KITE[0] + [[2, 0, 1]], KITE[1] + [[0, 1, 4]]),
    "three faces at an edge, one turned over": (KITE[0] + [[2, 0, 1]], [KITE[1][0], [0, 1, 3], [0, 1, 4]]),
    "a face turned over": (KITE[0], [KITE[1][0], [0, 1, 3]]),
    "two fans": (KITE[0] + [[-1, 0, 0], [-1, 1, 0]], KITE[1] + [[0, 4, 5]]),
    "an edge without length": (KITE[0] + [[0, 0, 0]], [[4, 1, 2], [1, 0, 3], [0, 1, 4]]),
    "a face without area": ([[0, 0, 0], [1, 0, 0], [2, 0, 0], [1, -1, 0]], [[0, 1, 2], [1, 0, 3], [2, 1, 3]]),
    "NaN": ([[numpy.nan, 0, 0]] + KITE[0][1:], KITE[1]),
    "NaN without faces": (KITE[0] + [[0, numpy.inf, 0]], KITE[1]),
    "indices from 1": (KITE[0], (numpy.array(KITE[1]) + 1)),
    "masked entries": (numpy.ma.masked_array(KITE[0], mask=[[1, 0, 0]] + [[0, 0, 0]] * 3), KITE[1]),
    "large integers": (numpy.array(KITE[0], dtype=numpy.int64) * 2**60 + 1, KITE[1]),
    "large": (numpy.array(KITE[0]) * 1e200, KITE[1]),
    "small": (numpy.array(KITE[0]) * 1e-200, KITE[1]),
    "large and small": ([[0, 0, 0], [1e200, 0, 0], [0, 1e200, 0], [1e-200, 0, 0], [0, -1e-200, 0]], [[0, 1, 2], [0, 3, 1], [0, 4, 3]]),
}
FUNCTIONS = {
    "Triangulation": lambda V, F: it.Triangulation(V, F).flip_to_delaunay(),
    "refine": lambda V, F: it.Triangulation(V, F).refine(minimum_angle=25, minimum_size=1e-3),
    "repair": it.repair,
    "orient": it.orient,
    "laplacian": it.laplacian,
    "cotan_laplacian": it.cotan_laplacian,
    "face_areas": it.face_areas,
    "vertex_areas": it.vertex_areas,
    "geodesic_distances": lambda V, F: it.geodesic_distances(V, F, 1),
    "geodesic_path": lambda V, F: it.geodesic_path(V, F, 0, 1),
    "compute_distance": lambda V, F: it.compute_distance(V, F, 1),
    "MeshVectorHeatSolver": it.MeshVectorHeatSolver,
    "GeodesicTracer": it.GeodesicTracer,
    "EdgeFlipGeodesicSolver": it.EdgeFlipGeodesicSolver,
}


def without_face(V, F, face):
    return V, [f for i, f in enumerate(F) if i != int(face)]


# What is said, and what it is to do so. Of several that are said, the first in this order.
ADVICE = [
    (r"orient\(V, F\) does it", lambda V, F, match: (V, it.orient(V, F)[0])),
    (r"repair\(V, F\)", lambda V, F, match: it.repair(V, F)[:2]),
    (r"is not finite|not a finite number|give every vertex finite coordinates",
     lambda V, F, match: (numpy.where(numpy.isfinite(V), V, 0.0), F)),
    (r"subtract 1 from each", lambda V, F, match: (V, numpy.array(F) - 1)),
    (r"leave them out, or fill them", lambda V, F, match: (V.filled(0.0), F)),
    (r"round it first", lambda V, F, match: (V.astype(float), F)),
    (r"round it to zero, or remove the outliers", lambda V, F, match: (numpy.where(numpy.abs(V) < 1e-100, 0.0, V), F)),
    (r"face (\d+).*scale the surface, or remove the face if that does not help",
     lambda V, F, match: (numpy.array(V) / numpy.max(numpy.abs(V)), F) if not 0.1 < numpy.max(numpy.abs(V)) < 10
     else without_face(V, F, match.group(1))),
    (r"scale the surface", lambda V, F, match: (numpy.array(V) / numpy.max(numpy.abs(V)), F)),
]


@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize("what", BAD)
def test_advice_ends_in_a_result(what, function):
    call, mesh, messages = FUNCTIONS[function], BAD[what], []
    while True:
        try:
            call(*mesh)
            return
        except (ValueError, ArithmeticError) as error:
            assert str(error) not in messages or "remove the face" in str(error), f"in a circle: {messages}"
            messages.append(str(error))
        assert len(messages) < 6, messages
        if "laplacian(V, F) takes it" in messages[-1]:
            call = it.laplacian
            continue
        rules = [(re.search(pattern, messages[-1]), action) for pattern, action in ADVICE]
        assert any(match for match, _ in rules), f"nothing to do: {messages}"
        mesh = next(action(*mesh, match) for match, action in rules if match)


def test_gaps_cause_a_warning_and_are_closed():
    V = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.5, 0, 0], [0.5, -1, 0]]
    F = [[0, 1, 2], [0, 4, 3], [3, 4, 1]]
    for function in (it.laplacian, lambda V, F: it.geodesic_distances(V, F, 2)):
        with pytest.warns(UserWarning, match=r"vertex 3 lies within edge 0-1 .*; repair\(V, F, stitching_tolerance=0\) joins them"):
            function(V, F)
    assert it.geodesic_distances(*it.repair(V, F, stitching_tolerance=0)[:2], 2)[4] == pytest.approx(numpy.hypot(0.5, 2), rel=0.01)
    with pytest.raises(it.InvalidArgumentError):
        it.repair(V, F, stitching_tolerance=-1)
