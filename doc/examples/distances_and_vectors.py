# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Distances, values and vectors that spread over a mesh, paths and lines.
#
#   python3 distances_and_vectors.py MESH.off RESULTS.npz
#
# Written as for potpourri3d: only the import is another one.

import sys

import numpy as np

import intrinsic_triangulations as pp3d
from many_surfaces import read_off  # beside this file


def distances(V, F, sources):
    """from the first source, from all, and with a solver that is used twice."""
    solver = pp3d.MeshHeatMethodDistanceSolver(V, F)
    return {"one": pp3d.compute_distance(V, F, sources[0]), "again": solver.compute_distance(sources[0]),
            "nearest": solver.compute_distance_multisource(sources)}


def vectors(V, F, sources):
    """values and tangent vectors of the sources at all vertices, in space; and how far each vertex lies from the first source."""
    solver = pp3d.MeshVectorHeatSolver(V, F)
    x, y, normal = solver.get_tangent_frames()
    carried = solver.transport_tangent_vector(sources[0], [1.0, 0.0])
    several = solver.transport_tangent_vectors(sources, [[1.0, 0.0]] * len(sources))
    log_map = solver.compute_log_map(sources[0])
    return {"values": solver.extend_scalar(sources, np.arange(float(len(sources)))),
            "normal": normal,
            "carried_length": np.linalg.norm(carried[:, :1] * x + carried[:, 1:] * y, axis=1),
            "several_length": np.linalg.norm(several, axis=1),
            "radius": np.linalg.norm(log_map, axis=1)}


def lines(V, F, sources):
    """a path between two vertices, one through all, a closed one, and a line in a direction."""
    length = lambda points: np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    paths, tracer = pp3d.EdgeFlipGeodesicSolver(V, F), pp3d.GeodesicTracer(V, F)
    corner = V[F[0]]
    return {"path": length(paths.find_geodesic_path(sources[0], sources[1])),
            "path_through": length(paths.find_geodesic_path_poly(sources)),
            "loop": length(paths.find_geodesic_loop(sources)),
            "line_end": tracer.trace_geodesic_from_face(0, [0.2, 0.3, 0.5], 5 * (corner[1] - corner[0]) + (corner[2] - corner[0]))[-1]}


def everything(V, F, sources):
    """all of it, in a dictionary."""
    return {**distances(V, F, sources), **vectors(V, F, sources), **lines(V, F, sources)}


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: python3 distances_and_vectors.py MESH.off RESULTS.npz")
    mesh = read_off(sys.argv[1])
    count = len(mesh[0])
    result = everything(*mesh, [0, count // 3, 2 * count // 3])
    np.savez(sys.argv[2], **result)
    print("largest distance", round(float(result["one"].max()), 3))
