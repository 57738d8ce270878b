# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Pages that show surfaces; the command writes them.

"""Pages that show surfaces in a browser or a notebook."""

from __future__ import annotations

import html
import os
import pathlib
import shutil
import subprocess
import tempfile
import webbrowser
from typing import Dict, Optional, Union

import numpy
from numpy.typing import ArrayLike

from . import _arrays
from ._errors import Error
from ._triangulation import Triangulation


class Page:
    """A self-contained HTML page that shows a surface, as `view` and `Triangulation.show` return it.

    A notebook shows it if it is the last value of a cell.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        """The page."""

    def save(self, path: Union[str, os.PathLike]) -> None:
        """Write the page to a file that any browser can open."""
        pathlib.Path(path).write_text(self.text, encoding="utf-8")

    def open(self) -> str:
        """Open the page in a browser, and return the name of its file, which is kept."""
        with tempfile.NamedTemporaryFile("w", suffix=".html", prefix="surface-", delete=False, encoding="utf-8") as file:
            file.write(self.text)
        webbrowser.open(pathlib.Path(file.name).as_uri())
        return file.name

    def _repr_html_(self) -> str:
        return f'<iframe srcdoc="{html.escape(self.text)}" width="100%" height="600" style="border: 0"></iframe>'

    def __repr__(self) -> str:
        return f"<Page: {len(self.text)} characters>"


def view(V: ArrayLike, F: ArrayLike, values: Union[ArrayLike, Dict[str, ArrayLike], None] = None) -> Page:
    """Return a page that shows a surface and its intrinsic Delaunay triangulation.

    Parameters
    ----------
    V, F
        As for `Triangulation`.
    values : (n,) array, or a dictionary of named ones, or None
        Numbers at the vertices, which color the surface.

    Returns
    -------
    Page

    Raises
    ------
    InvalidSurfaceError
        As `Triangulation`.
    Error
        If the command `idt`, which writes the page, is not found; the environment variable IDT_COMMAND can name it.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> V, F = [[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]], [[0, 1, 2], [1, 0, 3]]
    >>> page = it.view(V, F, [0, 1, 2, 3])  # doctest: +SKIP
    >>> page.save("kite.html")  # doctest: +SKIP
    """
    triangulation = Triangulation(V, F)
    triangulation.flip_to_delaunay()
    return page_of(triangulation, values)


def find_command() -> Optional[str]:
    """Returns the command `idt`: that of the environment, of this package, or of PATH."""
    return os.environ.get("IDT_COMMAND") or shutil.which("idt", path=os.path.dirname(__file__)) or shutil.which("idt")


def page_of(triangulation: Triangulation, values: Union[ArrayLike, Dict[str, ArrayLike], None]) -> Page:
    """Returns the page of a triangulation."""
    if triangulation._points is None:
        raise ValueError("the surface is given by lengths: it has no picture")
    command = find_command()
    if command is None:
        raise Error("there is no command idt, which writes pages: wheels contain it, and scripts/demo in a checkout builds it as "
                    "build/command/bin/idt; put it into PATH, or name it by the environment variable IDT_COMMAND")
    number = len(triangulation._points)
    columns = {} if values is None else values if isinstance(values, dict) else {"values": values}
    with tempfile.TemporaryDirectory() as folder:
        surface, page, table = (os.path.join(folder, name) for name in ("surface.idt", "page.html", "values.csv"))
        triangulation.save(surface)
        call = [command, "view", surface, "-o", page]
        if any(set(name) & set(',"\r\n') for name in columns):
            raise ValueError("names of values have no commas, quotes or line breaks")
        if columns:
            arrays = [_arrays.finite(column, name, (number,)) for name, column in columns.items()]
            rows = numpy.column_stack([numpy.arange(number), *arrays])
            numpy.savetxt(table, rows, "%.17g", ",", header=",".join(["vertex", *columns]), comments="")
            call += ["--values", table]
        run = subprocess.run(call, capture_output=True, text=True, errors="replace", check=False)
        if run.returncode != 0:
            raise Error(f"{command}: {run.stderr.strip()}")
        return Page(pathlib.Path(page).read_text(encoding="utf-8"))
