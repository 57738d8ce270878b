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
from typing import Callable, Dict, Iterator, Optional, Union

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


Values = Union[ArrayLike, Dict[str, ArrayLike], None]


def view(V: ArrayLike, F: ArrayLike, values: Values = None) -> Page:
    """Return a page that shows triangles, and their intrinsic Delaunay triangulation if they are a surface.

    Parameters
    ----------
    V, F
        As for `Triangulation`, or any triangles.
    values : (n,) array, or a dictionary of named ones, or None
        Numbers at the vertices or on the faces, which color the surface. What is NaN or masked is gray.

    Returns
    -------
    Page

    Raises
    ------
    InvalidSurfaceError
        If a face names no vertex, or a coordinate is not finite.
    Error
        If the command `idt`, which writes the page, is not found; the environment variable IDT_COMMAND can name it.

    Examples
    --------
    >>> import intrinsic_triangulations as it
    >>> V, F = [[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]], [[0, 1, 2], [1, 0, 3]]
    >>> page = it.view(V, F, [0, 1, 2, 3])  # doctest: +SKIP
    >>> page.save("kite.html")  # doctest: +SKIP
    """
    points, faces = _arrays.finite_points_and_faces(V, F)

    def write(path: str) -> None:
        with open(path, "w", encoding="ascii") as file:
            file.write(f"OFF\n{len(points)} {len(faces)} 0\n")
            numpy.savetxt(file, points, "%.17g")
            numpy.savetxt(file, faces, "3 %d %d %d")
    return _write_page("surface.off", write, values, len(points), len(faces))


def find_command() -> Optional[str]:
    """Returns the command `idt`: that of the environment, of this package, or of PATH."""
    return os.environ.get("IDT_COMMAND") or shutil.which("idt", path=os.path.dirname(__file__)) or shutil.which("idt")


def page_of(triangulation: Triangulation, values: Values) -> Page:
    """Returns the page of a triangulation."""
    if triangulation._points is None:
        raise ValueError("the surface is given by lengths: it has no picture")
    number = len(triangulation._points)
    # Flips keep the number of faces.
    faces = triangulation.number_of_faces if triangulation.number_of_vertices == number else None
    return _write_page("surface.idt", triangulation.save, values, number, faces)


def _write_page(name: str, write: Callable[[str], None], values: Values, vertices: int, faces: Optional[int]) -> Page:
    """Writes the surface to a file of this name, and lets the command make its page."""
    command = find_command()
    if command is None:
        raise Error("there is no command idt, which writes pages: wheels contain it, and scripts/demo in a checkout builds it as "
                    "build/command/bin/idt; put it into PATH, or name it by the environment variable IDT_COMMAND")
    with tempfile.TemporaryDirectory() as folder:
        surface, page = (os.path.join(folder, part) for part in (name, "page.html"))
        call = [command, "view", surface, "-o", page, *_tables(values, vertices, faces, folder)]
        write(surface)
        run = subprocess.run(call, capture_output=True, text=True, errors="replace", check=False)
        if run.returncode != 0:
            raise Error(f"{command}: {run.stderr.strip()}")
        return Page(pathlib.Path(page).read_text(encoding="utf-8"))


def _tables(values: Values, vertices: int, faces: Optional[int], folder: str) -> Iterator[str]:
    """Writes the values to tables, and yields the options that name them."""
    columns = {} if values is None else values if isinstance(values, dict) else {"values": values}
    for i, (name, column) in enumerate(columns.items()):
        if set(name) & set(',"\r\n'):
            raise ValueError("names of values have no commas, quotes or line breaks")
        if numpy.ma.is_masked(column):
            column = numpy.ma.filled(column.astype(float), numpy.nan)
        is_of_faces = numpy.shape(column) == (faces,) and faces != vertices
        if numpy.asarray(column).dtype == bool:
            column = numpy.asarray(column, dtype=float)
        array = _arrays.doubles(column, name, (faces if is_of_faces else vertices,))
        path = os.path.join(folder, f"values-{i}.csv")
        numpy.savetxt(path, numpy.column_stack([numpy.arange(len(array)), array]), "%.17g", ",",
                      header=f"{'face' if is_of_faces else 'vertex'},{name}", comments="")
        yield from ("--values", path)
