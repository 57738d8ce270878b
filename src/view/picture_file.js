// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The picture with its legend as a file.

"use strict";

// A canvas of the size of the picture.
function copy_picture(picture, legend) {
  picture.draw();
  const from = picture.canvas, copy = document.createElement("canvas"), context = copy.getContext("2d"), ratio = from.width / from.clientWidth;
  [copy.width, copy.height] = [from.width, from.height];
  context.drawImage(from, 0, 0);
  if (!legend.has_numbers)
    return copy;
  context.scale(ratio, ratio);
  const colour = getComputedStyle(document.body).color, [x, y, w] = [16, from.clientHeight - 34, 260];
  const gradient = context.createLinearGradient(x, 0, x + w, 0), { colours } = legend.scale;
  colours.forEach((c, i) => gradient.addColorStop(i / (colours.length - 1), css(c)));
  context.fillStyle = gradient;
  context.fillRect(x, y, w, 10);
  context.fillStyle = colour;
  context.font = "12px system-ui, sans-serif";
  context.fillText(legend.field.name, x, y - 6);
  legend.ends.forEach((text, i) => {
    context.textAlign = ["left", "center", "right"][i];
    context.fillText(text, x + i * w / 2, y + 24);
  });
  return copy;
}

function save_picture(picture, legend) {
  copy_picture(picture, legend).toBlob(blob => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = page.title.replace(/\.[^.]*$/, "") + ".png";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  });
}
