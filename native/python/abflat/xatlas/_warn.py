"""Warnings that point to the line of the caller."""

from __future__ import annotations

import sys
import warnings

_PACKAGE = __name__.split(".")[0]


def warn(message: str, category: type[Warning] = RuntimeWarning) -> None:
    frame, depth = sys._getframe(), 1
    while frame.f_back and frame.f_globals.get("__name__", "").split(".")[0] == _PACKAGE:
        frame, depth = frame.f_back, depth + 1
    warnings.warn(f"abflat: {message}", category, stacklevel=depth)
