# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What users of Python expect of a package: errors of files, help, types, files that are written, borders and components.

import inspect
import os
import pickle
import typing

import numpy
import pytest
import scipy.sparse.linalg

import intrinsic_triangulations as it
from conftest import grid, icosphere

KITE = numpy.array([[0.1, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]]), numpy.array([[0, 1, 2], [1, 0, 3]])


@pytest.mark.parametrize("read", [it.read_mesh, it.Triangulation.load])
def test_errors_of_files_are_those_of_the_system(read, tmp_path):
    bad = tmp_path / ("bad.off" if read is it.read_mesh else "bad.idt")
    bad.write_text("no mesh")
    for path, error in [(bad, OSError), (tmp_path / "missing.off", FileNotFoundError)]:
        for expected in (error, it.InvalidFileError, it.InvalidSurfaceError, it.FileError, ValueError):
            with pytest.raises(expected) as caught:
                read(path)
        assert str(path) in str(caught.value) and caught.value.filename == str(path)
        copy = pickle.loads(pickle.dumps(caught.value))
        assert (type(copy), str(copy), copy.errno) == (type(caught.value), str(caught.value), caught.value.errno)
        assert (copy.errno is None) == (path == bad) and copy.defect


def test_a_file_that_cannot_be_written(tmp_path):
    for error in (OSError, it.FileError):
        with pytest.raises(error, match="no_folder") as caught:
            it.Triangulation(*KITE).save(tmp_path / "no_folder" / "kite.idt")
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)
    with pytest.raises(OSError):
        it.write_mesh(*KITE, tmp_path / "no_folder" / "kite.off")


TUPLES = [thing for thing in vars(it).values() if inspect.isclass(thing) and hasattr(thing, "_fields")]


@pytest.mark.parametrize("cls", TUPLES)
def test_help_says_what_fields_are(cls):
    for name in cls._fields:
        text = inspect.getdoc(getattr(cls, name))
        assert len(text) > 8 and not text.startswith("Alias for")


def test_options_are_literal_types():
    assert len(TUPLES) > 9
    for function, name in [(it.laplacian, "mass"), (it.Triangulation.laplacian, "mass"), (it.Triangulation.conformal_map, "boundary"),
                           (it.MeshHeatMethodDistanceSolver, "boundary"), (it.MeshVectorHeatSolver.compute_log_map, "strategy")]:
        function = function.__init__ if inspect.isclass(function) else function
        default, hint = inspect.signature(function).parameters[name].default, str(typing.get_type_hints(function)[name])
        assert "Literal[" in hint and (default is None or repr(default) in hint)
    with pytest.raises(ValueError, match="mass has to be one of 'lumped', 'galerkin', not 'full'"):
        it.laplacian(*KITE, mass="full")


@pytest.mark.parametrize("call", [
    lambda: it.laplacian([[0, 0]], KITE[1]), lambda: it.laplacian("abc", KITE[1]), lambda: it.Triangulation(*KITE).refine(minimum_angle=40),
    lambda: it.Triangulation(*KITE).refine(minimum_size=-1), lambda: it.Triangulation(*KITE).sharp_edges(200),
    lambda: it.geodesic_distances(*KITE, 0, tolerance=2), lambda: it.Triangulation(*KITE).flip_to_delaunay(-1),
    lambda: it.Triangulation(*KITE).common_subdivision().from_input([1]), lambda: it.write_mesh(*KITE, "kite.xyz")])
def test_wrong_arguments_have_one_wording(call):
    with pytest.raises(ValueError, match=r"^\w+ has to "):
        call()


def test_ends_are_named_in_their_order():
    with pytest.raises(ValueError, match="no edge joins the vertices 3 and 2$"):
        it.Triangulation(*KITE).edges_between([[0, 1], [3, 2]])


def test_border_and_components():
    V, F = grid(4)
    W, G = icosphere(0)
    points, faces = numpy.concatenate([W, V, [[9, 9, 9]]]), numpy.concatenate([F + len(W), G])
    edges = it.border_edges(points, faces)
    assert len(edges) == 12 and len(it.border_edges(W, G)) == 0
    assert (it.border_vertices(points, faces) - len(W)).tolist() == [0, 1, 2, 3, 4, 7, 8, 11, 12, 13, 14, 15]
    after = dict(edges.tolist())    # they run around the square
    assert sorted(after) == sorted(after.values()) == it.border_vertices(points, faces).tolist()
    assert it.component_labels(points, faces).tolist() == 12 * [0] + 16 * [1] + [-1]
    assert it.component_labels(points, numpy.zeros((0, 3), int)).tolist() == 29 * [-1]


def test_a_poisson_problem_on_several_components():
    V, F = grid(6)
    n = len(V)
    points, faces = numpy.concatenate([V, V + 9, [[99, 0, 0]]]), numpy.concatenate([F, F + n])
    f = numpy.append(numpy.concatenate([V[:, 0] + 1, V[:, 1]]), 5)
    L, M = it.laplacian(points, faces)
    u = it.solve_poisson(L, M, f)
    assert numpy.isfinite(u).all() and u[-1] == 0
    for part in (slice(0, n), slice(n, 2 * n)):
        weights = M.diagonal()[part]
        mean = f[part] - (weights @ f[part]) / weights.sum()
        assert abs(weights @ u[part]) < 1e-10
        assert numpy.allclose((L @ u)[part], weights * mean, atol=1e-10)


@pytest.mark.parametrize("extension", [".off", ".obj", ".ply", ".stl"])
def test_what_is_written_is_read(extension, tmp_path):
    V, F = icosphere(1)
    path = tmp_path / ("sphere" + extension)
    it.write_mesh(V / 3, F, path)
    W, G = it.read_mesh(path)
    assert (W[G] == (V / 3)[F]).all() and len(W) == len(V)
    if extension != ".stl":
        assert (W == V / 3).all() and (G == F).all()
    with pytest.raises(it.InvalidSurfaceError):
        it.write_mesh(V, F + 1, path)


def test_values_and_textures_have_their_formats(tmp_path):
    V, F = KITE
    with pytest.raises(ValueError, match="name of a coordinate"):
        it.write_mesh(V, F, tmp_path / "kite.ply", values={"X": [1, 2, 3, 4.5]})
    it.write_mesh(V, F, tmp_path / "kite.ply", values={"heat": [1, 2, 3, 4.5]})
    assert b"property double heat" in (tmp_path / "kite.ply").read_bytes()
    for name, options in [("kite.off", {"values": {"heat": [1, 2, 3, 4]}}), ("kite.ply", {"uv": numpy.zeros((2, 3, 2))})]:
        with pytest.raises(ValueError, match="file_name has to end with"):
            it.write_mesh(V, F, tmp_path / name, **options)


def test_a_model_keeps_its_seams_through_transfer(tmp_path):
    """Left and right of edge 0-1, other parts of the picture are shown."""
    model = tmp_path / "model.obj"
    model.write_text("mtllib a.mtl\nv 0 0 0\nv 4 0 0\nv 2 1 0\nv 2 0 1\nvt 0 0 # first\nvt 0.5 0\nvt 0.25 1\n vt 0.5 1\\\n 0\nvt 1 1\n"
                     "usemtl a\nf 1/1 2/2 3/3\nf 2/4 1/5/1 4/-3\n")
    mesh = it.read_mesh(model, texture=True)
    assert mesh.uv.tolist() == [[0, 0], [0.5, 0], [0.25, 1], [0.5, 1], [1, 1]]
    assert mesh.corners.tolist() == [[0, 1, 2], [3, 4, 2]]
    t = it.Triangulation(mesh.V, mesh.F)
    assert t.flip_to_delaunay().flips == 1
    s = t.common_subdivision()
    triangles, polygons = s.triangles()
    uv = s.from_input_corners(mesh.uv[mesh.corners])[triangles]
    it.write_mesh(s.positions, s.corners[triangles], tmp_path / "finer.obj", uv=uv)
    finer = it.read_mesh(tmp_path / "finer.obj", texture=True)
    assert len(finer.F) == 4 and numpy.allclose(finer.uv[finer.corners], uv)
    middle = int(numpy.argmin(numpy.abs(finer.V - [2, 0, 0]).sum(axis=1)))
    found = {tuple(numpy.round(finer.uv[t], 12)) for t in finer.corners[finer.F == middle]}
    assert found == {(0.25, 0), (0.75, 1)}    # both sides of the seam


def test_textures_of_polygons_and_none(tmp_path):
    path = tmp_path / "square.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nf 1/1 2/1 3 4//\nf 1 2 5\n".replace("4//", "4"))
    mesh = it.read_mesh(path, texture=True)
    assert mesh.F == [[0, 1, 2, 3], [0, 1, 4]] and mesh.corners == [[0, 0, -1, -1], [-1, -1, -1]]
    path.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nf 1/1 2/2 3\n")
    with pytest.raises(it.InvalidFileError, match="corner 1 of the faces"):
        it.read_mesh(path, texture=True)
    with pytest.raises(ValueError, match="has to end with .obj"):
        it.read_mesh(tmp_path / "square.off", texture=True)
