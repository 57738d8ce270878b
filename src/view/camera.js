// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One camera for all pictures. It looks at a point from some distance; mouse or fingers turn, move and zoom it.

"use strict";

// Degrees above the horizon, and from the front to the right.
const views_of_camera = { oblique: [20, 30], front: [0, 0], right: [0, 90], back: [0, 180], left: [0, -90], top: [90, 0], bottom: [-90, 0] };
const half_angle = 15 * Math.PI / 180; // of the smaller of width and height

class Orbit_camera {
  // \param box of the surface; \param up an axis, as "z" or "−z"; \param on_change is called after each change
  constructor(element, radius, box, up, on_change) {
    this.camera = new THREE.PerspectiveCamera();
    this.element = element;
    this.box = new THREE.Vector3(...box.map(([low, high]) => high - low));
    this.radius = radius; // of the surface, around the origin
    this.on_change = on_change;
    this.pointers = new Map();
    this.views = 1;
    this.set_up(up);
    element.addEventListener("pointerdown", event => this.begin(event));
    element.addEventListener("pointermove", event => this.drag(event));
    for (const name of ["pointerup", "pointercancel"])
      element.addEventListener(name, event => this.pointers.delete(event.pointerId));
    element.addEventListener("contextmenu", event => event.preventDefault());
    element.addEventListener("wheel", event => {
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 30 : 1;
      this.zoom(Math.exp(0.0015 * lines * event.deltaY), event.offsetX, event.offsetY);
    }, { passive: false });
  }

  set_up(name) {
    const axis = "xyz".indexOf(name.slice(-1));
    this.up = new THREE.Vector3().setComponent(axis, name.length > 1 ? -1 : 1);
    this.look_from("oblique");
  }

  // \param name one of `views_of_camera` \param turned by so many degrees more to the right
  look_from(name, turned = 0) {
    let [pitch, yaw] = views_of_camera[name];
    const front = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 1, 0), this.up);
    if (name === "oblique") { // a long one from its side, a flat one from above, an upright plane from its front
      const [width, height, depth] = [0, 1, 2].map(i => Math.abs(new THREE.Vector3().setComponent(i, 1).applyQuaternion(front).dot(this.box)));
      [pitch, yaw] = [height < 0.3 * Math.min(width, depth) ? 45 : pitch, depth > 1.5 * width ? 90 - yaw : yaw];
      if (Math.min(width, depth) < 1e-6 * height)
        [pitch, yaw] = [0, width < depth ? 90 : 0];
    }
    this.flight = null;
    this.turn = front.multiply(new THREE.Quaternion().setFromEuler(new THREE.Euler(-pitch * Math.PI / 180, (yaw + turned) * Math.PI / 180, 0, "YXZ")));
    this.show_all();
  }

  // From the point in view.
  get direction() { return new THREE.Vector3(0, 0, 1).applyQuaternion(this.turn); }

  show_all() {
    this.center = new THREE.Vector3();
    this.distance = 1.02 * this.radius / Math.sin(half_angle);
    this.update();
  }

  update() {
    this.distance = Math.min(20 * this.radius, Math.max(1e-5 * this.radius, this.distance));
    const away = new THREE.Vector3(0, 0, this.distance).applyQuaternion(this.turn);
    this.camera.position.copy(this.center).add(away);
    this.camera.quaternion.copy(this.turn);
    const reach = this.camera.position.length() + this.radius;
    this.camera.far = 1.01 * reach;
    this.camera.near = Math.max(this.distance / 50, this.camera.position.length() - 1.01 * this.radius);
    this.on_change();
  }

  get is_dragged() { return this.pointers.size > 0; }
  // The size of a pixel at the point in view.
  get pixel() {
    return 2 * this.distance * Math.tan(half_angle) / Math.min(this.element.clientWidth / this.views, this.element.clientHeight);
  }

  // \param aspect width by height
  camera_for(aspect) {
    this.camera.aspect = aspect;
    this.camera.fov = 2 * Math.atan(Math.tan(half_angle) / Math.min(1, aspect)) * 180 / Math.PI;
    this.camera.updateProjectionMatrix();
    return this.camera;
  }

  begin(event) {
    this.flight = null;
    this.pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
    if (event.isTrusted)
      this.element.setPointerCapture(event.pointerId);
  }

  drag(event) {
    const old = this.pointers.get(event.pointerId);
    if (!old)
      return;
    const dx = event.offsetX - old[0], dy = event.offsetY - old[1];
    if (this.pointers.size === 1) {
      if (event.shiftKey || event.buttons & 6)
        this.move(dx, dy);
      else
        this.rotate(dx, dy);
    } else {
      const [x, y] = [...this.pointers].find(([id]) => id !== event.pointerId)[1];
      const before = Math.hypot(old[0] - x, old[1] - y), after = Math.hypot(event.offsetX - x, event.offsetY - y);
      this.move(dx / 2, dy / 2);
      if (before > 0 && after > 0)
        this.zoom(before / after, x, y);
    }
    this.pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
  }

  // A drag over the height of the picture turns by a half. What is up stays so.
  rotate(dx, dy) {
    const angle = Math.PI / this.element.clientHeight;
    this.turn.premultiply(new THREE.Quaternion().setFromAxisAngle(this.up, -dx * angle))
      .multiply(new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(1, 0, 0), -dy * angle)).normalize();
    this.update();
  }

  move(dx, dy) {
    this.center.add(new THREE.Vector3(-dx * this.pixel, dy * this.pixel, 0).applyQuaternion(this.turn));
    this.update();
  }

  // The point seen at (x, y) stays there.
  zoom(factor, x, y) {
    const width = this.element.clientWidth / this.views, height = this.element.clientHeight;
    const at = new THREE.Vector3((x % width) - width / 2, height / 2 - y, 0).multiplyScalar(this.pixel);
    const distance = this.distance;
    this.distance *= factor;
    this.distance = Math.max(1e-5 * this.radius, this.distance);
    this.center.add(at.multiplyScalar(1 - this.distance / distance).applyQuaternion(this.turn));
    this.update();
  }

  // The distance from which something of this size fills the picture.
  distance_for(size) { return Math.max(2e-5 * this.radius, 1.1 * size / Math.sin(half_angle)); }

  // Flies to a distance from a place, in a third of a second. \param direction from the place
  fly(place, direction, distance) {
    const right = new THREE.Vector3().crossVectors(this.up, direction);
    if (right.length() < 1e-3) // from above or below
      right.set(1, 0, 0).applyQuaternion(this.turn).projectOnPlane(direction);
    const above = new THREE.Vector3().crossVectors(direction, right.normalize());
    const turn = new THREE.Quaternion().setFromRotationMatrix(new THREE.Matrix4().makeBasis(right, above, direction));
    const flight = this.flight = {
      begin: performance.now(), center: this.center.clone(), turn: this.turn.clone(), distance: this.distance,
    };
    const step = () => {
      if (this.flight !== flight)
        return;
      const t = Math.min(1, (performance.now() - flight.begin) / 350), smooth = t * t * (3 - 2 * t);
      this.center.lerpVectors(flight.center, place, smooth);
      THREE.Quaternion.slerp(flight.turn, turn, this.turn, smooth);
      this.distance = flight.distance * (distance / flight.distance) ** smooth;
      this.update();
      if (t < 1)
        requestAnimationFrame(step);
      else
        this.flight = null;
    };
    step();
  }
}
