// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The drawing: the surface with its edges, lines and points on it, in one picture or in two side by side.

"use strict";

function make_material(vertexShader, fragmentShader, uniforms) {
  return new THREE.ShaderMaterial({ vertexShader, fragmentShader, uniforms, side: THREE.DoubleSide });
}

function make_mesh(arrays, material, Type = THREE.Mesh) {
  const geometry = new THREE.BufferGeometry();
  for (const [name, [array, size, normalized]] of Object.entries(arrays))
    geometry.setAttribute(name, new THREE.BufferAttribute(array, size, normalized));
  const mesh = new Type(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

// \param segments pairs of places
function make_line(segments, colour, width) {
  const n = 12 * segments.length, position = new Float32Array(n * 1.5), other = new Float32Array(n * 1.5), corner = new Float32Array(n);
  segments.forEach(([p, q], i) => {
    [[p, q, 1, 1], [p, q, -1, 1], [q, p, 1, -1], [q, p, 1, -1], [p, q, -1, 1], [q, p, -1, -1]].forEach(([a, b, side, end], j) => {
      a.toArray(position, 18 * i + 3 * j);
      b.toArray(other, 18 * i + 3 * j);
      corner.set([side, end], 12 * i + 2 * j);
    });
  });
  return make_mesh({ position: [position, 3], other: [other, 3], corner: [corner, 2] }, make_material(line_vertex_shader, plain_fragment_shader,
    { colour: { value: colour }, width: { value: width }, size: { value: null } }));
}

// \param numbers for each point, to colour the lines; or none
function make_path(path, numbers) {
  const lowest = numbers.reduce((x, y) => Math.min(x, y), Infinity), highest = numbers.reduce((x, y) => Math.max(x, y), -Infinity);
  const colours = numbers.length > 0 ? scale_colours : [path_colour], segments = colours.map(() => []);
  for (let i = 3; i < path.length; i += 3)
    if (!isNaN(path[i]) && !isNaN(path[i - 3])) { // several lines have NaN between them
      const class_of = numbers.length > 0 && highest > lowest ? Math.round((numbers[i / 3] - lowest) / (highest - lowest) * (colours.length - 1)) : 0;
      segments[class_of].push([new THREE.Vector3().fromArray(path, i - 3), new THREE.Vector3().fromArray(path, i)]);
    }
  return new THREE.Group().add(...segments.map((part, i) => make_line(part, colours[i], isNaN(path[0]) ? 3 : 5)));
}

function make_points(places, colour, width) {
  const position = new Float32Array(3 * places.length);
  places.forEach((p, i) => p.toArray(position, 3 * i));
  return make_mesh({ position: [position, 3] }, make_material(point_vertex_shader, point_fragment_shader,
    { colour: { value: colour }, width: { value: width }, size: { value: null } }), THREE.Points);
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

function points_of(array) {
  const points = [];
  for (let i = 0; i < array.length; i += 3)
    points.push(new THREE.Vector3().fromArray(array, i));
  return points;
}

// Per corner of each triangle: nothing is shared, so that a triangle can have colours of its own.
function make_surface_arrays({ places, corners, sides, faces, plane }, face_normals, colours) {
  const n = corners.length, last = colours.length - 1;
  const position = new Float32Array(3 * n), direction = new Int8Array(3 * n), info = new Uint8Array(4 * n);
  for (let c = 0; c < n; ++c)
    for (let i = 0; i < 3; ++i)
      position[3 * c + i] = places[3 * corners[c] + i];
  for (let t = 0; t < n / 3; ++t) {
    const input = faces[0][t], input_colour = colours[0][input], result_colour = colours[last][faces[last][t]];
    // Side i is opposite to the corner before it.
    const labels = label(sides[3 * t + 1]) | label(sides[3 * t + 2]) << 2 | label(sides[3 * t]) << 4;
    for (let i = 0; i < 3; ++i) {
      const c = 3 * t + i;
      for (let k = 0; k < 3; ++k)
        direction[3 * c + k] = face_normals[3 * input + k];
      info[4 * c] = input_colour;
      info[4 * c + 1] = result_colour;
      info[4 * c + 2] = labels;
      info[4 * c + 3] = i;
    }
  }
  return { position: [position, 3], direction: [direction, 3, true], info: [info, 4], plane: [plane || position, 3] };
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

class Picture {
  constructor(canvas) {
    this.canvas = canvas;
    const context = canvas.getContext("webgl2", { antialias: true });
    if (!context)
      throw new Error("This page needs a browser with WebGL 2.");
    this.renderer = new THREE.WebGLRenderer({ canvas, context, antialias: true });
    this.renderer.setClearColor(0xf4f4f2);
    this.renderer.autoClear = false;
    this.is_split = false;
    this.uniforms = {
      layer: { value: 1 }, mode: { value: 1 }, isoline_step: { value: 0 }, isoline_offset: { value: 0 }, half_width: { value: 0.8 },
      shown: { value: [1, 1, 1] }, flattened: { value: 0 }, face_colours: { value: face_colours.map(c => new THREE.Vector3(...c)) },
    };
    this.shown = [1, 1, 1];
    const normals = make_face_normals(), colours = triangulations.map(colour_faces);
    const material = make_material(surface_vertex_shader, surface_fragment_shader, this.uniforms);
    const make_part = part => Object.assign(make_mesh(make_surface_arrays(part, normals, colours), material), { part });
    this.surface = make_part(surface);
    this.parts = [this.surface];
    // If a picture takes long, a coarse one is drawn while it moves.
    this.is_slow = surface.corners.length > 3 * 50000;
    if (this.is_slow)
      this.parts.push(make_part(make_rough_surface()));
    this.numbers = new THREE.Mesh(this.surface.geometry, make_material(number_vertex_shader, number_fragment_shader, { flattened: this.uniforms.flattened }));
    this.numbers.frustumCulled = false;
    this.number_scene = new THREE.Scene().add(this.numbers);
    this.target = new THREE.WebGLRenderTarget(1, 1);
    this.scene = new THREE.Scene().add(...this.parts);
    this.marks = new THREE.Group();
    this.scene.add(this.marks);
    const inserted = [];
    for (let v = page.vertices[0]; v < result.number_of_vertices; ++v)
      inserted.push(place(v));
    if (inserted.length > 0)
      this.scene.add(this.points = make_points(inserted, [1, 1, 1], 4));
    this.on_surface = []; // what is drawn there alone
    this.on_plane = [];
    if (page.has_plane) {
      const marks = points_of(read_floats("marks")), plane_marks = points_of(read_floats("plane-marks"));
      if (marks.length > 0) {
        this.on_surface.push(make_points(marks, highlight_colour, 9));
        this.on_plane.push(make_points(plane_marks, highlight_colour, 9));
      }
      this.on_plane.push(make_path(read_floats("plane-path"), new Float32Array(0)));
      this.scene.add(...this.on_surface, ...this.on_plane);
    }
    if (page.arrays.path[1] > 0)
      this.scene.add(this.path = make_path(read_floats("path"), read_floats("path-numbers")));
    this.control = new Orbit_camera(canvas, page.radius, () => this.request(true));
    new ResizeObserver(() => this.request()).observe(canvas);
  }

  // Draws soon, once for all requests.
  request(is_moving = false) {
    this.is_moving = this.is_moving || is_moving;
    if (!this.is_requested) {
      this.is_requested = true;
      requestAnimationFrame(() => this.draw());
    }
  }

  get views() {
    const { clientWidth: w, clientHeight: h } = this.canvas;
    return this.is_split ? [{ x: 0, w: w / 2, h, layer: 0 }, { x: w / 2, w: w / 2, h, layer: 1 }] : [{ x: 0, w, h, layer: 1 }];
  }

  set_camera(view) {
    this.control.views = this.is_split ? 2 : 1;
    const camera = this.control.camera_for(view.w / view.h), is_flat = page.has_plane && this.is_split && view.layer === 1;
    this.uniforms.flattened.value = is_flat ? 1 : 0;
    if (!is_flat)
      return camera;
    const front = camera.clone(); // it shares the zoom
    front.position.set(0, 0, this.control.distance);
    front.quaternion.set(0, 0, 0, 1);
    front.near = this.control.distance / 50;
    front.far = 2 * this.control.distance;
    front.updateProjectionMatrix();
    return front;
  }

  draw() {
    this.is_requested = false;
    const { clientWidth: w, clientHeight: h } = this.canvas;
    if (w === 0 || h === 0)
      return;
    const begin = performance.now(), is_rough = this.is_rough = this.is_slow && this.is_moving;
    const ratio = Math.min(2, window.devicePixelRatio) * (is_rough ? 0.5 : 1);
    if (this.canvas.width !== Math.floor(w * ratio) || this.canvas.height !== Math.floor(h * ratio)) {
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(w, h, false);
    }
    this.parts.forEach((part, i) => (part.visible = this.parts.length < 2 || is_rough === (i === 1)));
    this.uniforms.half_width.value = 0.8 * ratio;
    this.renderer.setScissorTest(true);
    for (const view of this.views) {
      this.renderer.setViewport(view.x, 0, view.w, h);
      this.renderer.setScissor(view.x, 0, view.w, h);
      this.renderer.clear();
      this.uniforms.layer.value = view.layer;
      // Side by side, each picture has its own edges.
      this.uniforms.shown.value = this.shown.map((x, i) => (this.is_split && i === 1 - view.layer ? 0 : x));
      const camera = this.set_camera(view), is_flat = this.uniforms.flattened.value === 1;
      this.on_surface.forEach(object => (object.visible = !is_flat));
      this.on_plane.forEach(object => (object.visible = is_flat));
      this.marks.visible = !is_flat;
      if (this.path)
        this.path.visible = this.show_path !== false && !is_flat;
      if (this.points)
        this.points.visible = this.show_points !== false && view.layer === 1;
      this.scene.traverse(object => {
        const uniforms = object.material && object.material.uniforms;
        if (uniforms && uniforms.size)
          uniforms.size.value = new THREE.Vector2(view.w / 2, view.h / 2);
      });
      this.renderer.render(this.scene, camera);
    }
    if (this.parts.length > 1 && !is_rough) {
      const context = this.renderer.getContext();
      context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4)); // which waits for the picture
      this.is_slow = performance.now() - begin > 60;
    }
    clearTimeout(this.timer);
    this.is_moving = is_rough && this.control.is_dragged;
    if (is_rough)
      this.timer = setTimeout(() => this.request(), 250);
    this.number_of_pictures = (this.number_of_pictures || 0) + 1;
  }

  // The view under a place on the canvas, and the triangle that is seen there, or -1.
  triangle_at(x, y) {
    const view = this.views.find(v => x >= v.x && x < v.x + v.w), pixel = new Uint8Array(4);
    if (!view)
      return { view, triangle: -1 };
    const camera = this.set_camera(view);
    camera.setViewOffset(view.w, view.h, x - view.x, y, 1, 1);
    this.renderer.setRenderTarget(this.target);
    this.renderer.setClearColor(0, 0);
    this.renderer.clear();
    this.renderer.render(this.number_scene, camera);
    this.renderer.readRenderTargetPixels(this.target, 0, 0, 1, 1, pixel);
    this.renderer.setRenderTarget(null);
    this.renderer.setClearColor(0xf4f4f2, 1);
    camera.clearViewOffset();
    return { view, triangle: (pixel[0] | pixel[1] << 8 | pixel[2] << 16 | pixel[3] << 24) - 1 };
  }

  // The position of a place on the canvas, in pixels.
  pixel_of(place, view) {
    const p = place.clone().project(this.set_camera(view));
    return [view.x + (p.x + 1) / 2 * view.w, (1 - p.y) / 2 * view.h];
  }

  // Colours the surface by a field; by a name: "faces", "plain", "checkerboard".
  set_colours(field, has_isolines) {
    this.uniforms.mode.value = field === "plain" ? 0 : field === "faces" ? 1 : field === "checkerboard" ? 3 : 2;
    this.uniforms.isoline_step.value = 0;
    if (field.numbers) {
      const range = field.highest - field.lowest || 1;
      for (const { geometry, part: { corners, faces } } of this.parts) {
        if (!geometry.getAttribute("number"))
          geometry.setAttribute("number", new THREE.BufferAttribute(new Float32Array(2 * corners.length), 2));
        const attribute = geometry.getAttribute("number");
        for (let c = 0; c < corners.length; ++c)
          for (let t = 0; t < 2; ++t) {
            const k = Math.min(t, triangulations.length - 1), x = field.numbers[k][field.of_faces ? faces[k][Math.floor(c / 3)] : corners[c]];
            attribute.array[2 * c + t] = isFinite(x) ? (x - field.lowest) / range : -1e9;
          }
        attribute.needsUpdate = true;
      }
      if (has_isolines && !field.of_faces && field.step) {
        this.uniforms.isoline_step.value = field.step / range;
        this.uniforms.isoline_offset.value = -field.lowest / range;
      }
    }
    this.request();
  }

  // Marks segments, given as sides of triangles, and vertices.
  mark(segments, vertices) {
    for (const mark of [...this.marks.children]) {
      mark.geometry.dispose();
      mark.material.dispose();
      this.marks.remove(mark);
    }
    const end = s => place(surface.corners[s]);
    if (segments.length > 0)
      this.marks.add(make_line(segments.map(s => [end(s), end(next(s))]), highlight_colour, 7));
    if (vertices.length > 0)
      this.marks.add(make_points(vertices.map(place), highlight_colour, 12));
    this.request();
  }
}
