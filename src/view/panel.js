// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The panel beside the picture, and pointing with the mouse.

"use strict";

function by_id(id) { return document.getElementById(id); }

function write_head() {
  const counts = t => [["vertex", "vertices", t.number_of_vertices], ["edge", "edges", t.number_of_edges], ["face", "faces", t.number_of_faces]]
    .map(([one, many, n]) => n.toLocaleString("en") + " " + (n === 1 ? one : many)).join(", ");
  const paragraph = text => by_id("counts").appendChild(document.createElement("p")).append(text);
  document.title = by_id("title").textContent = page.title;
  paragraph("input: " + counts(triangulations[0]));
  if (triangulations.length > 1)
    paragraph(page.result + ": " + counts(result));
  for (const element of document.querySelectorAll(".result"))
    element.hidden = triangulations.length < 2;
}

// Whether most edges are shorter than so many pixels when all of the surface is seen.
function are_edges_short(picture, limit) {
  const lengths = result.lengths.filter((_, e) => e % Math.ceil(result.number_of_edges / 10000) === 0).sort();
  return lengths[lengths.length >> 1] / page.scale < limit * picture.control.pixel;
}

function start_edges(picture) {
  const boxes = [1, 2, 3].map(label => by_id("edges-" + label));
  const show = () => {
    boxes.forEach((box, i) => (picture.shown[i] = box.checked ? 1 : 0));
    picture.request();
  };
  let is_switched = false; // by the user
  boxes.forEach(box => box.addEventListener("change", () => {
    is_switched = true;
    show();
  }));
  // By themselves they cover neither numbers nor coloured lines.
  return has_numbers => {
    if (!is_switched)
      boxes.forEach(box => (box.checked = !page.has_plane && !picture.path_field && !(has_numbers && are_edges_short(picture, 24))));
    show();
  };
}

function count_edges(picture) {
  const numbers = [0, 0, 0, 0], is_met = triangulations.map(t => new Uint8Array(t.number_of_edges));
  for (let s = 0; s < surface.sides.length; ++s) {
    const label = label_of_side(s), t = label & 2 ? 1 : 0;
    const e = label === 0 ? -1 : edge_of_side(t, s);
    if (e >= 0 && !is_met[t][e]) {
      is_met[t][e] = 1;
      ++numbers[label];
    }
  }
  const kinds = triangulations.length < 2 ? ["", "edges"] : ["", "input alone", "triangulation alone", "both"];
  for (let label = 1; label <= 3; ++label)
    by_id("edges-" + label).parentElement.lastElementChild.textContent = " " + kinds[label] + ": " + numbers[label].toLocaleString("en");
  // Where few edges differ, these are seen even if they are short.
  const strength = triangulations.length > 1 ? Math.min(1, 0.04 * numbers[3] / (numbers[2] || 1)) : 0;
  picture.uniforms.least_strength.value = [0.25 * strength, 0.5 * strength, 0];
  picture.request();
}

// A switch of something that the picture has; it is not there without a text.
function start_switch(picture, name, text, is_on = true) {
  const box = by_id(name);
  box.parentElement.hidden = !text;
  box.parentElement.lastElementChild.textContent = " " + text;
  box.checked = picture["show_" + name] = is_on;
  box.addEventListener("change", () => {
    picture["show_" + name] = box.checked;
    picture.request();
  });
}

function start_switches(picture) {
  const inserted = result.number_of_vertices - page.vertices[0], is_line = picture.path && page.arrays.path[1] > 0 && !isNaN(read_floats("path")[0]);
  start_switch(picture, "points", inserted > 0 && "inserted vertices: " + inserted.toLocaleString("en"), inserted <= 1000);
  start_switch(picture, "path", picture.path && page.path + (is_line ? ", from the white point to the orange one" : ""));
  by_id("path-legend").hidden = !picture.path_field;
  if (picture.path_field)
    picture.path_field.ends = draw_scale(by_id("path-legend"), picture.path_field, picture.path_field.scale);
  start_switch(picture, "marks", picture.places && page.marks);
  const split = is_split => {
    picture.is_split = is_split;
    by_id("left").hidden = by_id("right").hidden = !is_split;
    picture.request();
  };
  by_id("split").addEventListener("change", event => split(event.target.checked));
  by_id("left").textContent = page.has_plane ? "surface" : "input";
  by_id("right").textContent = page.has_plane ? "plane" : page.result;
  if (page.has_plane) {
    by_id("split").parentElement.hidden = false;
    by_id("split").nextSibling.textContent = " surface and plane side by side";
    split(by_id("split").checked = true);
  }
}

// Pointing at elements and looking for them.
function start_pointing(picture, legend) {
  let found = null, waiting = null, timer = 0;
  const show = element => {
    by_id("info").textContent = describe(element, legend.field);
    mark_element(picture, element);
  };
  const canvas = by_id("canvas");
  const point = (x, y) => {
    waiting = null;
    show(element_at(picture, x, y) || found);
  };
  canvas.addEventListener("pointermove", event => {
    if (picture.control.is_dragged)
      return;
    const { offsetX, offsetY } = event;
    if (picture.is_slow) { // when the mouse rests
      clearTimeout(timer);
      timer = setTimeout(() => picture.control.is_dragged || point(offsetX, offsetY), 200);
      return;
    }
    if (waiting === null)
      requestAnimationFrame(() => point(...waiting));
    waiting = [offsetX, offsetY];
  });
  canvas.addEventListener("pointerleave", () => {
    clearTimeout(timer);
    show(found);
  });
  canvas.addEventListener("keydown", event => event.key === "0" && picture.control.show_all());
  by_id("find").addEventListener("change", event => {
    clearTimeout(timer);
    by_id("not-found").textContent = "";
    found = null;
    if (event.target.value.trim() === "")
      return show(null);
    try {
      const element = find_element(event.target.value);
      fly_to(picture, element);
      show(found = element);
    } catch (error) {
      by_id("not-found").textContent = error.message;
    }
  });
}

async function start_page() {
  write_head();
  const picture = new Picture(by_id("canvas")), show_edges = start_edges(picture);
  const legend = new Legend(picture, show_edges);
  start_camera_panel(picture);
  look_at_lines(picture);
  start_switches(picture);
  by_id("save").addEventListener("click", () => save_picture(picture, legend));
  if (picture.is_slow) { // it appears before it is counted
    picture.request(true);
    await new Promise(done => requestAnimationFrame(() => setTimeout(done)));
  }
  count_edges(picture);
  start_pointing(picture, legend);
  draw_histograms(by_id("angles"), by_id("weights"));
  return picture;
}

let picture = null; // for who looks into the page with the tools of the browser
unpack().then(async () => {
  read_surface();
  picture = await start_page();
  packed = null;
}).catch(error => {
  by_id("info").textContent = error.message;
  throw error;
});
