"""Runs abflat with the options of xatlas."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from .._errors import AbflatError
from ._join import NO_CHART, Placed
from ._options import PackOptions
from ._warn import warn

_SIDE = (16, 32768)
_LARGEST_PADDING = 256
_USUAL_SIDE = 1024
_GROWTH = 1.1
_COLUMNS = 10


class Atlas(NamedTuple):
    """A layout, and the numbers of its atlas."""

    placed: Placed
    side: int
    tiles: int
    texels_per_unit: float


Run = Callable[..., Any]


def place(run: Run, options: PackOptions) -> Atlas:
    """``run`` is abflat.unwrap or abflat.pack with its mesh."""
    padding = _padding(options)
    usual = {"padding": padding, "precision": "single"}
    if not options.rotate_charts:
        usual["rotate"] = "none"
    # Padding needs room beside charts.
    least = max(_SIDE[0], 4 * padding)
    side = 0
    if options.resolution:
        side = _clamped("resolution", int(options.resolution), (least, _SIDE[1]))
    density = float(options.texels_per_unit)
    if density <= 0:
        return _atlas_of(_largest(run, side or _USUAL_SIDE, usual))
    if side == 0:
        return _atlas_of(_at_density(run, density, least, usual))
    try:
        return _atlas_of(run(resolution=side, texel_density=density, udim=True, **usual))
    except AbflatError as error:
        if error.code != "AtlasTooSmall":
            raise
        warn(f"texels_per_unit is lower, so that charts fit: {error}")
        return _atlas_of(_largest(run, side, usual))


def _largest(run: Run, side: int, usual: dict[str, Any]) -> Any:
    """As many texels per unit as fit; a larger atlas if charts and padding do not fit at all."""
    try:
        return run(resolution=side, **usual)
    except AbflatError as error:
        if error.code != "AtlasTooSmall" or side >= _SIDE[1]:
            raise
        warn(f"the atlas is larger than {side} texels, so that charts fit: {error}")
        return _largest(run, min(2 * side, _SIDE[1]), usual)


def _at_density(run: Run, density: float, least: int, usual: dict[str, Any]) -> Any:
    """One atlas as large as the density needs."""
    first = _largest(run, _USUAL_SIDE, usual)
    atlas = _numbers(first)
    side = max(least, math.ceil(atlas["resolution"] * density / atlas["texelDensity"]))
    while side <= _SIDE[1]:
        try:
            return run(resolution=side, texel_density=density, **usual)
        except AbflatError as error:
            if error.code != "AtlasTooSmall":
                raise
            side = math.ceil(side * _GROWTH)
    warn(f"texels_per_unit is lower, since an atlas has at most {_SIDE[1]} texels a side")
    return _largest(run, _SIDE[1], usual)


def _padding(options: PackOptions) -> int:
    # Bilinear filtering reads the texel beside a chart, on both sides of a gap.
    texels = int(options.padding) + (2 if options.bilinear else 0)
    return _clamped("padding", texels, (0, _LARGEST_PADDING))


def _clamped(name: str, value: int, limits: tuple[int, int]) -> int:
    inside = min(max(value, limits[0]), limits[1])
    if inside != value:
        warn(f"{name} is {inside}, not {value}: it can be {limits[0]} to {limits[1]}")
    return inside


def _numbers(result: Any) -> dict[str, Any]:
    return result.report.get("atlas", result.report)


def _atlas_of(result: Any) -> Atlas:
    numbers = _numbers(result)
    of_triangle = getattr(result, "chart_of_triangle", None)
    if of_triangle is None:
        of_triangle = result.island_of_triangle
    charts = of_triangle.astype(np.int64)
    tile = np.floor(result.uv[result.triangles].mean(axis=1)).astype(np.int64)
    tiles = tile[:, 0] + _COLUMNS * tile[:, 1]
    origin = np.zeros((len(result.uv), 2))
    origin[result.triangles.reshape(-1)] = np.repeat(tile, 3, axis=0)
    uv = result.uv - origin
    if not result.valid:
        warn("the layout is not valid: some triangles are flipped or overlap")
    elif (result.uv != result.uv.astype(np.float32)).any():
        warn("rounding to float32 may flip triangles: the layout is valid as float64 only")
    lost = charts < 0
    placed = Placed(
        uv,
        result.vertex_map.astype(np.int64),
        result.triangles,
        np.where(lost, NO_CHART, charts),
        np.where(lost, NO_CHART, tiles),
    )
    return Atlas(placed, numbers["resolution"], numbers["tiles"], numbers["texelDensity"])

