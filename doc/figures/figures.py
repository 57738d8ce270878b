# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of the paper, redone: each function draws one of them on any surface."""

import numpy as np
from matplotlib import pyplot
from matplotlib.lines import Line2D

from idt_files import read_obj
from pages import page_of_images
from scene import bands, polygons, render, textured, tubes

WHITE, GREY, BLACK, RED = (1, 1, 1), (0.3, 0.36, 0.45), (0, 0, 0), (0.85, 0.05, 0.05)
KEPT = (WHITE, "in both")
GONE = (BLACK, "in the input alone")
NEW = (RED, "in the intrinsic Delaunay triangulation (iDT) alone")


def _edges(surface, triangulation):
    """The paths of the edges that stay, of those that go and of those that are new."""
    kept = {tuple(pair) for pair in triangulation.ends[triangulation.original]}
    pairs, _ = surface.edges()
    stay = [surface.points[pair] for pair in pairs if tuple(pair) in kept]
    gone = [surface.points[pair] for pair in pairs if tuple(pair) not in kept]
    new = [path for path, original in zip(triangulation.paths, triangulation.original) if not original]
    return stay, gone, new


def _draw(surface, layers, camera, radius):
    """The surface with layers of lines, each of paths and a color."""
    size = radius * np.linalg.norm(np.ptp(surface.points, axis=0))
    lines = [tubes(paths, color, size) for paths, color in layers if paths]
    return render([polygons(surface.points, surface.faces), *lines], camera)


def _legend(page, entries):
    lines = [Line2D([], [], color=color, linewidth=3) for color, _ in entries]
    legend = page.legend(lines, [text for _, text in entries], loc="lower center", ncol=len(entries),
                         frameon=True, facecolor="0.72", edgecolor="none", handlelength=1.5)
    legend.set_in_layout(False)


def edges_before_and_after(surface, triangulation, camera, radius):
    """Figures 1 and 2: the input and its intrinsic Delaunay triangulation on the same surface."""
    stay, gone, new = _edges(surface, triangulation)
    images = [_draw(surface, [(stay, WHITE), (gone, BLACK)], camera, radius),
              _draw(surface, [(stay, WHITE), (new, RED)], camera, radius)]
    titles = [f"input: {len(stay)} edges stay, {len(gone)} go", f"iDT: {len(new)} edges are new"]
    width, height = camera.size
    page = page_of_images(images, titles, columns=1 if width > 2 * height else 2)
    _legend(page, [KEPT, GONE, NEW])
    return page


def solutions(surface, triangulation, overlay, before, after, error, camera, radius):
    """What an equation on a surface gives with its own triangles and with those of its refined iDT.

    `before` has the values at the vertices of the input, `after` those at the vertices of the overlay; `error` is that of each.
    """
    stay, gone, new = _edges(surface, triangulation)
    size = radius * np.linalg.norm(np.ptp(surface.points, axis=0))
    shades = pyplot.get_cmap("cividis")(np.linspace(0, 1, 19))
    images = [render([bands(surface.points, surface.faces, before, (-1, 1), shades), tubes(stay + gone, GREY, size / 4)], camera),
              _draw(surface, [(stay, WHITE), (new, RED)], camera, radius),
              render([bands(overlay.points, overlay.faces, after, (-1, 1), shades)], camera)]
    titles = [f"on the given triangles: error {error[0]:.2f}", "the refined iDT", f"on the refined iDT: error {error[1]:.3f}"]
    return page_of_images(images, titles, columns=3)


def overlays(subjects):
    """Figure 7: the edges of both triangulations on several surfaces.

    `subjects` are tuples of surface, triangulation, camera, radius of the lines.
    """
    images, titles = [], []
    for surface, triangulation, camera, radius in subjects:
        stay, gone, new = _edges(surface, triangulation)
        images.append(_draw(surface, [(stay, WHITE), (gone, BLACK), (new, RED)], camera, radius))
        titles.append(f"{surface.name}: {len(new):,} of {len(new) + len(stay):,} edges are new")
    page = page_of_images(images, titles, columns=2)
    _legend(page, [KEPT, GONE, NEW])
    return page


def input_weights(surface):
    """The cotangent weights of the interior edges of the input, from its points."""
    pairs, on_border = surface.edges()
    weights = dict.fromkeys(map(tuple, pairs), 0.0)
    for turn in range(3):
        i, j, k = np.roll(surface.faces, turn, axis=1).T
        u, v = surface.points[i] - surface.points[k], surface.points[j] - surface.points[k]
        cotangents = (u * v).sum(axis=1) / np.linalg.norm(np.cross(u, v), axis=1)
        for pair, cotangent in zip(np.sort(np.stack([i, j], axis=1), axis=1), cotangents):
            weights[tuple(pair)] += cotangent
    return np.array([weights[tuple(pair)] for pair, border in zip(pairs, on_border) if not border])


def weight_histogram(surface, triangulation):
    """Figure 6: the coefficients of the two operators."""
    pairs, on_border = surface.edges()
    border = {tuple(pair) for pair in pairs[on_border]}
    inner = np.array([not (original and tuple(pair) in border)
                      for pair, original in zip(triangulation.ends, triangulation.original)])
    page, all_axes = pyplot.subplots(1, 2, figsize=(9.6, 3.4), sharey=True, layout="constrained")
    for axes, weights, title in [
            (all_axes[0], input_weights(surface), "input"),
            (all_axes[1], triangulation.weights[inner], "iDT")]:
        bins = np.linspace(-10, 10, 41)
        inside = np.clip(weights, -9.99, 9.99)
        axes.hist(inside[weights >= 0], bins, color="0.45")
        axes.hist(inside[weights < 0], bins, color=RED)
        axes.set_yscale("log")
        axes.set_title(f"{title}: {(weights < 0).sum():,} of {len(weights):,} weights are negative")
        axes.set_xlabel(f"cot + cot, from {weights.min():.3g} to {weights.max():.3g}")
    all_axes[0].set_ylabel("number of edges")
    return page


def refinement(surface, triangulations, camera, radius):
    """Edges and angles of a surface, of its iDT, and of the iDT after refinement.

    `triangulations` has the last two, with the angles of each.
    """
    pairs, _ = surface.edges()
    size = camera.size
    page, all_axes = pyplot.subplots(2, 3, figsize=(9.6, 3.2 * size[1] / size[0] + 2.4), layout="constrained",
                                     height_ratios=[3.2 * size[1] / size[0], 2.1])
    corners = surface.points[surface.faces]
    before, after = np.roll(corners, 1, axis=1) - corners, np.roll(corners, -1, axis=1) - corners
    angles = np.degrees(np.arctan2(np.linalg.norm(np.cross(after, before), axis=2), (after * before).sum(axis=2)))
    for column, (title, paths, values) in enumerate([
            ("input", [surface.points[pair] for pair in pairs], angles.ravel()),
            *((title, triangulation.paths, values)
              for title, (triangulation, values) in zip(["iDT", "refined iDT"], triangulations))]):
        all_axes[0, column].imshow(_draw(surface, [(paths, BLACK)], camera, radius))
        all_axes[0, column].set_axis_off()
        all_axes[0, column].set_title(f"{title}: {len(values) // 3:,} triangles")
        axes = all_axes[1, column]
        _, bins, bars = axes.hist(values, np.linspace(0, 180, 73), color="0.45")
        for left, bar in zip(bins, bars):
            if left < 25:
                bar.set_facecolor(RED)
        axes.axvline(25, color="0.2", linewidth=0.8, linestyle=":")
        axes.set_xlabel(f"angle, from {values.min():.3g} to {values.max():.3g} degrees")
    all_axes[1, 0].set_ylabel("number of angles")
    return page


def geodesics(panels):
    """Straight lines on surfaces.

    `panels` are tuples of surface, camera, radius, and lines with their reports.
    """
    images, titles = [], []
    for surface, camera, radius, lines in panels:
        pairs, _ = surface.edges()
        size = radius * np.linalg.norm(np.ptp(surface.points, axis=0))
        images.append(render([polygons(surface.points, surface.faces),
                              tubes([surface.points[pair] for pair in pairs], GREY, size / 4),
                              tubes([points for points, _ in lines], RED, size)], camera))
        before, after = (sum(report[key] for _, report in lines) for key in ("initial_length", "length"))
        titles.append(f"{surface.name}: length {after:.3f}, along edges {before:.3f}")
    return page_of_images(images, titles, columns=2)


def distances(surface, values, axes, camera, radius):
    """Isolines of the distance from a source, and the axis of the source, carried to all vertices."""
    pairs, _ = surface.edges()
    lengths = np.linalg.norm(surface.points[pairs[:, 0]] - surface.points[pairs[:, 1]], axis=1)
    ends = surface.points + 0.6 * np.mean(lengths) * axes
    size = radius * np.linalg.norm(np.ptp(surface.points, axis=0))
    number = 24
    shades = [pyplot.get_cmap("YlGnBu")(0.15 + 0.75 * (i % 2 + i / number) / 2) for i in range(number)]
    images = [render([bands(surface.points, surface.faces, values, (0, float(np.max(values))), shades)], camera),
              render([polygons(surface.points, surface.faces),
                      tubes([[point, end] for point, end in zip(surface.points, ends)], RED, size)], camera)]
    return page_of_images(images, ["the distance from a vertex", "a vector there, carried along shortest ways"], columns=2)


def maps_to_the_plane(triangulation, maps):
    """Figure 8: the triangles in the plane, by the extrinsic and by the intrinsic operator.

    `maps` has for each kind of boundary its name and the two parameterizations.
    """
    page, all_axes = pyplot.subplots(len(maps), 2, figsize=(9.6, 4.9 * len(maps)), layout="constrained",
                                     squeeze=False)
    for row, (boundary, extrinsic, intrinsic) in zip(all_axes, maps):
        _, uv, faces = read_obj(extrinsic.over_input)
        corners = uv[np.array(faces)]
        u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        flipped = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0] < 0
        row[0].triplot(*uv.T, faces, color="0.25", linewidth=0.5)
        for triangle in corners[flipped]:
            row[0].fill(*triangle.T, facecolor=RED, edgecolor=RED, linewidth=1.5)
        row[0].set_title(f"extrinsic, {boundary}: {flipped.sum()} triangles flipped")
        # Intrinsic edges are straight lines in the plane.
        _, uv, _ = read_obj(intrinsic.over_intrinsic)
        for ends, original in zip(triangulation.ends, triangulation.original):
            row[1].plot(*uv[ends].T, color="0.25" if original else RED, linewidth=0.5)
        count = intrinsic.report["over_intrinsic"]["flipped"]
        row[1].set_title(f"intrinsic, {boundary}: {count} triangles flipped")
        for axes in row:
            axes.set_aspect("equal")
            axes.set_axis_off()
    return page


def _distortion_text(quality):
    mean, percentile = quality["mean_distortion"], quality["percentile_99_distortion"]
    return f"{mean:.3f} in the mean, {percentile:.2f} at 99 %"


def interpolations(parameterization, camera):
    """Figure 9: the same images of the vertices, interpolated over the input and over the iDT."""
    images = [render([textured(path)], camera)
              for path in (parameterization.over_input, parameterization.over_intrinsic)]
    titles = ["over the input: distortion " + _distortion_text(parameterization.report["over_input"]),
              "over the iDT: distortion " + _distortion_text(parameterization.report["over_intrinsic"])]
    return page_of_images(images, titles, columns=2)
