# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Objects that hold what a pickle cannot: factored matrices, say.

from __future__ import annotations

from typing import Any, Callable


def _rebuild(cls: type, make: Callable[..., None], arguments: Any, keywords: Any) -> Any:
    result = cls.__new__(cls)
    make(result, *arguments, **keywords)
    return result


class Rebuilt:
    """An object that is pickled as what it was made of, and made anew from that."""

    def _remember(self, make: Callable[..., None], *arguments: Any, **keywords: Any) -> None:
        self._recipe = (make, arguments, keywords)

    def __reduce__(self) -> Any:
        return _rebuild, (type(self), *self._recipe)
