# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces for pictures that the command does not have."""

from math import acos, cos, sin

import numpy as np

from idt_files import write_off


def thin_tube(path, vertices=9, pitch=2.2):
    """The sample helical-tube, so short that it can be seen: points that wind around an axis."""
    turn = acos(-2 / 3)
    points = np.array([[cos(turn * i), sin(turn * i), pitch * i] for i in range(vertices)])
    faces = [(0, 2, 1), (vertices - 3, vertices - 2, vertices - 1)]
    for i in range(vertices - 3):
        faces += [(i, i + 1, i + 3), (i, i + 3, i + 2)]
    return write_off(path, points, np.array(faces))


def half(surface, path, axis, fraction):
    """The triangles beyond a plane, at a fraction of the extent along an axis."""
    x = surface.points[:, axis]
    beyond = x > x.min() + fraction * np.ptp(x)
    return write_off(path, surface.points, surface.faces[beyond[surface.faces].all(axis=1)])
