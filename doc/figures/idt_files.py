# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the command idt and reads the files that it writes."""

import csv
import json
import subprocess
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

import numpy as np


class Files_error(Exception):
    """The command did not do what it was asked for, or a file is not what it should be."""


@dataclass
class Surface:
    """The triangles of an OFF file."""
    path: Path
    points: np.ndarray
    faces: np.ndarray

    @property
    def name(self):
        return self.path.stem

    def edges(self):
        """The edges as pairs of vertices, the smaller first, and whether each is on the border."""
        sides = np.sort(self.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        pairs, counts = np.unique(sides, axis=0, return_counts=True)
        return pairs, counts == 1


@dataclass
class Triangulation:
    """The intrinsic Delaunay triangulation of a surface, edge by edge."""
    ends: np.ndarray      # the vertices of each edge, the smaller first
    original: np.ndarray  # whether it is an edge of the input
    weights: np.ndarray   # cot + cot
    paths: list           # its points on the surface, one after the other
    lengths: np.ndarray   # of its edges
    points: np.ndarray    # of its vertices

    def sides(self, triangles):
        """The lengths of the sides opposite to the corners of triangles. No two edges join the same vertices."""
        lengths = {tuple(pair): length for pair, length in zip(self.ends.tolist(), self.lengths)}
        if len(lengths) < len(self.ends) or any(len(corners) != 3 for corners in triangles):
            raise Files_error("sides are found in triangulations without loops and multiple edges alone")
        return np.array([[lengths[tuple(sorted(pair))] for pair in ((j, k), (k, i), (i, j))] for i, j, k in triangles])


@dataclass
class Parameterization:
    """A map of a disk to the plane."""
    report: dict
    over_intrinsic: Path    # OBJ file of the overlay
    over_input: Path        # OBJ file of the input
    distortion: np.ndarray  # of each face of the overlay: by the map over the input, over the iDT


def read_off(path):
    """Reads an OFF file of triangles."""
    try:
        words = Path(path).read_text().split()
    except OSError as error:
        raise Files_error(f"{path} cannot be read: {error.strerror}") from error
    vertices, faces = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * vertices], dtype=float).reshape(-1, 3)
    table = np.array(words[4 + 3 * vertices:][:4 * faces], dtype=int).reshape(-1, 4)
    if words[0] != "OFF" or not (table[:, 0] == 3).all():
        raise Files_error(f"{path} is not an OFF file of triangles")
    return Surface(Path(path), points, table[:, 1:])


def write_off(path, points, faces):
    """Writes triangles without the points that none of them uses, and reads them back."""
    used, corners = np.unique(faces, return_inverse=True)
    with open(path, "w") as file:
        file.write(f"OFF\n{len(used)} {len(faces)} 0\n")
        for x, y, z in points[used].tolist():
            file.write(f"{x!r} {y!r} {z!r}\n")
        for a, b, c in corners.reshape(-1, 3).tolist():
            file.write(f"3 {a} {b} {c}\n")
    return read_off(path)


def read_obj(path):
    """Reads points, texture coordinates and faces, whose corners have the same number in both."""
    points, uv, faces = [], [], []
    for line in Path(path).read_text().splitlines():
        word, *rest = line.split()
        if word == "v":
            points.append([float(x) for x in rest])
        elif word == "vt":
            uv.append([float(x) for x in rest])
        elif word == "f":
            faces.append([int(corner.split("/")[0]) - 1 for corner in rest])
    return np.array(points), np.array(uv), faces


@dataclass
class Overlay:
    """The faces that input and triangulation have in common."""
    points: np.ndarray
    kinds: np.ndarray            # of the vertices: 0 of the input, 1 crossing, 2 inserted
    edges: np.ndarray            # at crossings, those of the input and of the triangulation
    faces: list                  # the vertices of each face
    intrinsic_faces: np.ndarray  # the triangle that contains each face

    def triangles(self):
        """The vertices of each intrinsic triangle."""
        result = defaultdict(set)
        for face, triangle in zip(self.faces, self.intrinsic_faces):
            result[triangle].update(face[self.kinds[face] != 1].tolist())
        return list(result.values())


def read_overlay(path):
    """Reads an overlay of polygons in PLY."""
    header, data = path.read_bytes().split(b"end_header\n", 1)
    number = {word[1]: int(word[2]) for word in map(str.split, header.decode().splitlines()) if word[0] == "element"}
    vertices = np.frombuffer(data, [("point", "<f8", 3), ("kind", "u1"), ("edges", "<i4", 2)], number["vertex"])
    faces, intrinsic_faces = [], []
    at = vertices.nbytes
    for _ in range(number["face"]):
        faces.append(np.frombuffer(data, "<i4", data[at], at + 1))
        at += 1 + faces[-1].nbytes
        intrinsic_faces.append(int.from_bytes(data[at + 4:at + 8], "little"))
        at += 8
    return Overlay(vertices["point"], vertices["kind"], vertices["edges"], faces, np.array(intrinsic_faces))


class Idt:
    """The command, working in a folder of its own."""

    def __init__(self, executable, folder):
        self.executable = executable
        self.folder = Path(folder)

    def run(self, *arguments):
        """Runs the command and returns what it printed."""
        line = [self.executable, *map(str, arguments)]
        try:
            result = subprocess.run(line, cwd=self.folder, capture_output=True, text=True, check=False)
        except OSError as error:
            raise Files_error(f"{self.executable} cannot be run: {error.strerror}") from error
        if result.returncode != 0:
            raise Files_error(f"{' '.join(line)}\n{result.stderr.strip()}")
        return result.stdout

    def sample(self, name):
        """Writes a built-in surface and reads it."""
        return read_off(self.folder / self.run("sample", name, "-o", name).strip())

    def triangulate(self, surface):
        """Makes a surface Delaunay."""
        return self._triangulation("triangulate", surface)

    def refine(self, surface):
        """Makes a surface Delaunay, and refines it."""
        return self._triangulation("refine", surface, "--points", "points.csv")

    def _triangulation(self, command, surface, *options):
        self.run(command, surface.path, "--edges", "edges.csv", "--crossings", "crossings.csv",
                 "--overlay", "overlay.ply", *options)
        points = surface.points
        if options:
            with open(self.folder / "points.csv") as file:
                added = [[float(row[axis]) for axis in "xyz"] for row in csv.DictReader(file)]
            points = np.array([*points, *added])
        with open(self.folder / "edges.csv") as file:
            rows = list(csv.DictReader(file))
        ends = np.array([[int(row["source"]), int(row["target"])] for row in rows])
        crossings = [[] for _ in rows]
        with open(self.folder / "crossings.csv") as file:
            for row in csv.DictReader(file):
                p, q = surface.points[int(row["input_source"])], surface.points[int(row["input_target"])]
                u = float(row["u"])
                crossings[int(row["edge"])].append((1 - u) * p + u * q)
        return Triangulation(
            ends=np.sort(ends, axis=1),
            original=np.array([row["original"] == "1" for row in rows]),
            weights=np.array([float(row["cotan_weight"] or "nan") for row in rows]),
            paths=[np.array([points[i], *inner, points[j]])[::1 if i <= j else -1] for (i, j), inner in zip(ends, crossings)],
            lengths=np.array([float(row["length"]) for row in rows]),
            points=points)

    def overlay(self):
        """The overlay of the last run."""
        return read_overlay(self.folder / "overlay.ply")

    def geodesic(self, surface, *options):
        """The points of a straight line on a surface, and the report about it."""
        self.run("geodesic", surface.path, *options, "-o", "line.csv", "--stats", "line.json")
        with open(self.folder / "line.csv") as file:
            points = np.array([[float(row[axis]) for axis in "xyz"] for row in csv.DictReader(file)])
        return points, json.loads((self.folder / "line.json").read_text())

    def distances(self, surface, source):
        """For each vertex its distance from a source, and the axis of the source, carried there."""
        self.run("distance", surface.path, "--source", source, "--cover", "none", "--vectors", "-o", "distances.csv")
        with open(self.folder / "distances.csv") as file:
            rows = list(csv.DictReader(file))
        return (np.array([float(row["distance"]) for row in rows]),
                np.array([[float(row[f"axis_{axis}"]) for axis in "xyz"] for row in rows]))

    def compare_samples(self, *number_types):
        """Runs number types on all built-in surfaces, for some minutes."""
        paths = [self.run("sample", name, "-o", name).strip() for name in self.run("sample", "--list").split()]
        self.run("compare", *paths, "--number-types", ",".join(number_types), "--precisions", 128,
                 "--repetitions", 3, "--time-limit", 10, "--json", "compare.json")
        return json.loads((self.folder / "compare.json").read_text())

    def parameterize(self, surface, name, *options):
        """Maps a disk to the plane."""
        files = {key: self.folder / f"{name}-{key}"
                 for key in ("uv.obj", "input.obj", "d.csv", "report.json")}
        self.run("parameterize", surface.path, *options, "--uv", files["uv.obj"], "--uv-input",
                 files["input.obj"], "--distortion", files["d.csv"], "--json", files["report.json"])
        with open(files["d.csv"]) as file:
            distortion = [[float(row[key] or "inf") for key in ("over_input", "over_intrinsic")]
                          for row in csv.DictReader(file)]
        return Parameterization(json.loads(files["report.json"].read_text()), files["uv.obj"],
                                files["input.obj"], np.array(distortion))
