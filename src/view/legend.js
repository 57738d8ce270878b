// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The choice of colours, and what they mean.

"use strict";

// The bar in `box`, three numbers and the unit. Returns the texts of the numbers.
function draw_scale(box, field, scale) {
  box.querySelector(".scale").style.background = "linear-gradient(to right, " + scale.colours.map(css).join(", ") + ")";
  const bound = (x, sign, is_beyond) => (is_beyond ? sign + " " : "") + text_of(x);
  const ends = scale.is_flat ? ["", text_of(field.lowest), ""]
    : [bound(scale.low, "≤", field.lowest < scale.low), text_of(scale.middle), bound(scale.high, "≥", field.highest > scale.high)];
  box.querySelectorAll(".ends span").forEach((span, i) => (span.textContent = ends[i]));
  box.querySelector("p").textContent = field.unit;
  return ends;
}

class Legend {
  // \param on_change is called after a choice, with whether there are numbers
  constructor(picture, on_change) {
    this.picture = picture;
    this.fields = find_fields();
    this.on_change = on_change;
    const names = [...(page.has_plane ? [["checkerboard", "checkerboard"]] : []), ["each face apart", "faces"], ["one colour", "plain"]];
    [...names, ...this.fields.map((field, i) => [field.name, i])].forEach(([name, value]) => by_id("colours").add(new Option(name, value)));
    ["linear", "without extremes", "logarithmic"].forEach(kind => by_id("scale-kind").add(new Option(kind)));
    // First what tells something: not a constant eigenfunction.
    const own = this.fields.slice(0, -1), first = Math.max(0, own.findIndex(field => !field.is_constant));
    by_id("colours").value = page.has_plane ? "checkerboard" : own.length > 0 ? first : picture.path || are_edges_short(picture, 12) ? "plain" : "faces";
    by_id("isolines").checked = !/isolines/.test(page.path); // those asked for are there
    by_id("colours").addEventListener("change", () => this.choose());
    by_id("scale-kind").addEventListener("change", () => this.show(by_id("scale-kind").value));
    by_id("isolines").addEventListener("change", () => this.show(by_id("scale-kind").value));
    this.choose();
  }

  get has_numbers() { return this.field.numbers !== undefined; }

  choose() {
    this.field = this.fields[by_id("colours").value] || by_id("colours").value;
    by_id("legend").hidden = !this.has_numbers;
    if (this.has_numbers) {
      by_id("scale-kind").options[2].disabled = this.field.least_positive === Infinity;
      this.show(by_id("scale-kind").value = best_scale(this.field));
    } else
      this.picture.set_colours(this.field);
    this.on_change(this.has_numbers);
  }

  show(kind) {
    const { field } = this, scale = this.scale = make_scale(field, kind);
    this.ends = draw_scale(by_id("legend"), field, scale);
    by_id("isolines").parentElement.hidden = field.of_faces || !scale.step;
    by_id("step").textContent = scale.isolines || "";
    by_id("note").textContent = this.notes(scale).join("\n");
    this.picture.set_colours(field, scale, by_id("isolines").checked);
  }

  // What the colours do not tell.
  notes(scale) {
    const { lowest, highest, missing, infinite, of_faces } = this.field, notes = [];
    const [one, many] = of_faces ? ["face", "faces"] : ["vertex", "vertices"], where = n => n.toLocaleString("en") + " " + (n === 1 ? one : many);
    if (!scale.is_flat && (lowest !== scale.low || highest !== scale.high))
      notes.push("all numbers: " + text_of(lowest) + " to " + text_of(highest));
    if (missing > 0)
      notes.push("gray: no number at " + where(missing));
    if (infinite > 0)
      notes.push("gray: infinite at " + where(infinite));
    if (scale.is_log && lowest <= 0)
      notes.push("gray: not positive, so there is no logarithm");
    return notes;
  }
}
