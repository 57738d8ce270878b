// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The element that is searched for, and from where it is seen.

"use strict";

// The element that a text names, as element_at() does: "v 12", "e 5", "f 3", the latter two of the input with "input" in front.
// \exception Error that names the mistake
function find_element(text) {
  const words = /^\s*(input\s+|i)?(v|vertex|e|edge|f|face)\s*(\d+)\s*$/i.exec(text);
  if (!words)
    throw new Error("Write v, e or f and a number, such as e 5, or input e 5.");
  const t = words[1] ? 0 : triangulations.length - 1, kind = words[2][0].toLowerCase(), number = Number(words[3]), triangulation = triangulations[t];
  const [name, count] = { v: ["vertices", triangulation.number_of_vertices], e: ["edges", triangulation.number_of_edges], f: ["faces", triangulation.number_of_faces] }[kind];
  if (number >= count)
    throw new Error("The " + triangulation.name + " has " + count + " " + name + ", counted from 0.");
  const numbers = triangulations.map((_, i) => (i === t ? number : -1));
  return kind === "v" ? { vertex: number } : kind === "e" ? { edges: numbers } : { faces: numbers };
}

// The triangles of an element, and what of it is to be in the middle of the picture: one of the parts, each the corners of a triangle that
// are a vertex, the ends of a segment, or a triangle.
function find_parts(element) {
  const numbers = element.edges || element.faces, t = numbers && numbers.findIndex(number => number >= 0);
  const corners_of = triangle => [3 * triangle, 3 * triangle + 1, 3 * triangle + 2];
  let parts = [];
  if (element.faces)
    parts = triangles_of(t, numbers[t]).map(corners_of);
  else if (element.edges)
    parts = [0, 1].flatMap(which => segments_of(t, numbers[t], which)).map(s => [s, next(s)]);
  else
    for (let c = surface.corners.indexOf(element.vertex); c >= 0; c = surface.corners.indexOf(element.vertex, c + 1))
      parts.push([c]);
  if (parts.length === 0)
    throw new Error("It belongs to no face.");
  const triangles = parts.map(part => Math.floor(part[0] / 3)), places_of = part => part.map(c => place(surface.corners[c]));
  const size_of = ([p, q, r]) => (r ? q.clone().sub(p).cross(r.clone().sub(p)).length() : q ? p.distanceTo(q) : 0);
  const largest = parts.reduce((best, part) => (size_of(places_of(part)) > size_of(places_of(best)) ? part : best));
  const box = new THREE.Box3();
  (element.vertex === undefined ? parts : triangles.map(corners_of)).forEach(part => places_of(part).forEach(p => box.expandByPoint(p)));
  const size = box.getSize(new THREE.Vector3()).length();
  return { triangles, largest, is_small: size < 2e-6 * page.radius, center: places_of(largest).reduce((sum, p) => sum.addScaledVector(p, 1 / largest.length), new THREE.Vector3()),
    size: Math.max(size, 1e-4 * page.radius) };
}

// How far one sees from a place in each direction, before a triangle is in the way. \param own triangles at the place, which are not
function lines_of_sight(from, directions, own) {
  const lengths = directions.map(() => Infinity), is_own = new Set(own), { places, corners } = surface;
  const a = new THREE.Vector3(), b = new THREE.Vector3(), c = new THREE.Vector3(), n = new THREE.Vector3(), ab = new THREE.Vector3();
  for (let t = 0; t < corners.length / 3; ++t) {
    if (is_own.has(t))
      continue;
    [a, b, c].forEach((p, i) => p.fromArray(places, 3 * corners[3 * t + i]).sub(from));
    // A ray meets the triangle if it has the same orientation with its three sides.
    n.crossVectors(ab.subVectors(b, a), n.subVectors(c, a));
    const height = n.dot(a);
    directions.forEach((d, i) => {
      const slope = n.dot(d), length = height / slope;
      if (!(length > 1e-7) || length >= lengths[i])
        return;
      const sign = Math.sign(slope);
      if ([[a, b], [b, c], [c, a]].every(([p, q]) => sign * ab.crossVectors(p, q).dot(d) >= 0))
        lengths[i] = length;
    });
  }
  return lengths;
}

// Walks around the surface until most of the lines and points on it are seen, if many are not.
function look_at_lines(picture) {
  const drawn = [...points_of(read_places("marks")), ...points_of(read_places("path"))].filter(p => !isNaN(p.x));
  if (drawn.length === 0 || picture.path_field)
    return;
  const size = Math.min(drawn.length, 12, Math.ceil(3e6 / surface.corners.length));
  const sample = Array.from({ length: size }, (_, i) => drawn[Math.floor((i + 0.5) * drawn.length / size)]);
  const { control } = picture, seen = [0, 90, 180, 270].map(angle => {
    control.look_from("oblique", angle);
    const { direction } = control;
    return sample.filter(p => lines_of_sight(p.clone().addScaledVector(direction, 1e-3 * page.radius), [direction], [])[0] === Infinity).length;
  });
  const most = Math.max(...seen);
  control.look_from("oblique", most > seen[0] + size / 4 ? 90 * seen.indexOf(most) : 0);
}

// Around a direction, and around the opposite one.
function directions_around(normal) {
  const u = new THREE.Vector3(normal.y, normal.z, normal.x).cross(normal).normalize(), v = new THREE.Vector3().crossVectors(normal, u);
  const tilted = (degrees, k) => normal.clone().multiplyScalar(Math.cos(degrees * Math.PI / 180))
    .addScaledVector(u, Math.sin(degrees * Math.PI / 180) * Math.cos(k * Math.PI / 4)).addScaledVector(v, Math.sin(degrees * Math.PI / 180) * Math.sin(k * Math.PI / 4));
  const front = [30, 60].flatMap(degrees => [0, 1, 2, 3, 4, 5, 6, 7].map(k => tilted(degrees, k)));
  return [...front, normal.clone().negate(), ...front.map(d => d.clone().negate())];
}

// Turns the camera to an element: to its outside, or if something is in the way there, to where it is seen from farthest away; the camera
// stays before the first obstacle.
function fly_to(picture, element) {
  const { triangles, largest, is_small, center, size } = find_parts(element), triangle = Math.floor(largest[0] / 3);
  const normals = picture.surface.geometry.getAttribute("direction").array, normal = new THREE.Vector3();
  triangles.forEach(t => normal.add(new THREE.Vector3().fromArray(normals, 9 * t)));
  if (normal.length() === 0)
    normal.set(0, 0, 1);
  let direction = normal.normalize(), [reach] = lines_of_sight(center, [normal], triangles);
  const distance = picture.control.distance_for(size);
  if (reach < 1.02 * distance) {
    const others = directions_around(normal), lengths = lines_of_sight(center, others, triangles);
    const free = lengths.findIndex(length => length > 1.02 * distance), i = free >= 0 ? free : lengths.indexOf(Math.max(...lengths));
    if (lengths[i] > reach)
      [direction, reach] = [others[i], lengths[i]];
  }
  if (picture.cut.x * center.x + picture.cut.y * center.y + picture.cut.z * center.z > picture.cut.w)
    picture.cut.set(0, 0, 0, 0);
  picture.control.fly(center, direction, Math.min(distance, 0.98 * reach));
  Object.assign(element, { triangle, layer: triangulations.length - 1, weights: [0, 1, 2].map(i => (largest.includes(3 * triangle + i) ? 1 / largest.length : 0)),
    corner: is_small ? surface.corners[largest[0]] : undefined });
}
