# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Coordinates times a power of two: lengths are exactly as many times as long, and everything else is the same.

import numpy
import pytest

import intrinsic_triangulations as it


def bumpy(V, F):
    return V + 0.05 * numpy.random.default_rng(5).normal(size=V.shape), F


def cap(V, F):
    kept = F[(V[F][:, :, 2] > -0.3).all(axis=1)]
    used = numpy.unique(kept)
    return V[used], numpy.searchsorted(used, kept)


# Each function returns numbers by their dimension: what is scaled by the unit to that power.

def triangulation(V, F, unit):
    t = it.Triangulation(V, F)
    report = t.flip_to_delaunay()
    stiffness, mass = t.laplacian("galerkin")
    return {0: [*report, t.faces, t.weights, t.angles, stiffness.data], 1: [t.lengths, t.positions], 2: [t.areas, mass.data, t.mass]}


def any_triangles(V, F, unit):
    L, M = it.laplacian(V, F)
    f = numpy.cos(numpy.arange(len(V)))
    return {0: [L.data], 2: [M.data, it.vertex_areas(V, F), it.solve_poisson(L, M, f - (M @ f).sum() / M.sum())]}


def refined(V, F, unit, **options):
    t = it.Triangulation(V, F)
    report = t.refine(**options)
    mesh = t.straight_mesh(maximum_deviation=0.02 * unit)
    subdivision = t.common_subdivision()
    masses = [m.data for m in subdivision.mass_matrices()]
    return {0: [t.faces, report.insertions, report.segment_splits, mesh.triangles, mesh.minimum_angle, subdivision.input_faces,
                t.inserted_vertices[1]],
            1: [t.lengths, mesh.points, mesh.deviation, mesh.deviation_place, mesh.sufficient_deviation and unit, subdivision.positions],
            2: masses}


def refined_by_sizes(V, F, unit):
    return refined(V, F, unit, sizes=unit * (0.1 + 0.01 * (V[:, 2] > 0)), maximum_circumradius=0.4 * unit, minimum_size=0.001 * unit)


def refined_to_deviation(V, F, unit):
    return refined(V, F, unit, maximum_deviation=0.02 * unit, maximum_normal_angle=30, sharp_edge_angle=40)


def simplified(V, F, unit):
    s = it.Triangulation(V, F).simplify(maximum_change=0.2)
    found = it.SimplifiedDistances(V, F, 0.1).distances(0)
    return {0: [s.kept, s.shrink, s.stretch, s.prolongation.data], 1: [s.triangulation.lengths, *found]}


def heat(V, F, unit):
    solver, vectors = it.MeshHeatMethodDistanceSolver(V, F), it.MeshVectorHeatSolver(V, F)
    return {0: [*vectors.get_tangent_frames(), vectors.transport_tangent_vector(0, [1, 2]), solver.extend_scalar([0, 5], [1, 2])],
            1: [solver.compute_distance(0), solver.compute_distance_from([F[3, :2]]), vectors.compute_log_map(0)]}


def distances(V, F, unit):
    curve = [[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    lines = [line for tolerance in (0, 0.001)
             for line in it.isolines(V, F, [0], [0.4 * unit, 0.9 * unit], tolerance) + it.borders_of_cells(V, F, [0, 9], tolerance)]
    return {0: [it.farthest_vertices(V, F, 4)[0], *(line.places for line in lines)],
            1: [it.geodesic_distances(V, F, [0, 7]), it.geodesic_distances(V, F, 0, 0), it.geodesic_distance_matrix(V, F, [1], [2, 3]),
                it.geodesic_distances_from(V, F, [curve], 0)[0], *(line.positions for line in lines)]}


def paths(V, F, unit):
    path, tracer = it.geodesic_path(V, F, 0, 9, is_shortest=True), it.GeodesicTracer(V, F)
    line = tracer.trace_geodesic_from_face(3, [0.2, 0.3, 0.5], [unit, 2 * unit, unit])
    return {0: [path.coordinates], 1: [path.positions, path.length, path.distance, line, it.cut_along_path(V, F, path)[0]]}


def conformal(V, F, unit, **options):
    m = it.Triangulation(V, F).conformal_map(**options)
    return {0: [m.triangles, m.place_coordinates, m.is_cut, m.weights, m.stretch, m.u, m.cones, m.cone_angles, m.residual, m.turned,
                m.turned_input, m.overlaps, m.is_certified], 1: [m.uv, m.input_uv, m.seam]}


def conformal_to_a_disk(V, F, unit):
    return conformal(V, F, unit, boundary="disk")


@pytest.mark.parametrize("find", [triangulation, any_triangles, refined, refined_by_sizes, refined_to_deviation, simplified, heat,
                                  distances, paths, conformal, conformal_to_a_disk])
@pytest.mark.parametrize("shape", ["closed", "bordered"])
def test_results_have_the_unit_of_the_input(sphere, find, shape):
    V, F = bumpy(*(sphere if shape == "closed" else cap(*sphere)))
    wanted = find(V, F, 1.0)
    for exponent in 1, -133, 332:
        unit = 2.0 ** exponent
        found = find(V * unit, F, unit)
        for dimension, numbers in wanted.items():
            for i, (x, y) in enumerate(zip(numbers, found[dimension])):
                numpy.testing.assert_array_equal(numpy.asarray(x) * unit ** dimension, y, f"{i} of dimension {dimension}, 2^{exponent}")
