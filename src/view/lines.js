// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines and points on the surface.

"use strict";

// What all programs of the graphics processor know: half of the size of the picture in pixels, how wide a dash is on the surface, and the
// half space that is cut away, where cut.xyz * place > cut.w.
const common = { half_size: { value: new THREE.Vector2() }, dash: { value: 1 }, cut: { value: new THREE.Vector4() } };

function make_material(vertexShader, fragmentShader, uniforms, options = {}) {
  return new THREE.ShaderMaterial({ vertexShader, fragmentShader, uniforms: { ...common, ...uniforms }, side: THREE.DoubleSide, ...options });
}

function make_mesh(arrays, material, Type = THREE.Mesh) {
  const geometry = new THREE.BufferGeometry();
  for (const [name, [array, size, normalized]] of Object.entries(arrays))
    geometry.setAttribute(name, new THREE.BufferAttribute(array, size, normalized));
  const mesh = new Type(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

// With a second one for hidden parts: lines are dashed there, points dotted.
function with_hidden_parts(mesh) {
  const material = mesh.material.clone(), hidden = new mesh.constructor(mesh.geometry, material);
  Object.assign(material, { uniforms: mesh.material.uniforms, defines: { HIDDEN: 1 }, depthFunc: THREE.GreaterDepth, depthWrite: false });
  hidden.frustumCulled = false;
  mesh.renderOrder = 1; // after the surface
  hidden.renderOrder = 2;
  return new THREE.Group().add(mesh, hidden);
}

// \param segments pairs of places
function make_line(segments, colour, width, options) {
  const n = 12 * segments.length, position = new Float32Array(n * 1.5), other = new Float32Array(n * 1.5);
  const corner = new Float32Array(n), along = new Float32Array(n / 2);
  let length = 0;
  segments.forEach(([p, q], i) => {
    const before = length;
    length += p.distanceTo(q);
    [[p, q, 1, 1], [p, q, -1, 1], [q, p, 1, -1], [q, p, 1, -1], [p, q, -1, 1], [q, p, -1, -1]].forEach(([a, b, side, end], j) => {
      a.toArray(position, 18 * i + 3 * j);
      b.toArray(other, 18 * i + 3 * j);
      corner.set([side, end], 12 * i + 2 * j);
      along[6 * i + j] = end > 0 ? before : length;
    });
  });
  return make_mesh({ position: [position, 3], other: [other, 3], corner: [corner, 2], along: [along, 1] },
    make_material(line_vertex_shader, line_fragment_shader, { colour: { value: colour }, width: { value: width } }, options));
}

// \param scale of `numbers`, which are those of the points and colour the lines; or none
function make_path(path, numbers, scale) {
  const colours = scale ? scale.colours : [path_colour], segments = colours.map(() => []);
  for (let i = 3; i < path.length; i += 3)
    if (!isNaN(path[i]) && !isNaN(path[i - 3])) { // several lines have NaN between them
      const class_of = scale ? Math.round(Math.min(1, Math.max(0, scale.place(numbers[i / 3]))) * (colours.length - 1)) : 0;
      segments[class_of].push([new THREE.Vector3().fromArray(path, i - 3), new THREE.Vector3().fromArray(path, i)]);
    }
  const number = segments.reduce((sum, part) => sum + part.length, 0), is_many = path.filter(isNaN).length > 3 * 12, width = !isNaN(path[0]) ? 5 : number < 3000 ? 3 : 2;
  const lines = segments.map((part, i) => make_line(part, colours[i], width));
  return new THREE.Group().add(...scale || is_many ? lines : lines.map(with_hidden_parts));
}

function make_points(places, colour, width, options) {
  const position = new Float32Array(3 * places.length);
  places.forEach((p, i) => p.toArray(position, 3 * i));
  return make_mesh({ position: [position, 3] },
    make_material(point_vertex_shader, point_fragment_shader, { colour: { value: colour }, width: { value: width } }, options), THREE.Points);
}

function points_of(array) {
  const points = [];
  for (let i = 0; i < array.length; i += 3)
    points.push(new THREE.Vector3().fromArray(array, i));
  return points;
}
