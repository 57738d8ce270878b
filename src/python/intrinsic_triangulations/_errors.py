# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# The exceptions of the package.

"""The exceptions of the package."""

from __future__ import annotations


class Error(Exception):
    """The base of the exceptions that the library throws; each is also a `ValueError` or a `RuntimeError`."""


class InvalidSurfaceError(Error, ValueError):
    """The input is not a surface with a metric. The message names the first offending element.

    Attributes
    ----------
    defect : str
        What is wrong: one of ``EMPTY``, ``BAD_INDEX``, ``NOT_A_TRIANGLE``, ``REPEATED_CORNER``, ``DUPLICATE_FACE``,
        ``NON_MANIFOLD_EDGE``, ``INCONSISTENT_ORIENTATION``, ``NON_MANIFOLD_VERTEX``, ``INVALID_GLUING``, ``NOT_FINITE``,
        ``OUT_OF_RANGE``, ``ZERO_LENGTH_EDGE``, ``TRIANGLE_INEQUALITY``, ``DEGENERATE_FACE``, ``WRONG_TOPOLOGY``, ``UNREADABLE``.
    element : int
        The number of the first offending vertex, edge or face, as in the message.
    count : int
        How many offending elements there are.
    """

    def __init__(self, message: str, defect: str, element: int, count: int) -> None:
        super().__init__(message, defect, element, count)
        self.defect = defect
        self.element = element
        self.count = count

    def __str__(self) -> str:
        return str(self.args[0])


class InvalidArgumentError(Error, ValueError):
    """An argument is wrong though the surface is fine: a vertex that does not exist or that no path leads to, or a number out of range."""


class InvalidPointError(Error, ValueError):
    """A point or a direction does not belong to the surface."""


class UndecidedError(Error, RuntimeError):
    """Exact geometry gives no answer, where any answer might be wrong: an edge crosses too many input edges."""


class IntegerOverflowError(Error, OverflowError):
    """An integer that counts crossings left the range of its type."""


class NumericalError(Error, ArithmeticError):
    """A computation in doubles came to nothing, such as the factorization of a matrix."""


class CancelledError(Error, RuntimeError):
    """A computation ended early. (Ctrl-C raises `KeyboardInterrupt` as always.)"""
