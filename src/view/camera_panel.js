// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What stands beside the picture for its camera: which way is up, from where one looks, what is cut away, and the background.

"use strict";

const axes = ["x", "y", "z", "−x", "−y", "−z"];

function start_camera_panel(picture) {
  const { control } = picture;
  axes.forEach(axis => by_id("up").add(new Option(axis)));
  by_id("up").value = find_up(surface.places);
  by_id("up").addEventListener("change", () => control.set_up(by_id("up").value));
  Object.keys(views_of_camera).forEach(name => by_id("view").add(new Option(name)));
  by_id("view").addEventListener("change", () => {
    control.look_from(by_id("view").value);
    by_id("view").value = "";
  });
  ["nothing", ...axes].forEach(name => by_id("cut").add(new Option(name === "nothing" ? name : name, name)));
  for (const name of ["cut", "cut-at"])
    by_id(name).addEventListener("input", () => cut(picture));
  const set_theme = is_dark => {
    document.documentElement.dataset.theme = is_dark ? "dark" : "light";
    picture.request();
  };
  by_id("dark").checked = matchMedia("(prefers-color-scheme: dark)").matches;
  by_id("dark").addEventListener("change", () => set_theme(by_id("dark").checked));
  set_theme(by_id("dark").checked);
  const factors = page.stretch.flatMap((factor, i) => (factor === 1 ? [] : Number(factor.toPrecision(2)).toLocaleString("en") + " times along " + axes[i]));
  by_id("stretch").textContent = factors.length > 0 ? "It is so thin that it is stretched here, " + factors.join(", ") + "." : "";
}

// Cuts away what is beyond a place of the slider in a direction.
function cut(picture) {
  const name = by_id("cut").value, axis = axes.indexOf(name) % 3, normal = new THREE.Vector3();
  by_id("cut-at").hidden = name === "nothing";
  if (name === "nothing")
    picture.cut.set(0, 0, 0, 0);
  else {
    const [low, high] = surface.box[axis], sign = name.length > 1 ? -1 : 1, part = by_id("cut-at").value / 1000;
    normal.setComponent(axis, sign);
    picture.cut.set(normal.x, normal.y, normal.z, sign > 0 ? low + part * (high - low) : -high + part * (high - low));
  }
  picture.request();
}
