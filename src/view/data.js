// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contents of the page: its arrays, and the two triangulations with their numbers.

"use strict";

const page = JSON.parse(document.getElementById("page").textContent);

function from_base64(text) {
  if (Uint8Array.fromBase64)
    return Uint8Array.fromBase64(text);
  const binary = atob(text), bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i)
    bytes[i] = binary.charCodeAt(i);
  return bytes;
}

// All arrays are one text in the page. It is removed from there, so that it is in memory only once.
let packed = null;
async function unpack() {
  const element = document.getElementById("arrays");
  packed = from_base64(element.textContent);
  element.remove();
  if (page.is_compressed)
    packed = new Uint8Array(await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer());
}

function read_bytes(name) {
  const [begin, n] = page.arrays[name];
  return packed.slice(begin, begin + n);
}

// First the lowest bytes of all words, then the next ones.
function read_words(name) {
  const [begin, n] = page.arrays[name], words = new Uint32Array(n);
  for (let i = 0, k = begin; i < n; ++i, ++k)
    words[i] = packed[k] | packed[k + n] << 8 | packed[k + 2 * n] << 16 | packed[k + 3 * n] << 24;
  return words;
}

// A difference, whose sign is in the lowest bit.
function unfolded(word) { return word >>> 1 ^ -(word & 1); }

// The differences from one to the next.
function read_integers(name) {
  const words = read_words(name);
  for (let i = 0, last = 0; i < words.length; ++i)
    words[i] = last = last + unfolded(words[i]) | 0;
  return words;
}

function read_floats(name) { return new Float32Array(read_words(name).buffer); }
function read_places(name) { return read_floats(name).map((x, i) => x * page.stretch[i % 3]); }

// Differences from the bits of the same number of the input.
function read_words_like_input(name, index) {
  const words = read_words(name + "-" + index);
  if (index > 0) {
    const others = triangulations[0].words[name];
    for (let i = Math.min(words.length, others.length) - 1; i >= 0; --i)
      words[i] ^= others[i];
  }
  return words;
}

// Differences from the bits of an estimate.
function with_estimates(words, estimate) {
  const floats = new Float32Array(words.length), bits = new Uint32Array(floats.buffer);
  for (let i = 0; i < words.length; ++i) {
    const x = estimate(i);
    floats[i] = x === x ? x : 0;
    bits[i] += unfolded(words[i]);
  }
  return floats;
}

// Side i of a face runs from its corner i to the next one. Each array has three entries for each face: 3 f + i.
class Triangulation {
  constructor(index) {
    this.name = index === 0 ? "input" : "triangulation";
    this.corners = read_integers("corners-" + index);
    this.sides = read_integers("sides-" + index); // the edge of each
    this.words = { lengths: read_words_like_input("lengths", index), cotangents: read_words_like_input("cotangents", index) };
    this.lengths = new Float32Array(this.words.lengths.buffer); // of each edge
    this.cotangents = with_estimates(this.words.cotangents, s => this.estimated_cotangent(s)); // of the angle opposite to each
    const sums = new Float32Array(this.lengths.length);
    this.sides.forEach((e, s) => sums[e] += this.cotangents[s]);
    this.weights = with_estimates(read_words("weights-" + index), e => sums[e]); // of each edge
    this.number_of_faces = this.corners.length / 3;
    this.number_of_edges = this.lengths.length;
    this.number_of_vertices = page.vertices[index];
    // Two sides of each edge, 3 F for a missing one, and their number.
    this.edge_sides = new Uint32Array(2 * this.number_of_edges).fill(this.corners.length);
    this.counts = new Uint8Array(this.number_of_edges);
    for (let s = 0; s < this.sides.length; ++s) {
      const e = this.sides[s];
      if (this.counts[e] < 2)
        this.edge_sides[2 * e + this.counts[e]] = s;
      this.counts[e] = Math.min(255, this.counts[e] + 1);
    }
  }
  // The command computes it in the same way.
  estimated_cotangent(s) {
    const f = s - s % 3, l = this.lengths, sides = this.sides;
    const c = l[sides[s]], a = l[sides[f + (s + 1) % 3]], b = l[sides[f + (s + 2) % 3]];
    return (a * a + b * b - c * c) / Math.sqrt((a + b + c) * (a + b - c) * (c + a - b) * (c + b - a));
  }
  sides_of(e) { return [...this.edge_sides.subarray(2 * e, 2 * e + Math.min(2, this.counts[e]))]; }
  ends(e) {
    const s = this.edge_sides[2 * e];
    return [this.corners[s], this.corners[next(s)]];
  }
  corners_of(f) { return [...this.corners.subarray(3 * f, 3 * f + 3)]; }
  // In degrees; NaN in a face without area.
  opposite_angle(s) { return Math.atan2(1, this.cotangents[s]) * 180 / Math.PI; }
  angle_at(s) { return this.opposite_angle(next(s)); }
  area(f) {
    const s = 3 * f, length = this.lengths[this.sides[s]];
    return length * length / (2 * (this.cotangents[s + 1] + this.cotangents[s + 2]));
  }
  smallest_angle(f) {
    const c = this.cotangents;
    return Math.atan2(1, Math.max(c[3 * f], c[3 * f + 1], c[3 * f + 2])) * 180 / Math.PI;
  }
  // Sides that begin at v.
  sides_from(v) {
    const result = [];
    for (let s = this.corners.indexOf(v); s >= 0; s = this.corners.indexOf(v, s + 1))
      result.push(s);
    return result;
  }
}

// The side after s around its face.
function next(s) { return s % 3 === 2 ? s - 2 : s + 1; }

// The triangles into which both triangulations cut the surface. Their corners are first the vertices of the input, then inserted ones, then
// crossings. The byte of a side is i + 1 if it lies on side i of its input face, and as well (j + 1) << 2 for side j of the result.
let surface = null, result = null;
const triangulations = [];
function read_surface() {
  page.stretch = find_stretch(read_floats("places"));
  surface = {
    places: read_places("places"),
    corners: read_integers("corners"),
    sides: read_bytes("sides"),
    faces: page.vertices.map((_, t) => read_integers("faces-" + t)), // of each triangulation, for each triangle
    plane: page.has_plane ? read_floats("plane") : null, // of the corners of the triangles
  };
  surface.box = box_of(surface.places);
  if (page.stretch.some(x => x !== 1))
    page.radius = Math.hypot(...surface.box.map(([low, high]) => (high - low) / 2));
  page.vertices.forEach((_, t) => triangulations.push(new Triangulation(t)));
  result = triangulations[triangulations.length - 1];
}

// The edge of a triangulation on which a side of a triangle lies, or -1.
function edge_of_side(t, s) {
  const side = surface.sides[s] >> 2 * t & 3;
  return side === 0 ? -1 : triangulations[t].sides[3 * surface.faces[t][Math.floor(s / 3)] + side - 1];
}

// 1 input alone, 2 result alone, 3 both, 0 neither
function label(side) { return (side & 3 ? 1 : 0) | (side & 12 ? 2 : 0); }
function label_of_side(s) { return label(surface.sides[s]); }

// The triangles within a face.
function triangles_of(t, f) {
  const triangles = [], faces = surface.faces[t];
  for (let i = faces.indexOf(f); i >= 0; i = faces.indexOf(f, i + 1))
    triangles.push(i);
  return triangles;
}

// The sides of triangles along an edge, in the face on one side of it, 0 or 1.
function segments_of(t, e, which = 0) {
  const side = triangulations[t].edge_sides[2 * e + which], f = Math.floor(side / 3), segments = [];
  for (const triangle of triangles_of(t, f))
    for (let s = 3 * triangle; s < 3 * triangle + 3; ++s)
      if ((surface.sides[s] >> 2 * t & 3) === side % 3 + 1)
        segments.push(s);
  return segments;
}

// Places in the page are moved and scaled, so that single precision suffices.
function place(v) { return new THREE.Vector3().fromArray(surface.places, 3 * v); }
function original_place(v) { return [0, 1, 2].map(i => page.center[i] + page.scale * surface.places[3 * v + i] / page.stretch[i]); }
