# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# The public names.

"""Intrinsic Delaunay triangulations of triangulated surfaces, with exact decisions.

NumPy arrays in, NumPy arrays and SciPy matrices out. By what is wanted:

- operators: `laplacian` of any triangles, `solve_poisson`, `point_cloud_laplacian`, `face_areas`, `vertex_areas`;
- better triangles of the same surface: `Triangulation` with `flip_to_delaunay`, `refine`, `straight_mesh`, `simplify`,
  `conformal_map`, `save`, and `common_subdivision` to carry values and points there and back;
- distances: `geodesic_distances` from vertices, `geodesic_distances_from` points, edges and curves, around barriers;
  `geodesic_distance_matrix`, `signed_distances`, `farthest_vertices`, `SimplifiedDistances`, and by heat,
  `MeshHeatMethodDistanceSolver`;
- lines: `geodesic_path`, `shortest_path`, `EdgeFlipGeodesicSolver` for several stops and loops, `GeodesicTracer`, `isolines`,
  `offset_curves`, `borders_of_cells`, `cut_along_path`;
- vectors: `MeshVectorHeatSolver`;
- meshes: `read_mesh`, `write_mesh`, `repair`, `orient`, `border_edges`, `border_vertices`, `component_labels`, `view`.

Arrays may have any integer or float type, order and strides, but doubles must hold their numbers exactly. They are
never changed. A wrong type or shape raises `ValueError`. Long calls let other threads run, and Ctrl-C ends them.

The package is under the LGPL, except for `point_cloud_laplacian` and `repair`, which are under the GPL.
"""

from ._core import version as __version__
from ._conformal import ConformalMap
from ._errors import (CancelledError, Error, FileError, IntegerOverflowError, InvalidArgumentError, InvalidFileError, InvalidPointError,
                      InvalidSurfaceError, NumericalError, UndecidedError)
from ._files import Repair, RepairedMesh, TexturedMesh, orient, read_mesh, repair
from ._geodesics import (CutSurface, EdgeFlipGeodesicSolver, GeodesicPath, GeodesicTracer, ShortestPath, cut_along_path, geodesic_path,
                         shortest_path)
from ._heat import (MeshHeatMethodDistanceSolver, compute_distance, compute_distance_multisource, farthest_vertices,
                    geodesic_distance_matrix, geodesic_distances, geodesic_distances_from)
from ._laplacian import laplacian, mesh_laplacian, point_cloud_laplacian, solve_poisson
from ._lines import SurfaceLine, borders_of_cells, isolines, offset_curves, sides_of_curve, signed_distances
from ._mesh import border_edges, border_vertices, component_labels, cotan_laplacian, face_areas, vertex_areas
from ._reports import FlipReport, RefinementReport, StraightMesh, VerificationReport
from ._simplification import DistanceIntervals, SimplifiedDistances, SimplifiedSurface
from ._subdivision import CommonSubdivision
from ._triangulation import Triangulation
from ._vectors import MeshVectorHeatSolver
from ._view import Page, view
from ._writing import write_mesh

__all__ = [
    "CancelledError",
    "CommonSubdivision",
    "ConformalMap",
    "CutSurface",
    "DistanceIntervals",
    "EdgeFlipGeodesicSolver",
    "Error",
    "FileError",
    "FlipReport",
    "GeodesicPath",
    "GeodesicTracer",
    "IntegerOverflowError",
    "InvalidArgumentError",
    "InvalidFileError",
    "InvalidPointError",
    "InvalidSurfaceError",
    "MeshHeatMethodDistanceSolver",
    "MeshVectorHeatSolver",
    "NumericalError",
    "Page",
    "RefinementReport",
    "Repair",
    "RepairedMesh",
    "ShortestPath",
    "SimplifiedDistances",
    "SimplifiedSurface",
    "StraightMesh",
    "SurfaceLine",
    "TexturedMesh",
    "Triangulation",
    "UndecidedError",
    "VerificationReport",
    "border_edges",
    "border_vertices",
    "borders_of_cells",
    "component_labels",
    "compute_distance",
    "compute_distance_multisource",
    "cotan_laplacian",
    "cut_along_path",
    "face_areas",
    "farthest_vertices",
    "geodesic_distance_matrix",
    "geodesic_distances",
    "geodesic_distances_from",
    "geodesic_path",
    "isolines",
    "laplacian",
    "mesh_laplacian",
    "offset_curves",
    "orient",
    "point_cloud_laplacian",
    "read_mesh",
    "repair",
    "shortest_path",
    "sides_of_curve",
    "signed_distances",
    "solve_poisson",
    "vertex_areas",
    "view",
    "write_mesh",
]
