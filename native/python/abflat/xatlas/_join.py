"""Several meshes as one, so that they share an atlas, and its layout as theirs again."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ._arrays import Part

NO_CHART = 0xFFFFFFFF


class PartLayout(NamedTuple):
    """The result for one mesh; tile and chart of each vertex, or NO_CHART."""

    vmapping: np.ndarray
    indices: np.ndarray
    uvs: np.ndarray
    tiles: np.ndarray
    charts: np.ndarray
    face_charts: np.ndarray


class Placed(NamedTuple):
    """A layout of the drawn faces of all parts, in that order."""

    uv: np.ndarray
    vertex_map: np.ndarray
    triangles: np.ndarray
    chart_of_triangle: np.ndarray
    tile_of_triangle: np.ndarray


def join(parts: list[Part]) -> tuple[np.ndarray, np.ndarray]:
    """All drawn faces. The parts lie side by side along x, so that none is joined to another."""
    starts = _starts(parts)
    all_faces = [part.indices[part.drawn] + start for part, start in zip(parts, starts)]
    if len(parts) == 1:
        return parts[0].positions, all_faces[0]
    sizes = [np.abs(part.positions).max(initial=0) for part in parts]
    # A power of two leaves most digits of the coordinates as they are.
    step = 4.0 * 2.0 ** np.ceil(np.log2(max(*sizes, np.finfo(np.float32).tiny)))
    moved = [part.positions + [i * step, 0, 0] for i, part in enumerate(parts)]
    return np.concatenate(moved), np.concatenate(all_faces)


def split(parts: list[Part], placed: Placed) -> list[PartLayout]:
    starts = _starts(parts)
    ends = np.cumsum([part.drawn.sum() for part in parts])
    layouts = []
    for part, start, end in zip(parts, starts, ends):
        own = slice(end - part.drawn.sum(), end)
        layouts.append(_part_layout(part, start, placed, own))
    return layouts


def _starts(parts: list[Part]) -> np.ndarray:
    return np.concatenate([[0], np.cumsum([len(part.positions) for part in parts])])[:-1]


def _part_layout(part: Part, start: int, placed: Placed, own: slice) -> PartLayout:
    used, drawn = np.unique(placed.triangles[own], return_inverse=True)
    left_out, others = np.unique(part.indices[~part.drawn], return_inverse=True)
    indices = np.empty(part.indices.shape, np.uint32)
    indices[part.drawn] = drawn.reshape(-1, 3)
    indices[~part.drawn] = others.reshape(-1, 3) + len(used)
    face_charts = np.full(len(indices), NO_CHART, np.uint32)
    face_charts[part.drawn] = placed.chart_of_triangle[own]
    face_tiles = np.full(len(indices), NO_CHART, np.uint32)
    face_tiles[part.drawn] = placed.tile_of_triangle[own]
    vmapping = np.concatenate([placed.vertex_map[used] - start, left_out]).astype(np.uint32)
    uvs = np.concatenate([placed.uv[used], np.zeros((len(left_out), 2))]).astype(np.float32)
    return PartLayout(
        vmapping,
        indices,
        uvs,
        _of_vertices(face_tiles, indices, len(vmapping)),
        _of_vertices(face_charts, indices, len(vmapping)),
        face_charts,
    )


def _of_vertices(of_faces: np.ndarray, indices: np.ndarray, count: int) -> np.ndarray:
    values = np.full(count, NO_CHART, np.uint32)
    np.minimum.at(values, indices.reshape(-1), np.repeat(of_faces, 3))
    return values
