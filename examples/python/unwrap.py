"""Unwraps a mesh made in memory and prints what came of it; with a file name, writes it as OBJ."""

import sys

import numpy as np

import abflat
from abflat import xatlas


def tube(sides):
    """A closed tube of two discs and a side, 3 times as long as it is thick."""
    angles = 2 * np.pi * np.arange(sides) / sides
    rim = np.column_stack([np.cos(angles), np.zeros(sides), -np.sin(angles)])
    positions = np.concatenate([[[0, 0, 0], [0, 6, 0]], rim, rim + [0, 6, 0]])
    low = 2 + np.arange(sides)
    next_low = np.roll(low, -1)
    high, next_high = low + sides, next_low + sides
    triangles = [[low, next_low, next_high], [low, next_high, high]]
    triangles += [[0 * low, next_low, low], [0 * low + 1, high, next_high]]
    return positions, np.concatenate([np.column_stack(corners) for corners in triangles])


def main():
    positions, triangles = tube(32)
    result = abflat.unwrap(positions, triangles, resolution=2048, padding=8)
    print(f"{len(result.report['charts'])} charts, {'valid' if result.valid else 'not valid'}")
    if len(sys.argv) > 1:
        xatlas.export(sys.argv[1], positions[result.vertex_map], result.triangles, result.uv)


main()
