// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The functions that can colour the surface: each has numbers for both triangulations, at the vertices of `surface` or on faces.

"use strict";

function find_fields() {
  const fields = page.fields.map((field, i) => {
    const numbers = field.of.map((_, t) => read_floats("field-" + i + "-" + t));
    return { name: field.name, unit: field.unit, of_faces: field.of[0] === "faces", numbers };
  });
  const angles = triangulations.map(t => Float32Array.from({ length: t.number_of_faces }, (_, f) => t.smallest_angle(f)));
  fields.push({ name: "smallest angle of the face", unit: "degrees", of_faces: true, numbers: angles });
  fields.forEach(find_range);
  return fields.filter(field => field.lowest <= field.highest);
}

function find_range(field) {
  Object.assign(field, { lowest: Infinity, highest: -Infinity, least_positive: Infinity, missing: 0, infinite: 0 });
  for (const numbers of field.numbers)
    for (let i = 0; i < numbers.length; ++i) {
      const x = numbers[i];
      if (!isFinite(x)) {
        ++field[isNaN(x) ? "missing" : "infinite"];
        continue;
      }
      field.lowest = Math.min(field.lowest, x);
      field.highest = Math.max(field.highest, x);
      if (x > 0 && x < field.least_positive)
        field.least_positive = x;
    }
  // Up to the rounding of the numbers in the page.
  field.is_constant = field.highest - field.lowest <= 1e-6 * Math.max(Math.abs(field.lowest), Math.abs(field.highest));
}

// At a corner of the triangles of a part of the picture, for a triangulation. Faces without numbers of their own have those of the input.
function number_at(field, { corners, faces }, t, corner) {
  const k = Math.min(t, field.numbers.length - 1);
  return field.numbers[k][field.of_faces ? faces[Math.min(k, faces.length - 1)][Math.floor(corner / 3)] : corners[corner]];
}

// At a place within a triangle of the surface.
// \param weights of its three corners
function number_within(field, t, triangle, weights) {
  return [0, 1, 2].reduce((sum, i) => sum + (weights[i] === 0 ? 0 : weights[i] * number_at(field, surface, t, 3 * triangle + i)), 0);
}

function describe_number(field, t, { triangle, weights }) {
  const x = number_within(field, t, triangle, weights);
  return field.name + ": " + (isNaN(x) ? "no number" : isFinite(x) ? text_of(x) + (field.unit ? " " + field.unit : "") : "infinite");
}
