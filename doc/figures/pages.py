# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts panels on a page and writes it as a small PNG file."""

import io

import matplotlib
from PIL import Image

matplotlib.use("Agg")
matplotlib.rcParams.update({"font.family": "DejaVu Sans", "font.size": 10, "axes.titlesize": 10})
from matplotlib import pyplot  # noqa: E402, after the choice of what draws

DOTS_PER_INCH = 100


def page_of_images(images, titles, columns):
    """A page with images of the same size, pixel by pixel, under their titles."""
    rows = -(-len(images) // columns)
    height, width = (n / DOTS_PER_INCH for n in images[0].shape[:2])
    title_height, bottom, gap = 0.36, 0.4, 0.1
    page_width = columns * (width + gap) - gap
    page_height = rows * (height + title_height) + bottom
    page = pyplot.figure(figsize=(page_width, page_height))
    for i, (image, title) in enumerate(zip(images, titles)):
        left = (i % columns) * (width + gap)
        top = (i // columns) * (height + title_height) + title_height
        axes = page.add_axes([left / page_width, 1 - (top + height) / page_height,
                              width / page_width, height / page_height])
        axes.imshow(image, interpolation="none")
        axes.set_axis_off()
        axes.set_title(title)
    return page


def save(page, path, colors):
    """Writes the page with a palette of that many colors; the same page gives the same file."""
    buffer = io.BytesIO()
    page.savefig(buffer, dpi=DOTS_PER_INCH, facecolor="white")
    pyplot.close(page)
    image = Image.open(buffer).convert("RGB")
    # The octree keeps colors of few pixels, such as those of lines.
    image = image.quantize(colors, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    image.save(path, optimize=True)
    print(f"{path}: {path.stat().st_size // 1000} kB")
