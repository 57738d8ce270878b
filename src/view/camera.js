// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One camera for all pictures. It looks at a point from some distance; mouse or fingers turn, move and zoom it.

"use strict";

const half_angle = 15 * Math.PI / 180; // of the smaller of width and height

class Orbit_camera {
  // \param on_change is called after each change
  constructor(element, radius, on_change) {
    this.camera = new THREE.PerspectiveCamera();
    this.element = element;
    this.radius = radius; // of the surface, around the origin
    this.on_change = on_change;
    this.turn = new THREE.Quaternion().setFromEuler(new THREE.Euler(-0.35, 0.5, 0, "XYZ"));
    this.pointers = new Map();
    this.views = 1;
    this.show_all();
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

  // A drag over the height of the picture turns by a half.
  rotate(dx, dy) {
    const angle = Math.PI / this.element.clientHeight;
    this.turn.multiply(new THREE.Quaternion().setFromEuler(new THREE.Euler(-dy * angle, -dx * angle, 0, "XYZ"))).normalize();
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

  // Turns to a place from its outside, in a third of a second.
  fly(place, normal, size) {
    const front = new THREE.Vector3(0, 0, 1).applyQuaternion(this.turn);
    const turn = this.turn.clone().premultiply(new THREE.Quaternion().setFromUnitVectors(front, normal));
    const flight = this.flight = {
      begin: performance.now(), center: this.center.clone(), turn: this.turn.clone(), distance: this.distance,
    };
    const distance = Math.max(2e-5 * this.radius, 1.1 * size / Math.sin(half_angle));
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
