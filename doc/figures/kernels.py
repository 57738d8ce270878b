# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What number types make of the built-in surfaces: right or wrong, and how long it takes."""

import numpy as np
from matplotlib import pyplot
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch

OUTCOMES = [("right", "0.88"), ("wrong, and says so", "orange"), ("wrong, unnoticed", (0.85, 0.05, 0.05)),
            ("no result", "0.25")]


def _outcome(entry):
    """The index in OUTCOMES, as the command counts them itself."""
    if not entry["ended"]:
        return 3
    if not (entry["not_delaunay"] or entry["inverted_faces"] or entry["missing_edges"]):
        return 0
    return 2 if entry["status"] == "done" else 1


def comparison(report):
    """From the JSON report of `idt compare`: a table of outcomes, and the times beside it."""
    surfaces = report["surfaces"]
    types = [entry["number_type"] + (f", {entry['precision']} bits" if entry["precision"] else "")
             for entry in surfaces[0]["number_types"]]
    outcomes = np.array([[_outcome(entry) for entry in surface["number_types"]] for surface in surfaces]).T
    page, (left, right) = pyplot.subplots(1, 2, figsize=(9.6, 4.6), sharey=True, layout="constrained",
                                          width_ratios=[3, 2])
    left.imshow(outcomes, ListedColormap([color for _, color in OUTCOMES]), vmin=-0.5, vmax=3.5, aspect="auto")
    names = [surface["surface"].rsplit(".", 1)[0] for surface in surfaces]
    left.set_xticks(range(len(names)), names, rotation=50, ha="right", rotation_mode="anchor", fontsize=8)
    left.set_yticks(range(len(types)), types)
    left.set_xticks(np.arange(len(names) - 1) + 0.5, minor=True)
    left.set_yticks(np.arange(len(types) - 1) + 0.5, minor=True)
    left.grid(which="minor", color="white", linewidth=2)
    left.tick_params(which="both", length=0)
    left.legend([Patch(color=color) for _, color in OUTCOMES], [name for name, _ in OUTCOMES],
                loc="lower left", bbox_to_anchor=(0, 1), ncol=len(OUTCOMES), frameon=False,
                handlelength=1, columnspacing=1, borderaxespad=0.2)
    for row in range(len(types)):
        ratios = [entry["ratio_to_double"] for entry in (s["number_types"][row] for s in surfaces)
                  if entry["ratio_to_double"] is not None]
        right.plot(ratios, [row] * len(ratios), "o", color="0.45", markersize=4, markeredgewidth=0, alpha=0.7)
        right.plot(np.median(ratios), row, "|", color="black", markersize=16, markeredgewidth=2)
    right.set_xscale("log")
    right.grid(axis="x", color="0.9")
    right.set_title("time / time in double, with the median")
    right.tick_params(axis="y", length=0)
    return page
