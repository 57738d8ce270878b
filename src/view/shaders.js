// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The programs of the graphics processor. Edges and isolines are drawn where they lie in a triangle, by the distance of a pixel from them, so
// that none hides behind the surface.

"use strict";

function glsl(colour) { return "vec3(" + colour.map(x => x.toFixed(3)).join(",") + ")"; }

// Nothing is drawn in the half space that is cut away.
const cut_declaration = "varying vec3 at; uniform vec4 cut;";
const cut_away = "if (dot(cut.xyz, at) > cut.w) discard;";

// Moves towards the eye, or away from it, by a width in pixels; then a line is not hidden by the surface on which it lies, or only by it.
const moving = `
uniform vec2 half_size;       // of the picture in pixels
vec4 towards_eye(vec3 place, float width) {
  vec4 seen = modelViewMatrix * vec4(place, 1.0);
  seen.xyz *= 1.0 - 1.5 * width / (projectionMatrix[1][1] * half_size.y);
  return seen;
}`;

// With THIN, it draws the sides of triangles behind them, so that one that is narrower than a pixel is seen.
const surface_vertex_shader = moving + `
attribute vec3 direction;     // normal to the input face
attribute vec4 info;          // the colours in both triangulations, the labels of the sides, the corner
attribute vec3 size;          // of the edges on the sides, as in sizes_of_edges()
attribute vec2 number;        // in both triangulations, from 0 to 1; below -1e6 if there is none
attribute vec3 plane;         // the place in the plane
uniform float layer;          // 0 input, 1 result
uniform float flattened;      // 1 for the plane
uniform float radius;         // of the surface
varying vec2 on_plane;
varying vec3 at, corner, at_eye, light_normal;
flat varying vec3 labels, pixels; // of edges: their kinds, and how large they look
flat varying vec3 face_colour;
varying float shade;
uniform vec3 face_colours[6];

void main() {
#ifdef THIN
  vec4 seen = towards_eye(flattened > 0.5 ? plane : position, -1.0);
#else
  vec4 seen = modelViewMatrix * vec4(flattened > 0.5 ? plane : position, 1.0);
#endif
  gl_Position = projectionMatrix * seen;
  at = position;
  at_eye = seen.xyz;
  light_normal = flattened > 0.5 ? vec3(0.0) : normalMatrix * direction;
  on_plane = plane.xy;
  corner = vec3(equal(vec3(info.w), vec3(0.0, 1.0, 2.0)));
  float bits = info.z;
  labels = mod(floor(bits / vec3(1.0, 4.0, 16.0)), 4.0);
  pixels = 2.0 * radius * exp2((size - 255.0) / 12.0) * projectionMatrix[1][1] * half_size.y / -seen.z;
  face_colour = face_colours[int(layer < 0.5 ? info.x : info.y)];
  shade = layer < 0.5 ? number.x : number.y;
}`;

const surface_fragment_shader = cut_declaration + `
varying vec2 on_plane;
varying vec3 corner, at_eye, light_normal;
flat varying vec3 labels, pixels;
flat varying vec3 face_colour;
varying float shade;
uniform float mode;           // 0 one colour, 1 a colour for each face, 2 numbers, 3 a checkerboard in the plane
uniform vec3 scale[5];        // colours of numbers
uniform float isoline_step;   // 0 if there are none
uniform float isoline_origin;
uniform float half_width;     // of edges
uniform vec3 shown;           // 1 for each kind of edge that is drawn
uniform vec3 least_strength;  // of each kind, when they fade

vec3 colour_of_number(float x) {
  if (x < -1e6)
    return ${glsl(no_number_colour)};
  float t = clamp(x, 0.0, 1.0) * 4.0;
  int i = int(min(t, 3.0));
  return mix(scale[i], scale[i + 1], t - float(i));
}

vec3 colour_of_surface() {
  if (mode < 0.5)
    return ${glsl(plain_colour)};
  if (mode < 1.5)
    return face_colour;
  if (mode < 2.5)
    return colour_of_number(shade);
  float square = mod(floor(on_plane.x * 24.0) + floor(on_plane.y * 24.0), 2.0);
  return mix(${glsl(face_colours[0])}, ${glsl(face_colours[4])}, square);
}

void main() {
  ${cut_away}
  vec3 away = normalize(-at_eye), normal = length(light_normal) > 0.0 ? normalize(light_normal) : away;
  float facing = abs(dot(normal, away)), side = abs(dot(normal, normalize(vec3(-0.4, 0.6, 0.7))));
  vec3 colour = colour_of_surface() * (0.45 + 0.35 * facing + 0.25 * side);
  if (cut.xyz != vec3(0.0) && !gl_FrontFacing)
    colour *= 0.6;
  if (mode > 1.5 && mode < 2.5 && isoline_step > 0.0 && shade >= -1e6) {
    float x = (shade - isoline_origin) / isoline_step, slope = max(fwidth(x), 1e-9);
    float away_from_line = abs(fract(x + 0.5) - 0.5) / slope;
    colour = mix(colour, 0.4 * colour, clamp(half_width + 0.7 - away_from_line, 0.0, 1.0) * clamp(0.5 / slope - 1.0, 0.0, 1.0));
  }
#ifndef THIN
  vec3 heights = 1.0 / max(fwidth(corner), vec3(1e-9)); // of the triangle, in pixels
  // Edges fade that are short on the screen or close to each other.
  vec3 cover = clamp(half_width + 0.5 - corner * heights, 0.0, 1.0);
  vec3 strength = smoothstep(3.0, 16.0, pixels * facing);
  for (int i = 0; i < 3; ++i) {
    int kind = int(i == 0 ? labels.x : i == 1 ? labels.y : labels.z) - 1;
    if (kind < 0)
      continue;
    float c = i == 0 ? cover.x : i == 1 ? cover.y : cover.z, s = i == 0 ? strength.x : i == 1 ? strength.y : strength.z;
    vec3 edge = kind == 0 ? ${glsl(edge_colours[0])} : kind == 1 ? ${glsl(edge_colours[1])} : ${glsl(edge_colours[2])};
    colour = mix(colour, edge, c * shown[kind] * mix(least_strength[kind], 1.0, s));
  }
#endif
  gl_FragColor = vec4(colour, 1.0);
}`;

// The number of a triangle as a colour.
const number_vertex_shader = `
attribute vec3 plane;
uniform float flattened;
flat varying vec4 number;
varying vec3 at;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(flattened > 0.5 ? plane : position, 1.0);
  at = position;
  int n = gl_VertexID / 3 + 1;
  number = vec4(n & 255, n >> 8 & 255, n >> 16 & 255, n >> 24 & 255) / 255.0;
}`;
const number_fragment_shader = cut_declaration + "flat varying vec4 number; void main() { " + cut_away + " gl_FragColor = number; }";

// A line: each segment is a rectangle.
const line_vertex_shader = moving + `
uniform float width;
attribute vec3 other;
attribute vec2 corner;        // which side of the segment, and which end
attribute float along;        // the length up to here
varying vec3 at;
varying float length_here;
void main() {
  vec4 a = projectionMatrix * towards_eye(position, width), b = projectionMatrix * towards_eye(other, width);
  vec2 direction = (b.xy / b.w - a.xy / a.w) * half_size * corner.y;
  direction = length(direction) > 1e-6 ? normalize(direction) : vec2(1.0, 0.0);
  a.xy += (vec2(-direction.y, direction.x) * corner.x - direction * corner.y * 0.5) * width / 2.0 / half_size * a.w;
  gl_Position = a;
  at = position;
  length_here = along;
}`;
const line_fragment_shader = cut_declaration + `
uniform vec3 colour;
uniform float dash;
varying float length_here;
void main() {
  ${cut_away}
#ifdef HIDDEN
  if (fract(length_here / dash) > 0.5)
    discard;
#endif
  gl_FragColor = vec4(colour, 1.0);
}`;

const point_vertex_shader = moving + `
uniform float width;
varying vec3 at;
void main() {
  gl_Position = projectionMatrix * towards_eye(position, width);
  gl_PointSize = width;
  at = position;
}`;
const point_fragment_shader = cut_declaration + `
uniform vec3 colour;
void main() {
  ${cut_away}
  float r = length(gl_PointCoord - 0.5);
  if (r > 0.5)
    discard;
#ifdef HIDDEN
  if (mod(floor(gl_FragCoord.x / 2.0) + floor(gl_FragCoord.y / 2.0), 2.0) < 0.5)
    discard;
#endif
  gl_FragColor = vec4(r > 0.36 ? vec3(0.0) : colour, 1.0);
}`;
