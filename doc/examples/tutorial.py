# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# From a bad mesh to eigenfunctions, distances and a texture on a better triangulation of the same surface. Each step draws a figure.
#
#   python3 tutorial.py FOLDER        # writes FOLDER/1_triangles.png and so on; needs matplotlib

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")  # files, no windows

import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from scipy.sparse import diags
from scipy.sparse.linalg import eigsh

import intrinsic_triangulations as it


def bad_torus(around, along):
    """a torus of long and thin triangles, with texture coordinates at the corners: they jump at two seams."""
    u, v = (a.ravel() for a in np.meshgrid(np.arange(around), np.arange(along), indexing="ij"))
    V = torus(u / around + 0.08 * np.sin(2 * np.pi * v / along), v / along)
    corner = lambda i, j: (i % around) * along + j % along
    right, up = u + 1, v + 1
    F = np.concatenate([np.stack([corner(u, v), corner(right, v), corner(right, up)], axis=1),
                        np.stack([corner(u, v), corner(right, up), corner(u, up)], axis=1)])
    uv = np.concatenate([np.stack([np.stack([i / around, j / along], axis=1) for i, j in corners], axis=1)
                         for corners in (((u, v), (right, v), (right, up)), ((u, v), (right, up), (u, up)))])
    return V, F, uv


def torus(u, v):
    """the point with these two angles, in turns."""
    u, v = 2 * np.pi * u, 2 * np.pi * v
    return np.stack([(2 + 0.8 * np.cos(v)) * np.cos(u), (2 + 0.8 * np.cos(v)) * np.sin(u), 0.8 * np.sin(v)], axis=1)


def draw(axes, triangles, colors, title, edges=False):
    """triangles in space, with a color for each, darker where they are turned away."""
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    light = 0.6 + 0.4 * np.abs(normals @ [0.3, -0.5, 0.81])
    shaded = np.clip(np.asarray(colors)[:, :3] * light[:, None], 0, 1)
    axes.add_collection3d(Poly3DCollection(triangles, facecolors=shaded, edgecolors=(0, 0, 0, 0.6) if edges else shaded,
                                           linewidths=0.3 if edges else 0.1))
    axes.set(xlim=(-2, 2), ylim=(-2, 2), zlim=(-1.6, 1.6), title=title)
    axes.set_axis_off()
    axes.view_init(50, -60)


def figure(path, number):
    """a figure with some pictures of the surface; returns it, and how to write it."""
    fig = plt.figure(figsize=(4 * number, 4), constrained_layout=True)

    def save():
        fig.savefig(path, dpi=100)
        plt.close(fig)

    return [fig.add_subplot(1, number, i + 1, projection="3d") for i in range(number)], save


def main(folder, around=60, along=12):
    folder.mkdir(parents=True, exist_ok=True)
    grey = np.array([0.85, 0.85, 0.8])

    # 1. A bad mesh, and the same surface with other triangles. No vertex moves, and no length on the surface changes.
    V, F, uv = bad_torus(around, along)
    mesh = it.Triangulation(V, F)
    flipped = mesh.copy()
    flipped.flip_to_delaunay()
    refined = mesh.copy()
    refined.refine(minimum_angle=25)
    angles = [np.degrees(t.angles).min() for t in (mesh, flipped, refined)]
    print("smallest angle: %.1f degrees, after flips %.1f, refined %.1f" % tuple(angles))
    pieces = refined.common_subdivision()
    triangles, polygons = pieces.triangles()
    in_space = pieces.positions[pieces.corners[triangles]]
    shades = np.random.default_rng(0).uniform(0.55, 1, (refined.number_of_faces, 1)) * [[0.6, 0.8, 1.0]]
    (left, right), save = figure(folder / "1_triangles.png", 2)
    draw(left, V[F], np.tile(grey, (len(F), 1)), "the mesh", edges=True)
    draw(right, in_space, shades[pieces.intrinsic_faces[polygons]], "refined: a color for each triangle")
    save()

    # 2. Eigenfunctions of the Laplace operator. On the refined triangulation they are much nearer to those of the surface; those of the bad
    # mesh itself are far off. Values at the vertices of the input come first.
    values = {}
    for name, (L, M) in {"cotangents of the mesh": (it.cotan_laplacian(V, F), diags(it.vertex_areas(V, F))),
                         "intrinsic Delaunay": flipped.laplacian(), "refined": refined.laplacian()}.items():
        values[name], functions = eigsh(L.tocsc(), 8, M.tocsc(), sigma=-0.01)
        print(f"{name}: eigenvalues", np.round(values[name][1:6], 3))
    axes, save = figure(folder / "2_eigenfunctions.png", 3)
    for k, ax in zip((1, 3, 5), axes):
        on_pieces = pieces.from_intrinsic(functions[:, k])[pieces.corners[triangles]].mean(axis=1)
        draw(ax, in_space, plt.cm.RdBu(0.5 + 0.5 * on_pieces / abs(on_pieces).max()), f"eigenvalue {values['refined'][k]:.3f}")
    save()

    # 3. Distances from a vertex by the heat method, on the mesh and refined; and a shortest path.
    source = 0
    coarse = it.compute_distance(V, F, source)
    fine = it.MeshHeatMethodDistanceSolver.from_triangulation(refined).compute_distance(source)
    farthest = int(fine[:len(V)].argmax())
    path = it.geodesic_path(V, F, source, farthest)
    print("to the farthest vertex: %.4f on the mesh, %.4f refined; a straight path of length %.4f" %
          (coarse[farthest], fine[farthest], path.length))
    stripes = lambda d: plt.cm.viridis(np.where((d * 8).astype(int) % 2 == 0, d / fine.max(), 1))
    axes, save = figure(folder / "3_distances.png", 2)
    on_pieces = pieces.from_intrinsic(fine)[pieces.corners[triangles]].mean(axis=1)
    draw(axes[0], V[F], stripes(coarse[F].mean(axis=1)), "distance on the mesh")
    draw(axes[1], in_space, stripes(on_pieces), "refined, and a path")
    axes[1].plot(*path.positions.T, color="red", linewidth=2, zorder=10)
    save()

    # 4. The texture of the mesh on the pieces into which both triangulations cut the surface: seams stay where they are.
    at_corners = pieces.from_input_corners(uv)[triangles]
    middle = at_corners.mean(axis=1)
    checks = (np.floor(24 * middle[:, 0]) + np.floor(9 * middle[:, 1])).astype(int) % 2
    jumps = abs(at_corners - middle[:, None]).max()
    print(f"within a piece, texture coordinates differ by less than {2 * jumps:.2f}: no seam runs through one")
    (axes,), save = figure(folder / "4_texture.png", 1)
    draw(axes, in_space, np.where(checks[:, None] == 1, [[0.9, 0.5, 0.2]], [[0.95, 0.95, 0.9]]), "texture")
    save()
    return angles, values, (coarse, fine, path, farthest), (at_corners, in_space)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python3 tutorial.py FOLDER")
    main(pathlib.Path(sys.argv[1]))
