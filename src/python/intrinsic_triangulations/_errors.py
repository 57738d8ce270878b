# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# The exceptions of the package.

"""The exceptions of the package."""

from __future__ import annotations

import contextlib
from typing import Any, Iterator, Optional


class Error(Exception):
    """The base of all exceptions of the library. Each subclass is also a built-in one, such as `ValueError`."""


class InvalidSurfaceError(Error, ValueError):
    """The input is not a surface with a metric. The message names the first offending element.

    Attributes
    ----------
    defect : str
        The kind of defect: one of ``EMPTY``, ``BAD_INDEX``, ``NOT_A_TRIANGLE``, ``REPEATED_CORNER``,
        ``DUPLICATE_FACE``, ``NON_MANIFOLD_EDGE``, ``INCONSISTENT_ORIENTATION``, ``NON_MANIFOLD_VERTEX``,
        ``INVALID_GLUING``, ``NOT_FINITE``, ``OUT_OF_RANGE``, ``ZERO_LENGTH_EDGE``, ``TRIANGLE_INEQUALITY``,
        ``DEGENERATE_FACE``, ``WRONG_TOPOLOGY``, ``UNREADABLE``.
    element : int
        The number of the first offending vertex, edge or face, as in the message.
    count : int
        The number of offending elements.
    """

    def __init__(self, message: str, defect: str, element: int, count: int) -> None:
        super().__init__(message, defect, element, count)
        self.defect = defect
        self.element = element
        self.count = count

    def __str__(self) -> str:
        return str(self.args[0])


class FileError(Error, OSError):
    """A file cannot be read or written. `filename` is its name, and `errno` the number of the system's error, if it was one."""

    def __init__(self, message: str, filename: Any, errno: Optional[int] = None) -> None:
        super().__init__(message, filename, errno)
        self.filename, self.errno = filename, errno

    def __str__(self) -> str:
        return str(self.args[0])


class InvalidFileError(InvalidSurfaceError, FileError):
    """A file cannot be read. If there is no such file, this is a `FileNotFoundError`, too, and so on."""

    def __init__(self, message: str, defect: str, element: int, count: int, filename: Any = None, errno: Optional[int] = None) -> None:
        Exception.__init__(self, message, defect, element, count, filename, errno)
        self.defect, self.element, self.count = defect, element, count
        self.filename, self.errno = filename, errno


class MissingFileError(InvalidFileError, FileNotFoundError):
    """There is no such file."""


class DirectoryError(InvalidFileError, IsADirectoryError):
    """The file is a directory."""


class ForbiddenFileError(InvalidFileError, PermissionError):
    """The file may not be read."""


_BUILT_IN = {FileNotFoundError: MissingFileError, IsADirectoryError: DirectoryError, PermissionError: ForbiddenFileError}


@contextlib.contextmanager
def reading(path: Any) -> Iterator[None]:
    """What the library finds wrong with a surface is wrong with this file."""
    try:
        yield
    except InvalidSurfaceError as error:
        found: Any = None
        try:
            with open(path, "rb"):
                pass
        except OSError as system:
            found = system
        cls = _BUILT_IN.get(type(found), InvalidFileError)
        raise cls(*error.args, path, getattr(found, "errno", None)) from None


@contextlib.contextmanager
def writing(path: Any) -> Iterator[None]:
    """An error of no other kind means that this file cannot be written."""
    try:
        yield
    except Error as error:
        if type(error) is not Error:  # pylint: disable=unidiomatic-typecheck
            raise
        raise FileError(str(error), path) from None


class InvalidArgumentError(Error, ValueError):
    """The surface is valid, but an argument is not: a missing or unreachable vertex, or a number out of range."""


class InvalidPointError(Error, ValueError):
    """A point or direction does not lie on the surface."""


class UndecidedError(Error, RuntimeError):
    """The exact geometry cannot decide because an edge crosses too many input edges."""


class IntegerOverflowError(Error, OverflowError):
    """A count of crossings exceeds the range of its type."""


class NumericalError(Error, ArithmeticError):
    """A computation in doubles failed, such as the factorization of a matrix."""


class CancelledError(Error, RuntimeError):
    """A computation was cancelled. (Ctrl-C raises `KeyboardInterrupt` as usual.)"""
