// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface as a whole: its box, how much it is stretched, and which way is up.

"use strict";

// The lowest and the highest coordinate of each axis.
function box_of(places) {
  const box = [0, 1, 2].map(() => [Infinity, -Infinity]);
  for (let i = 0; i < places.length; ++i) {
    const side = box[i % 3];
    side[0] = Math.min(side[0], places[i]);
    side[1] = Math.max(side[1], places[i]);
  }
  return box;
}

// Factors of the axes, so that a surface that would be a line on the screen is seen: its second longest side is at least a thousandth.
function find_stretch(places) {
  const sides = box_of(places).map(([low, high]) => high - low), [, middle, longest] = [...sides].sort((a, b) => a - b);
  return sides.map(side => (middle > 0 && middle < longest / 1000 && side > 0 && side < longest ? longest / 4 / middle : 1));
}

// Whether it would stand with this axis up: its lowest parts are on all sides of the middle.
function stands(places, axis) {
  const [u, v] = [(axis + 1) % 3, (axis + 2) % 3], box = box_of(places), n = places.length / 3, middle = [0, 0, 0];
  for (let i = 0; i < places.length; ++i)
    middle[i % 3] += places[i] / n;
  const directions = Array.from({ length: 16 }, (_, k) => [Math.cos(k * Math.PI / 8), Math.sin(k * Math.PI / 8)]);
  const floor = box[axis][0] + 0.03 * (box[axis][1] - box[axis][0]), low = new Float64Array(16).fill(-Infinity), all = low.slice();
  for (let i = 0; i < n; ++i) {
    const x = places[3 * i + u] - middle[u], y = places[3 * i + v] - middle[v];
    for (let k = 0; k < 16; ++k) {
      const reach = x * directions[k][0] + y * directions[k][1];
      all[k] = Math.max(all[k], reach);
      if (places[3 * i + axis] <= floor)
        low[k] = Math.max(low[k], reach);
    }
  }
  return low.every((reach, k) => reach > 0.15 * all[k]);
}

// The y axis, unless only z lets the surface stand. One in the plane of x and y is not laid down.
function find_up(places) {
  const [low, high] = box_of(places)[2];
  return high - low > 1e-4 && stands(places, 2) && !stands(places, 1) ? "z" : "y";
}
