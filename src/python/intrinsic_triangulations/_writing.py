# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Writes meshes to files, and reads the texture coordinates of OBJ files.

"""Writes meshes to files, and reads the texture coordinates of OBJ files."""

from __future__ import annotations

import os
from typing import Any, Dict, Iterator, List, Optional, Tuple, Union

import numpy
from numpy.typing import ArrayLike

from . import _arrays
from ._errors import InvalidFileError

_FORMATS = (".off", ".obj", ".ply", ".stl")


def write_mesh(V: ArrayLike, F: ArrayLike, file_name: Union[str, "os.PathLike[str]"], *, uv: Optional[ArrayLike] = None,
               values: Optional[Dict[str, ArrayLike]] = None) -> None:
    """Write triangles to an OFF, OBJ, PLY or STL file, so that `read_mesh` returns the same numbers.

    PLY files are binary; the others are text. O(size).

    Parameters
    ----------
    V : (n, 3) array of integers or floats
        The positions of the vertices.
    F : (m, 3) array of integers
        The corners of the triangles, counted from 0.
    file_name : str or path
        The extension determines the format.
    uv : (m, 3, 2) array of integers or floats, optional
        The texture coordinates at the corners, in OBJ files; NaN where there are none. With seams, they differ at a vertex.
    values : dictionary of (n,) arrays, optional
        Numbers at the vertices, in PLY files; their names have no blanks.

    Raises
    ------
    InvalidSurfaceError
        If an index is out of range, or a coordinate is not finite.
    OSError
        If the file cannot be written.

    Examples
    --------
    >>> import intrinsic_triangulations as it, os, tempfile
    >>> V, F = [[0, 0, 0], [1, 0, 0], [0, 1, 0.1]], [[0, 1, 2]]
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     it.write_mesh(V, F, os.path.join(folder, "triangle.ply"))
    ...     it.read_mesh(os.path.join(folder, "triangle.ply"))[0].tolist() == V
    True
    """
    path = os.fspath(file_name)
    extension = os.path.splitext(path)[1].lower()
    if extension not in _FORMATS:
        raise ValueError(f"file_name has to end with {', '.join(_FORMATS[:-1])} or {_FORMATS[-1]}, not {extension!r}")
    if uv is not None and extension != ".obj":
        raise ValueError("file_name has to end with .obj, the format that holds uv")
    if values is not None and extension != ".ply":
        raise ValueError("file_name has to end with .ply, the format that holds values")
    points, faces = _arrays.finite_points_and_faces(V, F)
    columns = {name: _arrays.doubles(column, name, (len(points),)) for name, column in (values or {}).items()}
    if any(len(name.split()) != 1 for name in columns):
        raise ValueError("names of values have to be words without blanks")
    if taken := [name for name in columns if name.lower() in ("x", "y", "z")]:
        raise ValueError(f"{taken[0]!r} is the name of a coordinate: choose another one for the values")
    corners = None if uv is None else _arrays.doubles(uv, "uv", (len(faces), 3, 2))
    with open(path, "wb") as file:
        if extension == ".ply":
            _write_ply(file, points, faces, columns)
        else:
            lines = {".off": _off_lines, ".obj": _obj_lines, ".stl": _stl_lines}[extension](points, faces, corners)
            file.writelines(line.encode("ascii") for line in lines)


def _rows(words: str, rows: numpy.ndarray) -> Iterator[str]:
    return (words % tuple(row) for row in rows.tolist())


def _off_lines(points: numpy.ndarray, faces: numpy.ndarray, _: Any) -> Iterator[str]:
    yield f"OFF\n{len(points)} {len(faces)} 0\n"
    yield from _rows("%.17g %.17g %.17g\n", points)
    yield from _rows("3 %d %d %d\n", faces)


def _obj_lines(points: numpy.ndarray, faces: numpy.ndarray, uv: Optional[numpy.ndarray]) -> Iterator[str]:
    yield from _rows("v %.17g %.17g %.17g\n", points)
    if uv is None:
        yield from _rows("f %d %d %d\n", faces.astype(numpy.int64) + 1)
        return
    # Corners share what is the same.
    has_uv = numpy.isfinite(uv).all(axis=2)
    different, number = numpy.unique(uv[has_uv], axis=0, return_inverse=True)
    yield from _rows("vt %.17g %.17g\n", different)
    of_corner = numpy.zeros(faces.shape, dtype=numpy.int64)
    of_corner[has_uv] = number.ravel() + 1
    for corners, numbers in zip((faces.astype(numpy.int64) + 1).tolist(), of_corner.tolist()):
        yield "f " + " ".join(f"{v}/{t}" if t else str(v) for v, t in zip(corners, numbers)) + "\n"


def _stl_lines(points: numpy.ndarray, faces: numpy.ndarray, _: Any) -> Iterator[str]:
    yield "solid\n"
    corner = "vertex %.17g %.17g %.17g\n"
    yield from _rows("facet normal 0 0 0\nouter loop\n" + 3 * corner + "endloop\nendfacet\n", points[faces].reshape(-1, 9))
    yield "endsolid\n"


def _write_ply(file: Any, points: numpy.ndarray, faces: numpy.ndarray, columns: Dict[str, numpy.ndarray]) -> None:
    names = ["x", "y", "z", *columns]
    header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
    header += "".join(f"property double {name}\n" for name in names)
    header += f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    file.write(header.encode("utf-8"))
    file.write(numpy.column_stack([points, *columns.values()]).astype("<f8").tobytes())
    rows = numpy.empty(len(faces), dtype=[("size", "u1"), ("corners", "<i4", (3,))])
    rows["size"], rows["corners"] = 3, faces
    file.write(rows.tobytes())


def texture_of_obj(path: str, number_of_corners: int) -> Tuple[numpy.ndarray, numpy.ndarray]:
    """Returns the texture coordinates of a readable OBJ file, and their numbers at all corners in order; -1 for none."""
    uv: List[List[bytes]] = []
    corners: List[int] = []
    with open(path, "rb") as file:
        for words in _obj_words(file):
            keyword = words[0].lower()
            if keyword == b"vt":
                uv.append((words[1:3] + [b"0"])[:2])
            elif keyword == b"f":
                for word in words[1:]:
                    parts = word.split(b"/")
                    number = int(parts[1]) if len(parts) > 1 and parts[1] else 0
                    corners.append(number - 1 if number >= 0 else len(uv) + number)
    try:
        result = numpy.array(uv, dtype=numpy.float64).reshape(-1, 2)
    except ValueError as error:
        raise InvalidFileError(f"{path}: a texture coordinate is not a number: {error}", "UNREADABLE", 0, 1, path) from None
    numbers = numpy.array(corners, dtype=numpy.int64)
    is_bad = (numbers < -1) | (numbers >= len(result))
    if is_bad.any() or len(numbers) != number_of_corners:
        which = int(is_bad.argmax()) if is_bad.any() else len(numbers)
        raise InvalidFileError(f"{path}: corner {which} of the faces, counted from 0, names a texture coordinate that does not exist",
                               "BAD_INDEX", which, int(is_bad.sum()), path)
    return result, numbers


def _obj_words(file: Any) -> Iterator[List[bytes]]:
    """Yields the words of each line, without comments; a line that ends with a backslash goes on."""
    before = b""
    for line in file:
        line = (before + line).rstrip()
        before = b""
        if line.endswith(b"\\"):
            before = line[:-1] + b" "
            continue
        words = line.split(b"#", 1)[0].split()
        if words:
            yield words
