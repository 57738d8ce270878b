// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The element that is pointed at, and its numbers in words.

"use strict";

function text_of(x, unit = "") {
  return isFinite(x) ? String(Number(x.toPrecision(6))).replace("-", "−") + unit : "not defined";
}

function distance_to_segment(x, y, [ax, ay], [bx, by]) {
  const dx = bx - ax, dy = by - ay, t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}

// The vertex, the edge or the face at a place of the canvas: { vertex } or { edges } or { faces }, the latter with a number in each
// triangulation, or -1; null beside the surface. `triangle`, `weights` and `layer` are the place on the surface.
function element_at(picture, x, y) {
  const { view, triangle } = picture.triangle_at(x, y);
  if (triangle < 0)
    return null;
  const at = { triangle, weights: picture.weights_at(x, y, view, triangle), layer: view.layer };
  const sides = [3 * triangle, 3 * triangle + 1, 3 * triangle + 2], corners = sides.map(s => surface.corners[s]);
  const pixels = corners.map((_, i) => picture.pixel_of(picture.place_of_corner(sides[i], view), view));
  const near = corners.map((v, i) => [Math.hypot(x - pixels[i][0], y - pixels[i][1]), v])
    .filter(([d, v]) => d < 7 && v < result.number_of_vertices).sort((a, b) => a[0] - b[0]);
  if (near.length > 0)
    return { vertex: near[0][1], ...at, weights: corners.map(v => (v === near[0][1] ? 1 : 0)) };
  const is_seen = s => label_of_side(s) !== 0 && picture.shown[label_of_side(s) - 1] && !(picture.is_split && label_of_side(s) === 2 - view.layer);
  const near_sides = sides.map((s, i) => [distance_to_segment(x, y, pixels[i], pixels[(i + 1) % 3]), s])
    .filter(([d, s]) => d < 5 && is_seen(s)).sort((a, b) => a[0] - b[0]);
  if (near_sides.length > 0)
    return { edges: triangulations.map((_, t) => edge_of_side(t, near_sides[0][1])), ...at };
  return { faces: surface.faces.map(faces => faces[triangle]), ...at };
}

function describe_vertex(v) {
  const lines = ["vertex " + v + (v < page.vertices[0] ? "" : ", inserted") + ": (" + original_place(v).map(x => text_of(x)).join(", ") + ")"];
  triangulations.forEach(t => {
    if (v >= t.number_of_vertices)
      return;
    const sides = t.sides_from(v), sum = sides.reduce((sum, s) => sum + t.angle_at(s), 0);
    lines.push("in the " + t.name + ": " + sides.length + " faces, angles " + text_of(sum, "°") + " in all, the smallest " +
      text_of(Math.min(...sides.map(s => t.angle_at(s))), "°"));
  });
  return lines.join("\n");
}

function describe_edge(t, e) {
  const sides = t.sides_of(e);
  return "edge " + e + " of the " + t.name + ": " + t.ends(e).join(" – ") + ", length " + text_of(t.lengths[e]) + ", cotangent weight " +
    text_of(t.weights[e]) + "\n  opposite angles " + sides.map(s => text_of(t.opposite_angle(s), "°")).join(", ");
}

function describe_face(t, f) {
  const sides = [3 * f, 3 * f + 1, 3 * f + 2];
  return "face " + f + " of the " + t.name + ": corners " + t.corners_of(f).join(", ") + ", area " + text_of(t.area(f)) + "\n  angles " +
    sides.map(s => text_of(t.angle_at(s), "°")).join(", ") + "\n  edges " + sides.map(s => t.sides[s] + " (" + text_of(t.lengths[t.sides[s]]) + ")").join(", ");
}

// \param field that colours the surface, whose number comes first
function describe(element, field) {
  if (!element)
    return "";
  const first = field.numbers && element.weights ? describe_number(field, element.layer, element) + "\n" : "";
  if (element.vertex !== undefined)
    return first + describe_vertex(element.vertex);
  const [numbers, describe_one] = element.edges ? [element.edges, describe_edge] : [element.faces, describe_face];
  return first + numbers.map((number, t) => (number < 0 ? "" : describe_one(triangulations[t], number))).filter(text => text).join("\n");
}

function mark_element(picture, element) {
  const segments = [];
  if (element && element.edges)
    element.edges.forEach((e, t) => e >= 0 && segments.push(...segments_of(t, e)));
  if (element && element.faces) { // the outline of the last one, which is of the result
    const t = element.faces.length - 1 - (element.faces[element.faces.length - 1] < 0 ? 1 : 0);
    for (let s = 3 * element.faces[t]; s < 3 * element.faces[t] + 3; ++s)
      segments.push(...segments_of(t, triangulations[t].sides[s]));
  }
  // A point stands for what is smaller than a pixel.
  picture.mark(segments, element ? [element.vertex, element.corner].filter(v => v !== undefined) : []);
}
