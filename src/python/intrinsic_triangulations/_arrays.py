# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Checks arguments and converts them to the array types of the extension modules.

"""Checks arguments and converts them to the array types of the extension modules."""

from __future__ import annotations

import math
import operator
import warnings
from typing import Any, Optional, Sequence, Tuple, get_args

import numpy
import scipy.sparse

from . import _core
from ._errors import InvalidArgumentError, InvalidPointError, InvalidSurfaceError

LARGEST_INDEX = 2**32 - 2


def as_array(value: Any, name: str, kinds: str, what: str) -> numpy.ndarray:
    """Returns the given array of numbers, unconverted. `kinds` are NumPy's letters for number types."""
    if numpy.ma.is_masked(value):
        raise ValueError(f"{name} has to have no masked entries: leave them out, or fill them")
    try:
        array = numpy.asarray(value)
    except Exception as error:
        raise ValueError(f"{name} has to be an array: {error}") from error
    if array.dtype.kind not in kinds and not (array.size == 0 and array.dtype.kind == "f"):
        raise ValueError(f"{name} has to contain {what}, not {array.dtype}")
    return array


def doubles(value: Any, name: str, shape: Sequence[Optional[int]]) -> numpy.ndarray:
    """Returns an array of doubles of this shape, in which None is any size. Never rounds, and copies only if
    necessary."""
    array = as_array(value, name, "iuf", "real numbers")
    check_shape(array, name, shape)
    if array.dtype == numpy.float64 and array.dtype.isnative:
        return array
    result = array.astype(numpy.float64)
    if array.dtype.itemsize >= 8 and not _are_equal(array, result):
        raise ValueError(f"{name} of type {array.dtype} has numbers that doubles cannot hold: round it first")
    return result


def finite(value: Any, name: str, shape: Sequence[Optional[int]]) -> numpy.ndarray:
    """Like doubles(), but refuses numbers that are not finite."""
    array = doubles(value, name, shape)
    is_bad = ~numpy.isfinite(array)
    if is_bad.any():
        raise ValueError(f"{name}[{int(numpy.argwhere(is_bad)[0][0])}] has to be finite, not {array[is_bad][0]}")
    return array


def _are_equal(array: numpy.ndarray, result: numpy.ndarray) -> bool:
    if array.dtype.kind in "iu":
        # Beyond it, a conversion back is undefined.
        limit = float(numpy.iinfo(array.dtype).max)
        return bool((result < limit).all() and numpy.array_equal(result.astype(array.dtype, casting="unsafe"), array))
    return bool(numpy.all((result == array) | numpy.isnan(array)))


def indices(value: Any, name: str, shape: Sequence[Optional[int]], number: Optional[int] = None,
            of_what: str = "vertex") -> numpy.ndarray:
    """Returns an array of 32-bit indices. The message about a negative or too large one names its row."""
    array = as_array(value, name, "iu", "integers")
    check_shape(array, name, shape)
    if array.size > 0:
        limit = LARGEST_INDEX if number is None else number - 1
        is_bad = (array < 0) | (array > limit) if array.dtype.kind == "i" else array > limit
        if is_bad.any():
            row = int(numpy.argwhere(is_bad)[0][0])
            bad = int(array[is_bad][0])
            message = bad_index(name, row, of_what, bad, array, limit + 1)
            if of_what == "vertex" and len(shape) == 2:
                raise InvalidSurfaceError(message, "BAD_INDEX", row, int(is_bad.any(axis=1).sum()))
            raise InvalidArgumentError(message)
    return array.astype(numpy.uint32, copy=False)


def sources(value: Any, number: int) -> numpy.ndarray:
    """Returns an array of at least one vertex."""
    result = indices(value if numpy.ndim(value) else [value], "v_inds", (None,), number)
    require_sources(len(result), "v_inds")
    return result


def require_sources(number: int, name: str) -> None:
    if number == 0:
        raise InvalidArgumentError(f"{name} is empty: give at least one source, because distances from nothing are infinite everywhere")


def bad_index(name: str, row: int, of_what: str, bad: int, array: numpy.ndarray, number: int) -> str:
    """Returns the message about a bad index in a row."""
    message = f"{name}[{row}] names {of_what} {bad}, but "
    message += "indices are not negative" if bad < 0 else f"there are only {number}, counted from 0"
    if name == "F" and array.min() == 1 and array.max() == number:
        message += "; the indices seem to count from 1: subtract 1 from each"
    return message


def check_shape(array: numpy.ndarray, name: str, shape: Sequence[Optional[int]]) -> None:
    if array.ndim != len(shape) or any(n is not None and n != m for n, m in zip(shape, array.shape)):
        wanted = ", ".join("n" if n is None else str(n) for n in shape) + ("," if len(shape) == 1 else "")
        raise ValueError(f"{name} has to have shape ({wanted}), not {array.shape}")


def points_and_faces(V: Any, F: Any) -> Tuple[numpy.ndarray, numpy.ndarray]:
    points = doubles(V, "V", (None, 3))
    if len(points) > LARGEST_INDEX:
        raise InvalidSurfaceError("there are too many vertices for 32-bit indices", "OUT_OF_RANGE", 0, 1)
    try:
        return points, indices(F, "F", (None, 3), len(points))
    except InvalidSurfaceError:
        raise
    except ValueError:
        refuse_counts(F)
        _refuse_polygons(F)
        raise


def refuse_counts(F: Any) -> None:
    """Raises if each face seems to begin with the number of its corners, as VTK has them."""
    try:
        if not isinstance(F, numpy.ndarray) and len({numpy.size(face) for face in F}) != 1:
            return
        array = numpy.asarray(F)
    except (TypeError, ValueError):
        return
    if array.dtype.kind not in "iu" or array.size == 0:
        return
    if array.ndim == 1 and 3 <= array[0] < array.size and array.size % (int(array[0]) + 1) == 0:
        rows, advice = array.reshape(-1, int(array[0]) + 1), f"F.reshape(-1, {array[0] + 1})[:, 1:]"
    elif array.ndim == 2 and array.shape[1] > 3:
        rows, advice = array, "F[:, 1:]"
    else:
        return
    count = rows.shape[1] - 1
    if len(rows) > 1 and (rows[:, 0] == count).all():
        raise InvalidSurfaceError(
            f"all {len(rows)} rows of F begin with {count}, the number of the others: leave this column out, {advice}. If vertex {count} is "
            "a corner of each face, begin one of them with another corner", "NOT_A_TRIANGLE", 0, len(rows))


def warn_of_gaps(points: numpy.ndarray, faces: numpy.ndarray) -> None:
    """Warn the caller's caller of T-junctions and of vertices that are very close."""
    for text in _core.gaps(points, faces):
        warnings.warn(text, stacklevel=3)


def _refuse_polygons(F: Any) -> None:
    """Raises if these are faces for `repair` that are not all triangles."""
    try:
        sizes = numpy.array([len(face) if numpy.ndim(face) == 1 else 3 for face in F])
    except (TypeError, ValueError):
        return
    is_bad = sizes != 3
    if is_bad.any():
        row = int(is_bad.argmax())
        raise InvalidSurfaceError(f"F[{row}] has {sizes[row]} corner{'s' if sizes[row] != 1 else ''}, not 3; repair(V, F) makes triangles of "
                                  "all faces that have an area", "NOT_A_TRIANGLE", row, int(is_bad.sum()))


def finite_points_and_faces(V: Any, F: Any) -> Tuple[numpy.ndarray, numpy.ndarray]:
    points, faces = points_and_faces(V, F)
    is_bad = ~numpy.isfinite(points).all(axis=1)
    if is_bad.any():
        raise InvalidSurfaceError(f"V[{int(is_bad.argmax())}] is not finite", "NOT_FINITE", int(is_bad.argmax()), int(is_bad.sum()))
    return points, faces


def marks(value: Any, name: str, number: int) -> Optional[numpy.ndarray]:
    """Returns an array of booleans, or None."""
    if value is None:
        return None
    array = as_array(value, name, "b", "booleans")
    check_shape(array, name, (number,))
    return array.astype(bool, copy=False)


def integer(value: Any, name: str, least: int = 0, largest: int = 2**64 - 1) -> int:
    try:
        result = operator.index(value)
    except TypeError:
        raise ValueError(f"{name} has to be an integer, not {type(value).__name__}") from None
    if not least <= result <= largest:
        raise ValueError(f"{name} has to be from {least} to {largest}, not {result}")
    return result


def vertex(value: Any, name: str, number: int) -> int:
    result = integer(value, name, -2**63, 2**64)
    if not 0 <= result < number:
        raise InvalidArgumentError(f"there is no vertex {result}: there are {number} vertices, counted from 0")
    return result


def number(value: Any, name: str) -> float:
    if isinstance(value, (str, bytes)) or numpy.iscomplexobj(value) or numpy.ndim(value) > 0:
        raise ValueError(f"{name} has to be a number, not {type(value).__name__}")
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise ValueError(f"{name} has to be a number, not {type(value).__name__}") from None


def positive(value: Any, name: str) -> float:
    result = number(value, name)
    if not (result > 0 and math.isfinite(result)):
        raise ValueError(f"{name} has to be positive and finite, not {value!r}")
    return result


def choice(value: Any, name: str, literal: Any) -> int:
    """Returns the number of a word among those of a `Literal` type."""
    choices = get_args(literal)
    if not isinstance(value, str) or value not in choices:
        raise ValueError(f"{name} has to be one of {', '.join(map(repr, choices))}, not {value!r}")
    return choices.index(value)


def vector(value: Any, name: str) -> Tuple[float, float, float]:
    """Returns three finite numbers."""
    array = doubles(value, name, (3,))
    if not numpy.isfinite(array).all():
        raise InvalidPointError(f"{name} is not finite")
    return (float(array[0]), float(array[1]), float(array[2]))


def sparse(parts: Tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray, Tuple[int, int]]) -> scipy.sparse.csc_matrix:
    """Returns the matrix that owns these arrays."""
    data, rows, columns, shape = parts
    matrix = scipy.sparse.csc_matrix((data, rows, columns), shape=shape)
    matrix.has_sorted_indices = True
    return matrix


def places(source: Any, name: str, faces: numpy.ndarray, number_of_vertices: int) -> numpy.ndarray:
    """Return rows of a triangle and barycentric coordinates."""
    array = numpy.asarray(source)
    if array.shape in ((), (2,)):
        ends = [vertex(v, name, number_of_vertices) for v in array.reshape(-1).tolist()]
        triangles = numpy.nonzero(numpy.all([(faces == v).any(axis=1) for v in ends], axis=0))[0]
        if len(triangles) == 0:
            raise ValueError(f"{name} has to name vertices of one triangle, and none has {ends}")
        return numpy.array([[triangles[0], *(faces[triangles[0]] == v)] for v in ends], dtype=float)
    if array.ndim > 2 or array.shape[-1] != 4:
        raise ValueError(f"{name} has to be an integer (a vertex), two (an edge), four numbers (a triangle and barycentric coordinates, as "
                         f"EdgeFlipGeodesicSolver(V, F).locate(point) finds them) or rows of four (a curve), and has the shape {array.shape}")
    rows = finite(source, name, array.shape).reshape(-1, 4)
    require_sources(len(rows), name)
    if not (rows[:, 0] == numpy.floor(rows[:, 0])).all():
        raise ValueError(f"{name} has to begin with the number of a triangle, and this is not whole")
    for number in rows[:, 0]:
        if not 0 <= number < len(faces):
            raise InvalidPointError(f"{name}: there is no triangle {number:.0f}: there are {len(faces)}, counted from 0")
    return rows


def numbers_and_coordinates(places: Sequence[numpy.ndarray]) -> Tuple[numpy.ndarray, numpy.ndarray]:
    """Return the triangles and the coordinates of such rows."""
    rows = numpy.concatenate(places)
    return rows[:, 0].astype(numpy.uint32), numpy.ascontiguousarray(rows[:, 1:])
