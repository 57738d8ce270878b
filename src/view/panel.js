// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The panel beside the picture, and pointing with the mouse.

"use strict";

function by_id(id) { return document.getElementById(id); }

async function start_page() {
  const picture = new Picture(by_id("canvas")), fields = find_fields();
  const counts = t => [["vertices", t.number_of_vertices], ["edges", t.number_of_edges], ["faces", t.number_of_faces]]
    .map(([name, n]) => n.toLocaleString("en") + " " + name).join(", ");
  const paragraph = text => by_id("counts").appendChild(document.createElement("p")).append(text);
  document.title = by_id("title").textContent = page.title;
  paragraph("input: " + counts(triangulations[0]));
  if (triangulations.length > 1)
    paragraph(page.result + ": " + counts(result));
  for (const element of document.querySelectorAll(".result"))
    element.hidden = triangulations.length < 2;

  // Colours and their legend.
  const select = by_id("colours");
  [...(page.has_plane ? [["checkerboard", "checkerboard"]] : []), ["each face apart", "faces"], ["one colour", "plain"], ...fields.map((field, i) => [field.name, i])]
    .forEach(([name, value]) => select.add(new Option(name, value)));
  by_id("scale").style.background = "linear-gradient(to right, " + scale_colours.map(css).join(", ") + ")";
  const set_colours = () => {
    const field = fields[select.value] || select.value, has_numbers = field.numbers !== undefined;
    by_id("legend").hidden = !has_numbers;
    if (has_numbers) {
      field.step = field.highest > field.lowest ? nice_step(field.highest - field.lowest) : 0;
      by_id("lowest").textContent = text_of(field.lowest);
      by_id("highest").textContent = text_of(field.highest);
      by_id("unit").textContent = field.unit;
      by_id("isolines").parentElement.hidden = field.of_faces || !field.step;
      by_id("step").textContent = "isolines, one each " + text_of(field.step);
    }
    picture.set_colours(field, by_id("isolines").checked);
  };
  select.value = page.has_plane ? "checkerboard" : page.fields.length > 0 && fields.length > 1 ? "0" : "faces";
  select.addEventListener("change", set_colours);
  by_id("isolines").addEventListener("change", set_colours);
  set_colours();

  // A large surface appears before it is counted.
  if (picture.is_slow) {
    picture.request(true);
    await new Promise(done => requestAnimationFrame(() => setTimeout(done)));
  }

  // Edges, points and lines, each with its number.
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
  for (let label = 1; label <= 3; ++label) {
    const box = by_id("edges-" + label);
    box.parentElement.lastElementChild.textContent = " " + kinds[label] + ": " + numbers[label].toLocaleString("en");
    box.addEventListener("change", () => {
      picture.shown[label - 1] = box.checked ? 1 : 0;
      picture.request();
    });
  }
  const number_of_points = result.number_of_vertices - page.vertices[0];
  by_id("points-label").hidden = number_of_points === 0;
  by_id("points-label").lastElementChild.textContent = " inserted vertices: " + number_of_points.toLocaleString("en");
  by_id("points").addEventListener("change", event => {
    picture.show_points = event.target.checked;
    picture.request();
  });
  by_id("path-label").hidden = !picture.path;
  by_id("path-label").lastElementChild.textContent = " " + page.path;
  by_id("path").addEventListener("change", event => {
    picture.show_path = event.target.checked;
    picture.request();
  });
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
    by_id("split").checked = true;
    for (const label of [1, 2, 3])
      by_id("edges-" + label).checked = picture.shown[label - 1] = 0;
    split(true);
  }

  // Pointing at elements and looking for them.
  let found = null, waiting = null, timer = 0;
  const show = element => {
    by_id("info").textContent = describe(element);
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
