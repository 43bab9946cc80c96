"""A picture of the charts."""

from __future__ import annotations

import numpy as np

_DARKEST = 96


def draw_charts(corners: np.ndarray, charts: np.ndarray, side: int) -> np.ndarray:
    """``corners`` is (T, 3, 2) in texels; a texel is drawn if its centre is in a triangle."""
    image = np.zeros((side, side, 3), np.uint8)
    for triangle, chart in zip(corners, charts):
        low = np.clip(np.floor(triangle.min(axis=0)), 0, side).astype(int)
        high = np.clip(np.ceil(triangle.max(axis=0)), 0, side).astype(int)
        x, y = np.meshgrid(*(np.arange(a, b) + 0.5 for a, b in zip(low, high)))
        inside = np.ones(x.shape, bool)
        for a, b in zip(triangle, np.roll(triangle, -1, axis=0)):
            inside &= (b[0] - a[0]) * (y - a[1]) >= (b[1] - a[1]) * (x - a[0])
        image[low[1] : high[1], low[0] : high[0]][inside] = _color(int(chart))
    return image


def _color(chart: int) -> np.ndarray:
    return np.random.default_rng(chart).integers(_DARKEST, 256, 3, np.uint8)
