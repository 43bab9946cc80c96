"""The names of xatlas-python, with the layouts of abflat: ``from abflat import xatlas``."""

from ._atlas import Atlas
from ._chart import Chart, ChartType
from ._export import export
from ._options import ChartOptions, PackOptions

__all__ = ["Atlas", "Chart", "ChartOptions", "ChartType", "PackOptions", "export", "parametrize"]


def parametrize(positions, indices, normals=None, uvs=None):
    """Returns ``vmapping`` (K,), ``indices`` (F, 3) and ``uvs`` (K, 2); faces keep their order."""
    atlas = Atlas()
    atlas.add_mesh(positions, indices, normals, uvs)
    atlas.generate()
    return atlas.get_mesh(0)
