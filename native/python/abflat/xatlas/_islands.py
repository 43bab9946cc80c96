"""Lays charts that lie on each other side by side, since each gets texels of its own."""

from __future__ import annotations

import numpy as np


def spread(uv: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """The layout with each part, whose faces share vertices, in a column of its own."""
    part = _parts(len(uv), faces)
    numbers, part = np.unique(part, return_inverse=True)
    left = np.full(len(numbers), np.inf)
    right = np.full(len(numbers), -np.inf)
    used = np.unique(faces)
    np.minimum.at(left, part[used], uv[used, 0])
    np.maximum.at(right, part[used], uv[used, 0])
    width = np.where(right >= left, right - left, 0)
    # A gap as wide as all of them keeps islands apart from their neighbours.
    ends = np.cumsum(width + max(width.max(initial=0), 1e-30))
    shift = np.where(np.isfinite(left), ends - width - left, 0)
    moved = uv.copy()
    moved[:, 0] += shift[part]
    return moved


def _parts(count: int, faces: np.ndarray) -> np.ndarray:
    """A number for each vertex, which is the same for those that faces connect."""
    part = np.arange(count)
    while True:
        lowest = part.copy()
        np.minimum.at(lowest, faces.reshape(-1), np.repeat(part[faces].min(axis=1), 3))
        lowest = lowest[lowest]
        if (lowest == part).all():
            return part
        part = lowest
