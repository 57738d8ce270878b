# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# The documentation of fields, for help().

"""The documentation of fields, for help()."""

from __future__ import annotations

import ast
import inspect
import textwrap
from typing import TypeVar

Class = TypeVar("Class", bound=type)


def documented(cls: Class) -> Class:
    """Gives each field of a named tuple the string that follows it in the source, which help() shows."""
    try:
        body = ast.parse(textwrap.dedent(inspect.getsource(cls))).body[0].body  # type: ignore[attr-defined]
    except (OSError, SyntaxError):
        return cls  # there is no source
    for field, text in zip(body, body[1:]):
        if isinstance(field, ast.AnnAssign) and isinstance(text, ast.Expr) and isinstance(text.value, ast.Constant):
            getattr(cls, field.target.id).__doc__ = inspect.cleandoc(text.value.value)  # type: ignore[union-attr]
    return cls
