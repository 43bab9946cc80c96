"""Checks the names of options; their values are checked where they are used."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from ._generated import OptionInfo


def checked(
    call: str, given: Mapping[str, Any], known: Mapping[str, OptionInfo], others: Iterable[str]
) -> dict[str, Any]:
    """The options, all of them known. ``others`` are further arguments of the call."""
    for name in given:
        if name not in known:
            raise TypeError(f"{call}() has no option {name!r}{_nearest(name, [*known, *others])}")
    return {name: v.item() if isinstance(v, np.generic) else v for name, v in given.items()}


def _nearest(name: str, names: list[str]) -> str:
    by_letters = {each.replace("_", ""): each for each in names}
    found = difflib.get_close_matches(name.replace("_", "").lower(), by_letters, n=1)
    return f"; did you mean {by_letters[found[0]]!r}?" if found else ""


def present(**extras: Any) -> dict[str, Any]:
    """The arguments that are given."""
    return {name: value for name, value in extras.items() if value is not None}
