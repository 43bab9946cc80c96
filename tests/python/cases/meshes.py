"""Small meshes: positions and triangles."""

import numpy as np

_CORNERS = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]
QUADS = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]


def triangles_of(quads):
    quads = np.asarray(quads)
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def cube():
    return np.array(_CORNERS, float), triangles_of(QUADS)


def grid(columns, rows, point, wraps=False):
    """A sheet of point(i, j); with ``wraps`` a torus."""
    wide, high = (columns, rows) if wraps else (columns + 1, rows + 1)
    at = lambda i, j: (j % high) * wide + i % wide
    positions = [point(i, j) for j in range(high) for i in range(wide)]
    quads = [
        [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
        for j in range(rows)
        for i in range(columns)
    ]
    return np.array(positions, float), triangles_of(quads)


def torus(columns=16, rows=8):
    def point(i, j):
        a, b = 2 * np.pi * i / columns, 2 * np.pi * j / rows
        radius = 3 + np.cos(b)
        return radius * np.cos(a), radius * np.sin(a), np.sin(b)

    return grid(columns, rows, point, wraps=True)


def hill(size=8):
    def point(i, j):
        return i, j, 3 * np.exp(-((i - size / 2) ** 2 + (j - size / 2) ** 2) / 8)

    return grid(size, size, point)


def soup(seed, vertices=60, faces=90):
    """Triangles anywhere: most edges have many faces or one."""
    random = np.random.default_rng(seed)
    return random.random((vertices, 3)), random.integers(0, vertices, (faces, 3))
