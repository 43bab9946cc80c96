"""Arguments as arrays, with the errors of xatlas-python."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional

import numpy as np


class Part(NamedTuple):
    """A mesh, and which of its faces can be drawn: others get the uv 0, 0, as in xatlas."""

    positions: np.ndarray
    indices: np.ndarray
    drawn: np.ndarray


def part_of(positions: np.ndarray, indices: np.ndarray) -> Part:
    if indices.size and (indices.min() < 0 or indices.max() >= len(positions)):
        raise RuntimeError("Adding mesh failed: Index out of range")
    a, b, c = indices.T
    drawn = (a != b) & (b != c) & (c != a)
    is_finite = np.isfinite(positions).all(axis=1)
    drawn &= is_finite[indices].all(axis=1)
    # No drawn face uses the others, which must be numbers all the same.
    return Part(np.where(is_finite[:, None], positions, 0), indices, drawn)


def points(name: str, array: Any, columns: int, rows: Optional[int] = None) -> np.ndarray:
    return table(name, array, columns, rows).astype(np.float64, copy=False)


def faces(array: Any) -> np.ndarray:
    return table("Index", array, 3).astype(np.int64, copy=False)


def table(name: str, array: Any, columns: int, rows: Optional[int] = None) -> np.ndarray:
    values = np.asarray(array)
    if values.size == 0:
        values = values.reshape(0, columns)
    if values.ndim != 2 or values.shape[1] != columns:
        raise ValueError(f"{name} array expected to be Nx{columns}.")
    if rows is not None and len(values) != rows:
        raise ValueError(
            f"{name} array has invalid number of elements in the first dimension "
            f"(expected {rows}, got {len(values)})"
        )
    return values
