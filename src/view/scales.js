// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How numbers become colours: a scale takes them to the numbers from 0 to 1.

"use strict";

const no_place = -1e30; // of what has no number; everything below -1e6 is gray

// Finite numbers of a field in increasing order; not all of them if there are many.
function sample_of(field) {
  const sample = [];
  for (const numbers of field.numbers)
    for (let i = 0, step = Math.ceil(numbers.length / 30000); i < numbers.length; i += step)
      if (isFinite(numbers[i]))
        sample.push(numbers[i]);
  return Float64Array.from(sample).sort();
}

// Which one tells most: all but a few numbers would have almost the same colour on others.
function best_scale(field) {
  const sample = sample_of(field), at = part => sample[Math.round(part * (sample.length - 1))];
  const { lowest, highest } = field;
  if (field.is_constant)
    return "linear";
  if (lowest > 0 && at(0.5) - lowest < 0.1 * (highest - lowest) && at(0.9) > 10 * at(0.1))
    return "logarithmic";
  return at(0.99) > at(0.01) && highest - lowest > 3 * (at(0.99) - at(0.01)) ? "without extremes" : "linear";
}

// \param kind "linear", "without extremes" or "logarithmic"
function make_scale(field, kind) {
  const is_log = kind === "logarithmic", f = is_log ? Math.log : x => x;
  let low = is_log ? field.least_positive : field.lowest, high = field.highest;
  const sample = is_log ? sample_of(field).filter(x => x > 0) : sample_of(field);
  const inner = [0.01, 0.99].map(part => sample[Math.round(part * (sample.length - 1))]);
  if (inner[1] > inner[0] && (kind === "without extremes" || is_log && f(high) - f(low) > 3 * (f(inner[1]) - f(inner[0]))))
    [low, high] = inner;
  const is_signed = low < 0 && high > 0 && Math.min(-low, high) > 0.05 * Math.max(-low, high);
  if (is_signed) // zero is in the middle
    low = -(high = Math.max(-low, high));
  const range = f(high) - f(low), is_flat = field.is_constant || !(range > 0);
  const place = x => (isFinite(x) && !(is_log && x <= 0) ? is_flat ? 0.5 : Math.max(-1e5, (f(x) - f(low)) / range) : no_place);
  return {
    low, high, is_flat, is_log, place, colours: is_signed ? diverging_colours : scale_colours,
    middle: is_log ? Math.sqrt(low) * Math.sqrt(high) : low / 2 + high / 2,
    ...isolines_of(is_flat, is_log, f(low), range),
  };
}

// Their step, in words and on the scale, and where one of them is.
function isolines_of(is_flat, is_log, low, range) {
  if (is_flat)
    return { step: 0 };
  const factor = is_log ? [2, 5, 10, 100, 1e3, 1e6, 1e12, 1e24, 1e48].find(x => range / Math.log(x) <= 20) : 0;
  const step = is_log ? Math.log(factor) : nice_step(range);
  return { step: step / range, origin: -low / range, isolines: is_log ? "isolines, each " + factor + " times the one before" : "isolines, one each " + text_of(step) };
}

// A step of one, two or five units of some decimal place, so that there are 8 to 20 in the range.
function nice_step(range) {
  const unit = 10 ** Math.floor(Math.log10(range / 20));
  return unit * [1, 2, 5, 10].find(x => x * unit >= range / 20 * 0.999);
}
