// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Angles and weights of both triangulations as bars.

"use strict";

// The fraction of the numbers in each interval; the first and the last one include everything beyond.
function count_intervals(numbers, low, high, n) {
  const counts = new Array(n).fill(0);
  let total = 0;
  for (let i = 0; i < numbers.length; ++i) {
    const x = numbers[i];
    if (!Number.isNaN(x)) {
      ++counts[Math.min(n - 1, Math.max(0, Math.floor((x - low) / (high - low) * n)))];
      ++total;
    }
  }
  return counts.map(count => count / Math.max(1, total));
}

// \param all numbers of each triangulation
function draw_histogram(element, all, low, high, n, ticks) {
  const parts = all.map(numbers => count_intervals(numbers, low, high, n)), top = Math.max(...parts.flat()) || 1;
  const w = 288, h = 102, above = 12, x = i => (i * w) / n, y = part => above + (h - above) * (1 - part / top);
  const bars = parts[0].map((part, i) => `<rect class="before" x="${x(i)}" y="${y(part)}" width="${w / n - 0.5}" height="${h - y(part)}"/>`);
  const outline = parts.length < 2 ? "" :
    `<path class="after" d="M0 ${h}${parts[1].map((part, i) => `V${y(part).toFixed(1)}H${x(i + 1).toFixed(1)}`).join("")}V${h}"/>`;
  const texts = ticks.map(([value, text]) => {
    const at = (value - low) / (high - low) * w;
    return `<text x="${at}" y="${h + 13}" text-anchor="${at < 9 ? "start" : at > w - 9 ? "end" : "middle"}">${text}</text>`;
  });
  element.innerHTML = `<svg viewBox="0 0 ${w} ${h + 16}"><text x="${w}" y="9" text-anchor="end">${(100 * top).toFixed(1)} %</text>` +
    bars.join("") + outline + texts.join("") + "</svg>";
}

function all_angles(t) { return t.cotangents.map(c => Math.atan2(1, c) * 180 / Math.PI); }

// Border edges have only one angle, and are not counted.
function inner_weights(t) {
  const weights = new Float32Array(t.number_of_edges);
  let n = 0;
  for (let e = 0; e < t.number_of_edges; ++e)
    if (t.counts[e] > 1)
      weights[n++] = t.weights[e];
  return weights.subarray(0, n);
}

function draw_histograms(angle_element, weight_element) {
  const least = numbers => numbers.reduce((least, x) => (x < least ? x : least), Infinity);
  const line = (element, texts) => element.insertAdjacentHTML("beforeend", "<p>" + texts.join(" → ") + "</p>");
  const angles = triangulations.map(all_angles), weights = triangulations.map(inner_weights);
  draw_histogram(angle_element, angles, 0, 180, 36, [0, 30, 60, 90, 120, 150, 180].map(x => [x, x]));
  line(angle_element, angles.map((numbers, i) => (i === 0 ? "smallest: " : "") + text_of(least(numbers), "°")));
  draw_histogram(weight_element, weights, -1, 4, 30, [[-1, "≤ −1"], [0, "0"], [1, "1"], [2, "2"], [3, "3"], [4, "≥ 4"]]);
  line(weight_element, weights.map((numbers, i) => (i === 0 ? "negative: " : "") + numbers.filter(x => x < 0).length));
}
