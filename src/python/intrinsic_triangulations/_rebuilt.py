# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Objects that a pickle cannot hold, for example factorized matrices.

from __future__ import annotations

from typing import Any, Callable


def _rebuild(cls: type, make: Callable[..., None], arguments: Any, keywords: Any) -> Any:
    result = cls.__new__(cls)
    make(result, *arguments, **keywords)
    return result


class Rebuilt:
    """An object that is pickled as its constructor arguments and reconstructed from them."""

    def _remember(self, make: Callable[..., None], *arguments: Any, **keywords: Any) -> None:
        self._recipe = (make, arguments, keywords)

    def __reduce__(self) -> Any:
        return _rebuild, (type(self), *self._recipe)
