"""The options of xatlas, by its names in C++ (maxCost) and in Python (max_cost)."""

from __future__ import annotations

import re
from typing import Any, ClassVar

from ._warn import warn


class _Options:
    _defaults: ClassVar[dict[str, Any]]
    _unused: ClassVar[dict[str, str]]
    """Fields that change nothing here, and why."""

    def __init__(self) -> None:
        for name, value in self._defaults.items():
            object.__setattr__(self, name, value)

    def __getattr__(self, name: str) -> Any:
        return object.__getattribute__(self, self._known(name))

    def __setattr__(self, name: str, value: Any) -> None:
        object.__setattr__(self, self._known(name), value)

    def _known(self, name: str) -> str:
        snake = re.sub("[A-Z]", lambda match: "_" + match[0].lower(), name)
        if snake not in self._defaults:
            raise AttributeError(f"{type(self).__name__} has no field {name!r}")
        return snake

    def warn_of_unused(self) -> None:
        for name, reason in self._unused.items():
            if getattr(self, name) != self._defaults[name]:
                warn(f"{type(self).__name__}.{name} is ignored: {reason}", UserWarning)


_STRETCH = "charts are bounded by their stretch, see abflat.unwrap(max_stretch=...)"
_SIGHT = "seams go where they are little in sight"


class ChartOptions(_Options):
    _defaults = {
        "max_chart_area": 0.0,
        "max_boundary_length": 0.0,
        "normal_deviation_weight": 2.0,
        "roundness_weight": 0.01,
        "straightness_weight": 6.0,
        "normal_seam_weight": 4.0,
        "texture_seam_weight": 0.5,
        "max_cost": 2.0,
        "max_iterations": 1,
        "use_input_mesh_uvs": False,
        "fix_winding": False,  # all triangles run counter-clockwise anyway
    }
    _unused = {
        "max_chart_area": _STRETCH,
        "max_boundary_length": _STRETCH,
        "normal_deviation_weight": _STRETCH,
        "roundness_weight": _STRETCH,
        "straightness_weight": _SIGHT,
        "normal_seam_weight": _SIGHT,
        "texture_seam_weight": _SIGHT,
        "max_cost": _STRETCH,
        "max_iterations": _STRETCH,
        "use_input_mesh_uvs": "seams are new; abflat.pack keeps those of a layout",
    }


class PackOptions(_Options):
    _defaults = {
        "max_chart_size": 0,
        "padding": 0,
        "texels_per_unit": 0.0,
        "resolution": 0,
        "bilinear": True,
        "block_align": False,
        "brute_force": False,
        "create_image": False,
        "rotate_charts_to_axis": True,
        "rotate_charts": True,
    }
    _unused = {
        "max_chart_size": "all charts have one texel density",
        "block_align": "charts are placed by texels",
        "brute_force": "there is one way of packing",
        "rotate_charts_to_axis": "charts lie level and upright",
    }
