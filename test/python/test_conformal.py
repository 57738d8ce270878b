# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Conformal maps, checked in rational numbers.

from fractions import Fraction

import numpy
import pytest

import intrinsic_triangulations as it
from conftest import icosphere


def orientation(corners):
    (ax, ay), (bx, by), (cx, cy) = [[Fraction(x) for x in p] for p in corners.tolist()]
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)


def defects(m):
    """what is wrong with the map, in rational numbers"""
    found = [f"triangle {i}" for i, t in enumerate(m.uv) if orientation(t) <= 0]
    sides = {}
    for t, (triangle, uv) in enumerate(zip(m.triangles.tolist(), m.uv.tolist())):
        for k in range(3):
            sides[triangle[k], triangle[(k + 1) % 3]] = (uv[k], uv[(k + 1) % 3], m.is_cut[t, k])
    for (a, b), (p, q, is_cut) in sides.items():
        r, s, is_other_cut = sides.get((b, a), (q, p, is_cut))
        if not is_cut and (p != s or q != r):
            found.append(f"side {a} {b}")
        if is_cut and abs(numpy.hypot(p[0] - q[0], p[1] - q[1]) - numpy.hypot(r[0] - s[0], r[1] - s[1])) > 2 * m.seam + 1e-13:
            found.append(f"seam {a} {b}")
    return found


@pytest.mark.parametrize("boundary", ["free", "disk", "angles"])
def test_claims_about_a_disk(boundary):
    V, F = icosphere(2)
    F = F[(V[F, 2] > -0.2).all(1)]
    t = it.Triangulation(V, F)
    angles = None
    if boundary == "angles":
        sides = {(f[i], f[(i + 1) % 3]) for f in F.tolist() for i in range(3)}
        border = [a for a, b in sides if (b, a) not in sides]
        angles = {v: numpy.pi - 2 * numpy.pi / len(border) for v in border}
    m = t.conformal_map(boundary=None if angles else boundary, boundary_angles=angles)
    assert m.is_certified and len(m.turned) == 0 and not m.overlaps and not m.is_cut.any()
    assert m.residual < 1e-10 and defects(m) == []
    assert m.weights.shape == m.place_faces.shape and (m.weights > 0).all()
    moved = m.uv.copy()
    moved[5, 0, 0] = numpy.nextafter(moved[5, 0, 0], 9)
    assert defects(m._replace(uv=moved)) != []
    # The image of a point is that of its coordinates.
    V = numpy.asarray(V)
    points = numpy.einsum("mi,mij->mj", m.place_coordinates, V[F[m.place_faces]])
    used = numpy.unique(F)
    assert numpy.allclose(points[used], V[used])
    # Areas of triangles on the surface and in the plane.
    a, b, c = (points[m.triangles[:, k]] for k in range(3))
    in_space = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1)
    in_plane = numpy.linalg.det(m.uv[:, 1:] - m.uv[:, :1])
    large = in_space > 1e-3 * in_space.max()
    assert numpy.allclose(m.stretch.prod(1)[large], (in_plane / in_space)[large], rtol=1e-6)
    assert (m.stretch[:, 0] >= m.stretch[:, 1]).all()


def test_claims_about_a_closed_surface():
    V, F = icosphere(2)
    m = it.Triangulation(V * [1, 1.3, 2], F).conformal_map(cone_angles={v: numpy.pi for v in (0, 20, 50, 90)})
    assert m.cones.tolist() == [0, 20, 50, 90] and numpy.allclose(m.cone_angles, numpy.pi)
    assert m.is_certified and m.residual < 1e-10 and defects(m) == []
    assert it.Triangulation(V, F).conformal_map(cones=5).cones.shape == (5,)


def test_wrong_arguments():
    V, F = icosphere(1)
    t = it.Triangulation(V, F)
    with pytest.raises(it.InvalidArgumentError, match="Gauss and Bonnet"):
        t.conformal_map(cone_angles={0: 1})
    with pytest.raises(ValueError, match="exclude"):
        t.conformal_map(cones=3, cone_angles={0: 1})
    with pytest.raises(ValueError, match="boundary"):
        t.conformal_map(boundary="round")
    with pytest.raises(it.InvalidArgumentError, match="not on the border"):
        t.conformal_map(boundary_angles={0: 1})
    with pytest.raises(ValueError):
        t.conformal_map(cone_angles={10**6: 1})
    with pytest.raises(it.InvalidSurfaceError, match="no face"):
        it.Triangulation(V, numpy.zeros((0, 3), int)).conformal_map()
