#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the schemes of the manual as SVG: a flip, a strip laid out, normal coordinates, an off-center, the stages of a decision.

  doc/figures/draw_schemes.py [FOLDER]                        the schemes (default: doc/images)
  doc/figures/draw_schemes.py --part PART.off FOLDER          bracket.svg, from what idt refine --flatten wrote

Needs nothing but Python.
"""

import math
import sys
from pathlib import Path

BLACK, GREY, RED, BLUE, PALE = "black", "#999999", "#c0392b", "#0b6e99", "#e8f1f5"


class Drawing:
    """Shapes in units of its own, y upwards."""

    def __init__(self, width, height, scale, origin=(0, 0)):
        self.size, self.scale, self.origin, self.shapes = (width, height), scale, origin, []

    def at(self, p):
        x, y = self.origin[0] + p[0] * self.scale, self.size[1] - self.origin[1] - p[1] * self.scale
        return round(x, 1), round(y, 1)

    def line(self, p, q, color=BLACK, width=2, dashes=None):
        (a, b), (c, d) = self.at(p), self.at(q)
        dash = f' stroke-dasharray="{dashes}"' if dashes else ""
        self.shapes.append(f'<line x1="{a}" y1="{b}" x2="{c}" y2="{d}" stroke="{color}" stroke-width="{width}"{dash}/>')

    def polygon(self, points, fill, stroke="none", width=1):
        text = " ".join(f"{x},{y}" for x, y in map(self.at, points))
        self.shapes.append(f'<polygon points="{text}" fill="{fill}" stroke="{stroke}" stroke-width="{width}" stroke-linejoin="round"/>')

    def circle(self, p, radius, color=GREY, dashes="6 5"):
        x, y = self.at(p)
        self.shapes.append(f'<circle cx="{x}" cy="{y}" r="{round(radius * self.scale, 1)}" fill="none" stroke="{color}" '
                           f'stroke-width="1.5" stroke-dasharray="{dashes}"/>')

    def dot(self, p, color=BLACK, radius=5):
        x, y = self.at(p)
        self.shapes.append(f'<circle cx="{x}" cy="{y}" r="{radius}" fill="{color}"/>')

    def text(self, p, words, anchor="middle", shift=(0, 0), color=BLACK, size=16):
        x, y = self.at(p)
        self.shapes.append(f'<text x="{x + shift[0]}" y="{y + shift[1]}" text-anchor="{anchor}" fill="{color}" '
                           f'font-size="{size}">{words}</text>')

    def rectangle(self, x, y, width, height, fill, stroke=BLACK):
        self.shapes.append(f'<rect x="{x}" y="{y}" width="{width}" height="{height}" fill="{fill}" stroke="{stroke}" stroke-width="1.5"/>')

    def save(self, path):
        w, h = self.size
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {w} {h}" font-family="sans-serif" font-size="16">\n'
                f'<!-- SPDX-License-Identifier: GPL-3.0-or-later -->\n<rect width="{w}" height="{h}" fill="white"/>\n')
        path.write_text(head + "\n".join(self.shapes) + "\n</svg>\n", encoding="utf-8")


def between(p, q, t):
    return tuple((1 - t) * a + t * b for a, b in zip(p, q))


def circumcenter(p, q, r):
    ax, ay, bx, by = q[0] - p[0], q[1] - p[1], r[0] - p[0], r[1] - p[1]
    d = 2 * (ax * by - ay * bx)
    a, b = ax * ax + ay * ay, bx * bx + by * by
    return p[0] + (by * a - ay * b) / d, p[1] + (ax * b - bx * a) / d


def flip(path):
    drawing = Drawing(760, 310, 62, (75, 222))
    for shift, is_flipped in ((0, False), (5.9, True)):
        i, j, k, l = ((x + shift, y) for x, y in ((0, 0), (4, 0), (1.7, 1.15), (2.3, -1.05)))
        drawing.polygon([i, l, j, k], PALE)
        if not is_flipped:
            center = circumcenter(i, j, k)
            drawing.circle(center, math.dist(center, i))
        for p, q in ((i, l), (l, j), (j, k), (k, i)):
            drawing.line(p, q)
        drawing.line(*((k, l) if is_flipped else (i, j)), RED if is_flipped else BLACK, 4)
        for p, name, move in ((i, "i", (-12, 5)), (j, "j", (12, 5)), (k, "k", (0, -12)), (l, "l", (0, 24))):
            drawing.dot(p)
            drawing.text(p, name, shift=move)
    drawing.save(path)


def strip(path):
    drawing = Drawing(760, 300, 130, (40, 25))
    v, w = (0, 0.95), (5.2, 1.2)
    top, bottom = [(0.9, 1.9), (2.3, 2.0), (4.0, 1.85)], [(1.1, 0.15), (2.9, 0.05), (4.4, 0.25)]
    drawing.polygon([v, *bottom, w, *reversed(top)], PALE)
    chain = [top[0], bottom[0], top[1], bottom[1], top[2], bottom[2]]
    for p, q in zip(chain, chain[1:]):
        drawing.line(p, q)
    for side in (top, bottom):
        for p, q in zip([v, *side], [*side, w]):
            drawing.line(p, q)
    drawing.line(v, w, RED, 4)
    for p, q in zip(chain, chain[1:]):
        t = ((w[0] - v[0]) * (p[1] - v[1]) - (w[1] - v[1]) * (p[0] - v[0]))
        u = ((w[0] - v[0]) * (q[1] - v[1]) - (w[1] - v[1]) * (q[0] - v[0]))
        drawing.dot(between(p, q, t / (t - u)), RED)
    for p in [v, w, *top, *bottom]:
        drawing.dot(p)
    drawing.text(v, "v", shift=(-16, 5))
    drawing.text(w, "w", shift=(16, 5))
    drawing.save(path)


def normal_coordinates(path):
    drawing = Drawing(760, 360, 290, (170, 45))
    i, j, k = (0.35, 0.95), (0, 0), (1.45, 0)
    drawing.polygon([i, j, k], PALE, BLACK, 2)
    cuts = [((j, i, t), (j, k, s)) for t, s in ((0.3, 0.17), (0.55, 0.32))] + [((k, i, 0.33), (k, j, 0.25))]
    for one, other in cuts:
        p, q = between(*one), between(*other)
        drawing.line(p, q, BLUE, 3)
        drawing.dot(p, BLUE, 4)
        drawing.dot(q, BLUE, 4)
    end = between(j, k, 0.52)
    drawing.line(i, end, RED, 3)
    drawing.dot(end, RED, 4)
    for p, name, move in ((i, "i", (0, -12)), (j, "j", (-14, 12)), (k, "k", (14, 12))):
        drawing.dot(p)
        drawing.text(p, name, shift=move)
    drawing.text(between(j, k, 0.5), "n_jk = 4", shift=(0, 28))
    drawing.text(between(i, j, 0.5), "n_ij = 2", "end", shift=(-16, 0))
    drawing.text(between(i, k, 0.5), "n_ki = 1", "start", shift=(18, -6))
    drawing.text(between(j, k, 0.14), "c_j = 2", shift=(0, 28), color=BLUE)
    drawing.text(between(k, j, 0.14), "c_k = 1", shift=(0, 28), color=BLUE)
    drawing.text(between(i, end, 0.55), "e_i = 1", "start", shift=(12, 0), color=RED)
    drawing.save(path)


def off_center(path):
    drawing = Drawing(760, 440, 46, (320, 38))
    i, j, k = (-0.5, 0), (0.5, 0), (0.3, 8)
    center = circumcenter(i, j, k)
    height = 0.99 * 0.5 / math.tan(math.radians(12.5))
    near = (0, height)
    middle = (0, (height - 0.25 / height) / 2)
    radius = height - middle[1]
    drawing.polygon([i, j, k], PALE, BLACK, 2)
    drawing.circle(center, math.dist(center, i))
    drawing.circle(middle, radius, RED)
    for n in range(1, 12):
        angle = math.pi * n / 12
        drawing.dot((radius * math.cos(angle), middle[1] + radius * math.sin(angle)), RED, 3)
    for end in (i, j):
        drawing.line(end, near, RED, 2)
    drawing.line((0, 0), center, GREY, 1)
    drawing.dot(center)
    drawing.dot(near, RED)
    for p, name, move in ((i, "i", (-12, 14)), (j, "j", (12, 14)), (k, "k", (4, -10))):
        drawing.dot(p)
        drawing.text(p, name, shift=move)
    drawing.text(center, "circumcenter", "start", shift=(208, 5))
    drawing.text(near, "off-center", "start", shift=(208, 5), color=RED)
    drawing.text(middle, "petal", "start", shift=(208, 5), color=RED)
    drawing.line((4.4, middle[1]), (radius, middle[1]), RED, 1)
    drawing.line((4.4, center[1]), (0.12, center[1]), GREY, 1)
    drawing.line((4.4, near[1]), (0.12, near[1]), RED, 1)
    drawing.save(path)


STAGES = [("filter", "doubles with error bounds", "2,014,232"),
          ("coplanar", "the in-circle test in a plane", "19,065"),
          ("unfolding", "strips in double-doubles", "9,497"),
          ("algebraic", "strips in exact numbers", "14"),
          ("congruence", "strips that mirror each other", "0"),
          ("multiprecision", "strips in MPFR", "0"),
          ("modular", "strips in finite fields", "43")]


def ladder(path):
    drawing = Drawing(760, 20 + 56 * len(STAGES), 1)
    for number, (name, means, count) in enumerate(STAGES):
        x, y = 20 + 44 * number, 14 + 56 * number
        drawing.rectangle(x, y, 330, 40, PALE)
        drawing.shapes.append(f'<text x="{x + 12}" y="{y + 26}"><tspan font-weight="bold">{name}</tspan>: {means}</text>')
        drawing.shapes.append(f'<path d="M{x + 332},{y + 20} h26 m-7,-5 l7,5 l-7,5" fill="none" stroke="{BLUE}" stroke-width="2"/>')
        drawing.shapes.append(f'<text x="{x + 366}" y="{y + 26}" fill="{BLUE}">{count}</text>')
        if number + 1 < len(STAGES):
            drawing.shapes.append(f'<path d="M{x + 24},{y + 42} v34 h16 m-7,-5 l7,5 l-7,5" fill="none" stroke="{RED}" stroke-width="2"/>')
    drawing.save(path)


def part(source, path):
    """The faces of an OFF file that are turned to the viewer, from the back to the front."""
    words = source.read_text(encoding="utf-8").split()
    number = int(words[1])
    coordinates = list(map(float, words[4:4 + 3 * number]))
    points = [coordinates[3 * v:3 * v + 3] for v in range(number)]
    faces, at = [], 4 + 3 * number
    for _ in range(int(words[2])):
        count = int(words[at])
        faces.append(list(map(int, words[at + 1:at + 1 + count])))
        at += 1 + count
    turn, tilt = math.radians(35), math.radians(25)

    def seen(p):
        x, y = math.cos(turn) * p[0] + math.sin(turn) * p[1], math.cos(turn) * p[1] - math.sin(turn) * p[0]
        return x, math.cos(tilt) * p[2] + math.sin(tilt) * y, math.cos(tilt) * y - math.sin(tilt) * p[2]

    seen_points = list(map(seen, points))
    drawing = Drawing(760, 420, 88, (190, 130))
    drawing.shapes.append(f'<g fill="{PALE}" stroke="{BLUE}" stroke-width="0.8" stroke-linejoin="round">')
    visible = []
    for face in faces:
        corners = [seen_points[v] for v in face]
        area = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(corners, corners[1:] + corners[:1]))
        if area > 0:
            visible.append((max(c[2] for c in corners), corners))
    for _, corners in sorted(visible, key=lambda entry: -entry[0]):
        places = "L".join(f"{x:g},{y:g}" for x, y in (drawing.at(c) for c in corners))
        drawing.shapes.append(f'<path d="M{places}z"/>')
    drawing.shapes.append("</g>")
    drawing.save(path)


def main():
    words = sys.argv[1:]
    if words[:1] == ["--part"]:
        part(Path(words[1]), Path(words[2]) / "bracket.svg")
        return
    folder = Path(words[0]) if words else Path(__file__).resolve().parent.parent / "images"
    for name, draw in (("flip", flip), ("strip", strip), ("normal-coordinates", normal_coordinates),
                       ("off-center", off_center), ("ladder", ladder)):
        draw(folder / f"{name}.svg")


main()
