// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The drawing: the surface with its edges, lines and points on it, in one picture or in two side by side.

"use strict";

class Picture {
  constructor(canvas) {
    this.canvas = canvas;
    const context = canvas.getContext("webgl2", { antialias: true });
    if (!context)
      throw new Error("This page needs a browser with WebGL 2.");
    this.renderer = new THREE.WebGLRenderer({ canvas, context, antialias: true });
    this.renderer.autoClear = false;
    this.is_split = false;
    this.shown = [1, 1, 1]; // the kinds of edges
    this.show_points = this.show_path = this.show_marks = true;
    this.cut = new THREE.Vector4();
    this.scene = new THREE.Scene();
    this.number_scene = new THREE.Scene();
    this.target = new THREE.WebGLRenderTarget(1, 1);
    this.add_surface();
    this.add_lines();
    this.control = new Orbit_camera(canvas, page.radius, surface.box, find_up(surface.places), () => this.request(true));
    new ResizeObserver(() => this.request()).observe(canvas);
  }

  add_surface() {
    this.uniforms = {
      layer: { value: 1 }, mode: { value: 1 }, isoline_step: { value: 0 }, isoline_origin: { value: 0 }, half_width: { value: 0.8 },
      shown: { value: [1, 1, 1] }, flattened: { value: 0 }, least_strength: { value: [0, 0, 0] }, radius: { value: page.radius },
      face_colours: { value: face_colours.map(c => new THREE.Vector3(...c)) }, scale: { value: scale_colours.map(c => new THREE.Vector3(...c)) },
    };
    const normals = make_face_normals(), colours = triangulations.map(colour_faces), sizes = triangulations.map(sizes_of_edges);
    const material = make_material(surface_vertex_shader, surface_fragment_shader, this.uniforms);
    const make_part = part => Object.assign(make_mesh(make_surface_arrays(part, normals, colours, sizes), material), { part });
    this.surface = make_part(surface);
    this.parts = [this.surface];
    this.number_material = make_material(number_vertex_shader, number_fragment_shader, { flattened: this.uniforms.flattened });
    this.number_scene.add(Object.assign(new THREE.Mesh(this.surface.geometry, this.number_material), { frustumCulled: false }));
    // If a picture takes long, a coarse one is drawn while it moves.
    this.is_slow = surface.corners.length > 3 * 50000;
    if (this.is_slow)
      this.parts.push(make_part(make_rough_surface()));
    else
      this.add_thin_parts();
    this.scene.add(...this.parts);
  }

  // The sides of triangles, which are a pixel wide even where the triangles are not.
  add_thin_parts() {
    const geometry = new THREE.BufferGeometry();
    Object.assign(geometry.attributes, this.surface.geometry.attributes);
    const sides = Uint32Array.from({ length: 2 * surface.corners.length }, (_, i) => (i % 2 ? next(i >> 1) : i >> 1));
    geometry.setIndex(new THREE.BufferAttribute(sides, 1));
    const material = make_material(surface_vertex_shader, surface_fragment_shader, this.uniforms, { defines: { THIN: 1 } });
    this.thin = new THREE.LineSegments(geometry, material);
    this.scene.add(Object.assign(this.thin, { frustumCulled: false }));
    this.number_scene.add(Object.assign(new THREE.LineSegments(geometry, this.number_material), { frustumCulled: false }));
  }

  add_lines() {
    this.marks = new THREE.Group(); // of what is found or pointed at
    this.scene.add(this.marks);
    const inserted = [];
    for (let v = page.vertices[0]; v < result.number_of_vertices; ++v)
      inserted.push(place(v));
    if (inserted.length > 0)
      this.scene.add(this.points = make_points(inserted, [1, 1, 1], 4));
    const path = read_places("path"), ends = new THREE.Group(), marks = points_of(read_places("marks"));
    if (path.length > 0) {
      const numbers = read_floats("path-numbers"), field = this.path_field = numbers.length > 0 && { numbers: [numbers], unit: page.path_unit };
      if (field) {
        find_range(field);
        field.scale = make_scale(field, best_scale(field));
      }
      this.scene.add(this.path = make_path(path, numbers, field.scale));
    }
    if (path.length > 0 && !isNaN(path[0])) { // a single line
      const places = points_of(path), first = places[0], last = places[places.length - 1];
      this.path.add(with_hidden_parts(make_points([first], [1, 1, 1], 11)));
      if (first.distanceTo(last) > 0)
        this.path.add(with_hidden_parts(make_points([last], path_colour, 11)));
    }
    if (marks.length > 0)
      this.scene.add(this.places = Object.assign(make_points(marks, highlight_colour, 9, { depthTest: false }), { renderOrder: 3 }));
    this.on_plane = new THREE.Group(); // what is drawn there alone
    if (page.has_plane) {
      this.on_plane.add(make_points(points_of(read_floats("plane-marks")), highlight_colour, 9));
      this.on_plane.add(make_path(read_floats("plane-path")));
    }
    this.scene.add(this.on_plane);
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

  is_flat(view) { return page.has_plane && this.is_split && view.layer === 1; }

  set_camera(view) {
    this.control.views = this.is_split ? 2 : 1;
    const camera = this.control.camera_for(view.w / view.h), is_flat = this.is_flat(view);
    this.uniforms.flattened.value = is_flat ? 1 : 0;
    common.half_size.value.set(view.w / 2, view.h / 2);
    common.dash.value = 14 * this.control.pixel;
    common.cut.value.copy(is_flat ? new THREE.Vector4() : this.cut);
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
    this.renderer.setClearColor(getComputedStyle(this.canvas).backgroundColor);
    this.renderer.setScissorTest(true);
    this.views.forEach(view => this.draw_view(view));
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

  draw_view(view) {
    this.renderer.setViewport(view.x, 0, view.w, view.h);
    this.renderer.setScissor(view.x, 0, view.w, view.h);
    this.renderer.clear();
    const camera = this.set_camera(view), is_flat = this.is_flat(view);
    this.uniforms.layer.value = view.layer;
    // Side by side, each picture has its own edges.
    this.uniforms.shown.value = this.shown.map((x, i) => (this.is_split && i === 1 - view.layer ? 0 : x));
    this.on_plane.visible = is_flat;
    this.marks.visible = !is_flat;
    for (const [object, is_shown] of [[this.path, this.show_path], [this.places, this.show_marks], [this.points, this.show_points && view.layer === 1]])
      if (object)
        object.visible = is_shown && !is_flat;
    this.renderer.render(this.scene, camera);
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
    camera.clearViewOffset();
    return { view, triangle: (pixel[0] | pixel[1] << 8 | pixel[2] << 16 | pixel[3] << 24) - 1 };
  }

  // Where the corner of a triangle is drawn in a view.
  place_of_corner(c, view) {
    return this.is_flat(view) ? new THREE.Vector3().fromArray(surface.plane, 3 * c) : place(surface.corners[c]);
  }

  // The position of a place in a view, in pixels of the canvas.
  pixel_of(place, view) {
    const p = place.clone().project(this.set_camera(view));
    return [view.x + (p.x + 1) / 2 * view.w, (1 - p.y) / 2 * view.h];
  }

  // The weights of the corners of a triangle at a place on the canvas, at which it is seen.
  weights_at(x, y, view, triangle) {
    const corners = [0, 1, 2].map(i => this.place_of_corner(3 * triangle + i, view)), ray = new THREE.Raycaster(), at = new THREE.Vector3();
    ray.setFromCamera(new THREE.Vector2(2 * (x + 0.5 - view.x) / view.w - 1, 1 - 2 * (y + 0.5) / view.h), this.set_camera(view));
    const face = new THREE.Triangle(...corners);
    if (!ray.ray.intersectPlane(face.getPlane(new THREE.Plane()), at))
      at.copy(corners[0]); // seen from its side
    const weights = (face.getBarycoord(at, new THREE.Vector3()) || new THREE.Vector3(1, 0, 0)).toArray().map(w => Math.max(0, w));
    return weights.map(w => w / (weights[0] + weights[1] + weights[2] || 1));
  }

  // \param field one of `find_fields()` with its scale; or a name: "faces", "plain", "checkerboard"
  set_colours(field, scale, has_isolines) {
    this.uniforms.mode.value = field === "plain" ? 0 : field === "faces" ? 1 : field === "checkerboard" ? 3 : 2;
    if (scale)
      this.set_numbers(field, scale, has_isolines);
    this.request();
  }

  set_numbers(field, scale, has_isolines) {
    for (const { geometry, part } of this.parts) {
      if (!geometry.getAttribute("number"))
        geometry.setAttribute("number", new THREE.BufferAttribute(new Float32Array(2 * part.corners.length), 2));
      const attribute = geometry.getAttribute("number");
      for (let c = 0; c < part.corners.length; ++c)
        for (let t = 0; t < 2; ++t)
          attribute.array[2 * c + t] = scale.place(number_at(field, part, t, c));
      attribute.needsUpdate = true;
    }
    if (this.thin)
      this.thin.geometry.setAttribute("number", this.surface.geometry.getAttribute("number"));
    this.uniforms.scale.value = scale.colours.map(c => new THREE.Vector3(...c));
    this.uniforms.isoline_step.value = has_isolines && !field.of_faces ? scale.step : 0;
    this.uniforms.isoline_origin.value = scale.origin || 0;
  }

  // Marks segments, given as sides of triangles, and vertices: nothing hides them.
  mark(segments, vertices) {
    for (const mark of [...this.marks.children]) {
      mark.geometry.dispose();
      mark.material.dispose();
      this.marks.remove(mark);
    }
    const end = s => place(surface.corners[s]);
    if (segments.length > 0)
      this.marks.add(make_line(segments.map(s => [end(s), end(next(s))]), highlight_colour, 7, { depthTest: false }));
    if (vertices.length > 0)
      this.marks.add(make_points(vertices.map(place), highlight_colour, 12, { depthTest: false }));
    this.marks.children.forEach(mark => (mark.renderOrder = 3));
    this.request();
  }
}
