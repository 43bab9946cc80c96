"""Judges a layout by its numbers alone, exactly: floats are whole numbers in a common unit."""

from fractions import Fraction
from itertools import combinations

import numpy as np


def _turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _overlap(s, t):
    """Whether two counter-clockwise triangles share more than boundary."""

    def separates(p, q):
        return any(all(_turn(p[k], p[(k + 1) % 3], x) <= 0 for x in q) for k in range(3))

    return not separates(s, t) and not separates(t, s)


def _whole(uv):
    """Doubles are multiples of 2**-1074; these need far less."""
    unit = max((Fraction(float(x)).denominator for x in uv.reshape(-1)), default=1)
    return [[int(Fraction(float(u)) * unit), int(Fraction(float(v)) * unit)] for u, v in uv]


def areas(uv, triangles):
    """The signed area of each triangle."""
    a, b, c = np.moveaxis(np.asarray(uv, float)[triangles], 1, 0)
    (x, y), (z, w) = (b - a).T, (c - a).T
    return (x * w - y * z) / 2


def faults(uv, triangles):
    """The triangles that are flipped or without area, and the pairs that overlap."""
    points = _whole(np.asarray(uv))
    drawn = [[points[i] for i in t] for t in triangles]
    flipped = [k for k, t in enumerate(drawn) if _turn(*t) <= 0]
    uv = np.asarray(uv, float)[triangles]
    low, high = uv.min(axis=1), uv.max(axis=1)
    near = lambda i, j: (low[i] <= high[j]).all() and (low[j] <= high[i]).all()
    kept = [k for k in range(len(drawn)) if k not in set(flipped)]
    crossing = [p for p in combinations(kept, 2) if near(*p) and _overlap(drawn[p[0]], drawn[p[1]])]
    return flipped, crossing
