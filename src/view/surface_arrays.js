// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface as arrays for the graphics processor.

"use strict";

// How large an edge looks: its length, or twice the height of the faces beside it if that is less. As a byte: 12 steps for a factor of 2,
// 255 for twice the radius of the surface.
function sizes_of_edges(t) {
  const is_stretched = page.stretch.some(factor => factor !== 1), sizes = new Float32Array(t.number_of_edges), [u, v] = [0, 0].map(() => new THREE.Vector3());
  for (let s = 0; s < t.sides.length; ++s) {
    const e = t.sides[s], [p, q, r] = [s, next(s), next(next(s))].map(i => t.corners[i]);
    u.subVectors(place(q), place(p));
    v.subVectors(place(r), place(p));
    const length = is_stretched ? u.length() : t.lengths[e] / page.scale;
    const height = is_stretched ? u.cross(v).length() / length : 2 * t.area(Math.floor(s / 3)) / t.lengths[e] / page.scale;
    sizes[e] = Math.max(sizes[e], Math.min(length, 2 * height || 0));
  }
  return Uint8Array.from(sizes, x => Math.max(0, Math.min(255, Math.round(255 + 12 * Math.log2(x / (2 * page.radius))))));
}

// Per corner of each triangle: nothing is shared, so that a triangle can have colours of its own.
function make_surface_arrays({ places, corners, sides, faces, plane }, face_normals, colours, sizes) {
  const n = corners.length, last = colours.length - 1;
  const size_of_side = (t, side) => {
    const k = side >> 2 ? last : 0, i = side >> 2 * k & 3;
    return i === 0 ? 0 : sizes[k][triangulations[k].sides[3 * faces[k][t] + i - 1]];
  };
  const position = new Float32Array(3 * n), size = new Uint8Array(3 * n), direction = new Int8Array(3 * n), info = new Uint8Array(4 * n);
  for (let c = 0; c < n; ++c)
    for (let i = 0; i < 3; ++i)
      position[3 * c + i] = places[3 * corners[c] + i];
  for (let t = 0; t < n / 3; ++t) {
    const input = faces[0][t], input_colour = colours[0][input], result_colour = colours[last][faces[last][t]];
    // Side i is opposite to the corner before it.
    const side_sizes = [1, 2, 0].map(i => size_of_side(t, sides[3 * t + i]));
    const labels = label(sides[3 * t + 1]) | label(sides[3 * t + 2]) << 2 | label(sides[3 * t]) << 4;
    for (let i = 0; i < 3; ++i) {
      const c = 3 * t + i;
      size.set(side_sizes, 3 * c);
      for (let k = 0; k < 3; ++k)
        direction[3 * c + k] = face_normals[3 * input + k];
      info[4 * c] = input_colour;
      info[4 * c + 1] = result_colour;
      info[4 * c + 2] = labels;
      info[4 * c + 3] = i;
    }
  }
  return { position: [position, 3], size: [size, 3], direction: [direction, 3, true], info: [info, 4], plane: [plane || position, 3] };
}

// Of unit length 127, of input faces: those of thin triangles that are parts of them would be far off.
function make_face_normals() {
  const { corners, number_of_faces } = triangulations[0], result = new Int8Array(3 * number_of_faces), p = surface.places;
  for (let f = 0; f < number_of_faces; ++f) {
    const [a, b, c] = [corners[3 * f] * 3, corners[3 * f + 1] * 3, corners[3 * f + 2] * 3];
    const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2], vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx, length = Math.sqrt(x * x + y * y + z * z) || 1;
    result[3 * f] = 127 * x / length;
    result[3 * f + 1] = 127 * y / length;
    result[3 * f + 2] = 127 * z / length;
  }
  return result;
}

// The surface in few triangles, for pictures with fewer pixels while it moves: all vertices in one cell of a grid become one.
function make_rough_surface() {
  const n = 48, { places, corners } = surface, first = new Int32Array(n ** 3).fill(-1), moved = new Uint32Array(places.length / 3);
  const step = x => Math.min(n - 1, Math.floor((x + 1) / 2 * n));
  for (let v = 0; v < moved.length; ++v) {
    const cell = (step(places[3 * v]) * n + step(places[3 * v + 1])) * n + step(places[3 * v + 2]);
    if (first[cell] < 0)
      first[cell] = v;
    moved[v] = first[cell];
  }
  const triangles = [];
  for (let t = 0; t < corners.length / 3; ++t) {
    const a = moved[corners[3 * t]], b = moved[corners[3 * t + 1]], c = moved[corners[3 * t + 2]];
    if (a !== b && b !== c && c !== a)
      triangles.push(t);
  }
  return {
    plane: surface.plane && Float32Array.from(triangles.flatMap(t => [...surface.plane.subarray(9 * t, 9 * t + 9)])),
    places, corners: Uint32Array.from(triangles.flatMap(t => [3 * t, 3 * t + 1, 3 * t + 2]), c => moved[corners[c]]),
    sides: new Uint8Array(3 * triangles.length), faces: surface.faces.map(faces => Uint32Array.from(triangles, t => faces[t])),
  };
}
