"""A chart of a mesh."""

from __future__ import annotations

from enum import IntEnum
from typing import NamedTuple

import numpy as np


class ChartType(IntEnum):
    Planar = 0
    Ortho = 1
    LSCM = 2
    Piecewise = 3
    Invalid = 4


class Chart(NamedTuple):
    faces: np.ndarray
    """(N,) uint32: the faces of the mesh."""
    atlas_index: int
    type: ChartType = ChartType.LSCM
    """The nearest of the names: abflat flattens every chart by its angles."""
    material: int = 0
