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
  context.scale(ratio, ratio);
  const { path_field } = picture, y = from.clientHeight - 34;
  if (legend.has_numbers)
    copy_legend(context, 16, y, legend.scale, legend.field.name, legend.ends);
  if (path_field && picture.show_path)
    copy_legend(context, legend.has_numbers ? 316 : 16, y, path_field.scale, path_field.unit, path_field.ends);
  return copy;
}

function copy_legend(context, x, y, { colours }, name, ends) {
  const colour = getComputedStyle(document.body).color, w = 260, gradient = context.createLinearGradient(x, 0, x + w, 0);
  colours.forEach((c, i) => gradient.addColorStop(i / (colours.length - 1), css(c)));
  context.fillStyle = gradient;
  context.fillRect(x, y, w, 10);
  context.fillStyle = colour;
  context.font = "12px system-ui, sans-serif";
  context.textAlign = "left";
  context.fillText(name, x, y - 6);
  ends.forEach((text, i) => {
    context.textAlign = ["left", "center", "right"][i];
    context.fillText(text, x + i * w / 2, y + 24);
  });
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
