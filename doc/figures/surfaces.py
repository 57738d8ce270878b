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


def folded_sheet(path, strips=6, along=60, slant=20, slope=0.6):
    """The square sheet of paper of doc/examples/tutorial.cpp, folded like an accordion into long, slanted triangles."""
    points = np.array([[i / strips * cos(slope), j / along, i % 2 / strips * sin(slope)]
                       for i in range(strips + 1) for j in range(along + 1)])
    faces = []
    for a in range(0, strips * (along + 1), along + 1):
        b = a + along + 1
        left = right = 0
        while left < along or right < along:
            if right < min(along, left + slant):
                faces.append((a + left, b + right, b + right + 1))
                right += 1
            else:
                faces.append((a + left, b + right, a + left + 1))
                left += 1
    return write_off(path, points, np.array(faces))


def wave_on_sheet(points, slope=0.6):
    """cos πx cos πy on the sheet, laid flat."""
    return np.cos(np.pi * points[:, 0] / cos(slope)) * np.cos(np.pi * points[:, 1])
