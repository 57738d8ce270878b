# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which figure is drawn of which surface, and from where it is seen."""

from dataclasses import dataclass
from typing import Callable

import numpy as np

import figures
import kernels
import surfaces
from idt_files import read_off
from pages import save
from scene import Camera


@dataclass
class Subject:
    """A surface, made or read when it is wanted, and a view of it."""
    surface: Callable  # from an Idt
    camera: Camera = None
    radius: float = 0.0018  # of the lines, relative to the size of the surface


def sample(name):
    return lambda idt: idt.sample(name)


def part(direction, center, height):
    """A view of a part of a surface, for one panel of four."""
    return Camera(direction, center=center, height=height, size=(400, 360))


DOME = sample("bumpy-dome")

SAMPLES = {
    "solutions": Subject(lambda idt: surfaces.folded_sheet(idt.folder / "sheet.off"),
                         Camera((0.15, -1, 1.5), size=(320, 270)), 0.0013),
    "edges": Subject(DOME, Camera((1, -1.2, 0.9))),
    "thin-tube": Subject(lambda idt: surfaces.thin_tube(idt.folder / "thin-tube.off"),
                         Camera((1, 0.2, 0.1), up=(0.1, -1, 0), size=(960, 190)), 0.0028),
    "overlays": [
        Subject(sample("bumpy-sphere"), part((1, -1, 0.7), center=(0.5, -0.5, 0.4), height=0.9), 0.001),
        Subject(sample("bad-torus"), part((0.1, -1, 0.5), center=(0, -1.2, 0.2), height=0.4), 0.0004),
        Subject(sample("Schwarz-lantern"), part((1, 0, 0), center=(1, 0, 0.5), height=0.45), 0.0005),
        Subject(sample("disk-with-spike"), part((1, -1, 2), center=(0, 0, 0.3), height=1.7), 0.0008)],
    "weights": Subject(sample("bumpy-sphere")),
    "maps": Subject(DOME),
    "interpolation": Subject(DOME, Camera((1, -1.2, 0.1), center=(0.6, -0.7, -0.15), height=0.95)),
    "refinement": Subject(DOME, Camera((1, -1.2, 0.9), size=(400, 360)), 0.0012),
    "geodesics": [Subject(sample("torus"), Camera((1, -1.2, 1.6)), 0.003),
                  Subject(sample("bumpy-sphere"), Camera((1, -1, 0.7)), 0.0022)],
    "distances": Subject(sample("bumpy-sphere"), Camera((1, -1, 0.7)), 0.0016),
    "kernels": None,  # all samples, and no view
}


def table_1(folder):
    """The same figures of the meshes of the paper."""
    def model(name):
        return lambda idt: read_off(folder / f"{name}.off")

    return {
        "edges": Subject(model("cathead"), Camera((0.3, 0.3, 1), up=(0, 1, 0))),
        "overlays": [Subject(model("bunnyhead"), Camera((0.3, 0.3, 1), up=(0, 1, 0))),
                     Subject(model("beautiful_freak"), Camera((0.3, 0.3, 1), up=(0, 1, 0))),
                     Subject(model("hygeia"), Camera((0.3, 0.3, 1), up=(0, 1, 0)), 0.0006),
                     Subject(model("horse"), Camera((1, 0.3, 0.3)), 0.0003)],
        "weights": Subject(model("hygeia")),
        "refinement": Subject(model("bunnyhead"), Camera((0.3, 0.3, 1), up=(0, 1, 0), size=(400, 360))),
        "maps": Subject(model("beautiful_freak")),
        "interpolation": Subject(model("bunnyhead"), Camera((0.3, 0.3, 1), up=(0, 1, 0))),
    }


def draw_edges(idt, subject):
    surface = subject.surface(idt)
    return figures.edges_before_and_after(surface, idt.triangulate(surface), subject.camera, subject.radius)


def solve(triangles, sides, right):
    """Solves u - Δu = f by linear finite elements, from the values of f at the vertices."""
    matrix, mass = np.zeros((2, len(right), len(right)))
    for corners, (a, b, c) in zip(map(list, triangles), sides):
        area = np.sqrt((a + b + c) * (b + c - a) * (c + a - b) * (a + b - c)) / 4
        cross = np.array([[-2 * a * a, a * a + b * b - c * c, c * c + a * a - b * b],
                          [0, -2 * b * b, b * b + c * c - a * a], [0, 0, -2 * c * c]])
        mass[np.ix_(corners, corners)] += area / 12 * (1 + np.eye(3))
        matrix[np.ix_(corners, corners)] -= (np.triu(cross) + np.triu(cross, 1).T) / (8 * area)
    return np.linalg.solve(matrix + mass, mass @ right)


def at_crossings(triangulation, overlay, values):
    """Values at the vertices of the overlay: linear on each edge."""
    result = np.array([*values, *np.zeros(len(overlay.points) - len(values))])
    for x in np.flatnonzero(overlay.kinds == 1):
        edge = overlay.edges[x, 1]
        path = triangulation.paths[edge]
        along = np.cumsum([0, *np.linalg.norm(np.diff(path, axis=0), axis=1)])
        nearest = np.argmin(np.linalg.norm(path - overlay.points[x], axis=1))
        result[x] = np.interp(along[nearest], [0, along[-1]], values[triangulation.ends[edge]])
    return result


def draw_solutions(idt, subject):
    """-Δu = 2π² u for a wave on a folded sheet, without heat through its border."""
    surface = subject.surface(idt)
    triangulation = idt.refine(surface)
    overlay = idt.overlay()
    values, errors = [], []
    given = [np.linalg.norm(surface.points[surface.faces[:, (i + 2) % 3]] - surface.points[surface.faces[:, (i + 1) % 3]], axis=1)
             for i in range(3)]
    triangles = overlay.triangles()
    for points, corners, sides in [(surface.points, surface.faces, np.stack(given, axis=1)),
                                   (triangulation.points, triangles, triangulation.sides(triangles))]:
        wave = surfaces.wave_on_sheet(points)
        values.append(solve(corners, sides, (1 + 2 * np.pi ** 2) * wave))
        errors.append(np.abs(values[-1] - wave).max())
    return figures.solutions(surface, triangulation, overlay, values[0], at_crossings(triangulation, overlay, values[1]),
                             errors, subject.camera, subject.radius)


def draw_overlays(idt, subjects):
    def panel(subject):
        surface = subject.surface(idt)
        return surface, idt.triangulate(surface), subject.camera, subject.radius
    return figures.overlays([panel(subject) for subject in subjects])


def draw_weights(idt, subject):
    surface = subject.surface(idt)
    return figures.weight_histogram(surface, idt.triangulate(surface))


def draw_refinement(idt, subject):
    surface = subject.surface(idt)
    triangulations = []
    for make in (idt.triangulate, idt.refine):
        triangulation = make(surface)
        a, b, c = triangulation.sides(idt.overlay().triangles()).T
        cosines = [(y * y + z * z - x * x) / (2 * y * z) for x, y, z in ((a, b, c), (b, c, a), (c, a, b))]
        triangulations.append((triangulation, np.degrees(np.arccos(np.clip(cosines, -1, 1))).ravel()))
    return figures.refinement(surface, triangulations, subject.camera, subject.radius)


def draw_geodesics(idt, subjects):
    """A closed curve that winds once along a torus and three times round it; and a star of paths."""
    torus, star = subjects
    surface = torus.surface(idt)
    columns, rows = 60, 30
    through = [(6 * i) % rows * columns + (4 * i) % columns for i in range(15)]
    loop = idt.geodesic(surface, "--closed", "--from", through[0], *(word for v in through[1:] for word in ("--via", v)))
    panels = [(surface, torus.camera, torus.radius, [loop])]
    surface = star.surface(idt)
    forward = np.array(star.camera.direction)
    right = np.cross(star.camera.up, forward)
    upward = np.cross(forward, right)
    right, upward = (axis / np.linalg.norm(axis) for axis in (right, upward))
    nearest = np.argmax(surface.points @ forward)
    outline = {int(np.argmax(surface.points @ (np.cos(t) * right + np.sin(t) * upward)))
               for t in np.linspace(0, 2 * np.pi, 36, endpoint=False)}
    paths = [idt.geodesic(surface, "--from", nearest, "--to", v) for v in sorted(outline)]
    panels.append((surface, star.camera, star.radius, paths))
    return figures.geodesics(panels)


def draw_distances(idt, subject):
    surface = subject.surface(idt)
    source = np.argmax(surface.points @ np.array(subject.camera.direction))
    return figures.distances(surface, *idt.distances(surface, source), subject.camera, subject.radius)


def draw_maps(idt, subject):
    surface = subject.surface(idt)
    maps = [(title, *(idt.parameterize(surface, f"{boundary}-{operator}", "--boundary", boundary,
                                       "--laplacian", operator)
                      for operator in ("extrinsic", "intrinsic")))
            for boundary, title in [("disk", "boundary on a circle"), ("natural", "natural boundary")]]
    return figures.maps_to_the_plane(idt.triangulate(surface), maps)


def draw_interpolation(idt, subject):
    return figures.interpolations(idt.parameterize(subject.surface(idt), "map"), subject.camera)


def draw_kernels(idt, _):
    return kernels.comparison(idt.compare_samples(
        "half-angle-double", "float", "double", "long-double", "float128", "interval", "mpfr", "core",
        "filtered"))


# The names of the pictures: that of README, those of the paper, figures 1, 2, 6, 7, 8 and 9, and four more.
DRAW = {"solutions": draw_solutions, "edges": draw_edges, "thin-tube": draw_edges, "weights": draw_weights, "overlays": draw_overlays,
        "maps": draw_maps, "interpolation": draw_interpolation,
        "refinement": draw_refinement, "geodesics": draw_geodesics, "distances": draw_distances, "kernels": draw_kernels}
LINE_DRAWINGS = ("weights", "maps", "kernels")  # these have few colors


def draw(idt, subjects, output, only):
    """Draws the picture `only` of these subjects, or each one that has a subject."""
    for name, function in DRAW.items():
        if name in subjects and only in (None, name):
            save(function(idt, subjects[name]), output / f"{name}.png",
                 colors=16 if name in LINE_DRAWINGS else 64)
