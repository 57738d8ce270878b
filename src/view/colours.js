// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours of edges, of faces, and of numbers.

"use strict";

const edge_colours = [[0, 0, 0], [0.85, 0, 0.105], [1, 1, 1]]; // input alone, result alone, both
const plain_colour = [0.60, 0.65, 0.70];
const highlight_colour = [1, 0.75, 0];
const path_colour = [0.92, 0.35, 0.0];
// Lighter than black, darker than white, and distinct in brightness as well as in hue.
const face_colours = [[0.47, 0.60, 0.72], [0.72, 0.66, 0.50], [0.55, 0.72, 0.62], [0.70, 0.56, 0.68], [0.78, 0.76, 0.74], [0.42, 0.50, 0.52]];

// From dark blue over green to yellow: brightness grows all the way, and everybody can tell blue from yellow.
const scale_colours = [[0.16, 0.10, 0.40], [0.13, 0.34, 0.56], [0.12, 0.54, 0.55], [0.42, 0.74, 0.42], [0.97, 0.90, 0.33]];
// From blue over white to red, for numbers with signs.
const diverging_colours = [[0.10, 0.24, 0.58], [0.42, 0.62, 0.84], [0.93, 0.92, 0.90], [0.89, 0.55, 0.40], [0.62, 0.10, 0.14]];
const no_number_colour = [0.5, 0.5, 0.5];

function css(colour) { return "rgb(" + colour.map(x => Math.round(255 * x)).join(",") + ")"; }

// A number for each face, from 0 to 5, that differs from those of its neighbours. An edge has two faces here.
function colour_faces(triangulation) {
  const { edge_sides, sides, number_of_faces } = triangulation;
  const colours = new Uint8Array(number_of_faces).fill(255);
  for (let f = 0; f < number_of_faces; ++f) {
    let used = 0;
    for (let s = 3 * f; s < 3 * f + 3; ++s)
      for (let i = 0; i < 2; ++i) {
        const other = Math.floor(edge_sides[2 * sides[s] + i] / 3);
        if (other !== f && other < number_of_faces && colours[other] !== 255)
          used |= 1 << colours[other];
      }
    let colour = (f * 2654435761 >>> 8) % 6;
    while (used >> colour & 1)
      colour = (colour + 1) % 6;
    colours[f] = colour;
  }
  return colours;
}
