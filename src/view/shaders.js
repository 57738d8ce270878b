// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The programs of the graphics processor. Edges and isolines are drawn where they lie in a triangle, by the distance of a pixel from them, so
// that none hides behind the surface.

"use strict";

function glsl(colour) { return "vec3(" + colour.map(x => x.toFixed(3)).join(",") + ")"; }

const surface_vertex_shader = `
attribute vec3 direction;     // normal to the input face
attribute vec4 info;          // the colours in both triangulations, the labels of the sides, the corner
attribute vec2 number;        // in both triangulations, from 0 to 1; below -1 if there is none
attribute vec3 plane;         // the place in the plane
uniform float layer;          // 0 input, 1 result
uniform float flattened;      // 1 for the plane
varying vec2 on_plane;
varying vec3 corner, at_eye, light_normal;
flat varying vec3 labels;
flat varying vec3 face_colour;
varying float shade;
uniform vec3 face_colours[6];

void main() {
  vec4 seen = modelViewMatrix * vec4(flattened > 0.5 ? plane : position, 1.0);
  gl_Position = projectionMatrix * seen;
  at_eye = seen.xyz;
  light_normal = flattened > 0.5 ? vec3(0.0) : normalMatrix * direction;
  on_plane = plane.xy;
  corner = vec3(equal(vec3(info.w), vec3(0.0, 1.0, 2.0)));
  float bits = info.z;
  labels = mod(floor(bits / vec3(1.0, 4.0, 16.0)), 4.0);
  face_colour = face_colours[int(layer < 0.5 ? info.x : info.y)];
  shade = layer < 0.5 ? number.x : number.y;
}`;

const surface_fragment_shader = `
varying vec2 on_plane;
varying vec3 corner, at_eye, light_normal;
flat varying vec3 labels;
flat varying vec3 face_colour;
varying float shade;
uniform float mode;           // 0 one colour, 1 a colour for each face, 2 numbers, 3 a checkerboard in the plane
uniform float isoline_step;   // 0 if there are none
uniform float isoline_offset;
uniform float half_width;     // of edges
uniform vec3 shown;           // 1 for each kind of edge that is drawn

vec3 colour_of_number(float x) {
  vec3 c[5];
  ${scale_colours.map((c, i) => "c[" + i + "] = " + glsl(c) + ";").join(" ")}
  float t = clamp(x, 0.0, 1.0) * 4.0;
  int i = int(min(t, 3.0));
  return mix(c[i], c[i + 1], t - float(i));
}

void main() {
  vec3 away = normalize(-at_eye), normal = length(light_normal) > 0.0 ? normalize(light_normal) : away;
  float facing = abs(dot(normal, away)), side = abs(dot(normal, normalize(vec3(-0.4, 0.6, 0.7))));
  float square = mod(floor(on_plane.x * 24.0) + floor(on_plane.y * 24.0), 2.0);
  vec3 colour = mode > 2.5 ? mix(${glsl(face_colours[0])}, ${glsl(face_colours[4])}, square) : mode < 0.5 ? ${glsl(plain_colour)} : mode < 1.5 ? face_colour : shade < -1.0 ? ${glsl(no_number_colour)} : colour_of_number(shade);
  colour *= 0.45 + 0.35 * facing + 0.25 * side;
  if (mode > 1.5 && mode < 2.5 && isoline_step > 0.0 && shade >= -1.0) {
    float x = (shade - isoline_offset) / isoline_step, slope = max(fwidth(x), 1e-9);
    float away_from_line = abs(fract(x + 0.5) - 0.5) / slope;
    colour = mix(colour, 0.4 * colour, clamp(half_width + 0.7 - away_from_line, 0.0, 1.0) * clamp(0.5 / slope - 1.0, 0.0, 1.0));
  }
  vec3 slopes = max(fwidth(corner), vec3(1e-9)), distance_to_side = corner / slopes;
  float size = 1.0 / min(slopes.x, min(slopes.y, slopes.z)); // of the triangle, in pixels
  vec3 cover = clamp(half_width + 0.5 - distance_to_side, 0.0, 1.0) * clamp(size / 6.0, 0.0, 1.0);
  for (int i = 0; i < 3; ++i) {
    float label = i == 0 ? labels.x : i == 1 ? labels.y : labels.z, c = i == 0 ? cover.x : i == 1 ? cover.y : cover.z;
    if (label < 0.5)
      continue;
    vec3 edge = label < 1.5 ? ${glsl(edge_colours[0])} : label < 2.5 ? ${glsl(edge_colours[1])} : ${glsl(edge_colours[2])};
    colour = mix(colour, edge, c * (label < 1.5 ? shown.x : label < 2.5 ? shown.y : shown.z));
  }
  gl_FragColor = vec4(colour, 1.0);
}`;

// The number of a triangle as a colour.
const number_vertex_shader = `
attribute vec3 plane;
uniform float flattened;
flat varying vec4 number;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(flattened > 0.5 ? plane : position, 1.0);
  int n = gl_VertexID / 3 + 1;
  number = vec4(n & 255, n >> 8 & 255, n >> 16 & 255, n >> 24 & 255) / 255.0;
}`;
const number_fragment_shader = "flat varying vec4 number; void main() { gl_FragColor = number; }";

// The position of something of a width in pixels: moved by that width towards the eye, so that the surface does not hide it.
const front = `
uniform vec2 size;            // half of that of the picture in pixels
uniform float width;
vec4 in_front(vec3 place) {
  vec4 seen = modelViewMatrix * vec4(place, 1.0);
  seen.xyz *= 1.0 - 1.5 * width / (projectionMatrix[1][1] * size.y);
  return projectionMatrix * seen;
}`;

// A line: each segment is a rectangle.
const line_vertex_shader = front + `
attribute vec3 other;
attribute vec2 corner;        // which side of the segment, and which end
void main() {
  vec4 a = in_front(position), b = in_front(other);
  vec2 along = (b.xy / b.w - a.xy / a.w) * size * corner.y;
  along = length(along) > 1e-6 ? normalize(along) : vec2(1.0, 0.0);
  a.xy += (vec2(-along.y, along.x) * corner.x - along * corner.y * 0.5) * width / 2.0 / size * a.w;
  gl_Position = a;
}`;
const plain_fragment_shader = "uniform vec3 colour; void main() { gl_FragColor = vec4(colour, 1.0); }";

const point_vertex_shader = front + `
void main() {
  gl_Position = in_front(position);
  gl_PointSize = width;
}`;
const point_fragment_shader = `
uniform vec3 colour;
void main() {
  float r = length(gl_PointCoord - 0.5);
  if (r > 0.5)
    discard;
  gl_FragColor = vec4(r > 0.36 ? vec3(0.0) : colour, 1.0);
}`;
