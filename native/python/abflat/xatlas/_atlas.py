"""The atlas of xatlas-python."""

from __future__ import annotations

from functools import partial
from typing import Any, Optional

import numpy as np

from .._calls import pack, unwrap
from .._errors import AbflatError
from ._arrays import Part, faces, part_of, points
from ._chart import Chart
from ._image import draw_charts
from ._islands import spread
from ._join import NO_CHART, PartLayout, Placed, join, split
from ._options import ChartOptions, PackOptions
from ._place import Atlas as Result
from ._place import place

_NOTHING = Placed(
    np.empty((0, 2)),
    np.empty(0, np.int64),
    np.empty((0, 3), np.uint32),
    np.empty(0, np.int64),
    np.empty(0, np.int64),
)


class Atlas:
    """Meshes that share an atlas. Results are there after ``generate``."""

    def __init__(self) -> None:
        self._parts: list[Part] = []
        self._has_uv_meshes: Optional[bool] = None
        self._result = Result(_NOTHING, 0, 0, 0.0)
        self._layouts: list[PartLayout] = []
        self._has_image = False

    def add_mesh(self, positions: Any, indices: Any, normals: Any = None, uvs: Any = None) -> None:
        """Normals and uvs are checked, and otherwise not needed."""
        vertices = points("Position", positions, 3)
        part = part_of(vertices, faces(indices))
        if normals is not None:
            points("Normal", normals, 3, len(vertices))
        if uvs is not None:
            points("Texture coordinate", uvs, 2, len(vertices))
        self._add(part, False)

    def add_uv_mesh(self, uvs: Any, indices: Any, face_materials: Any = None) -> None:
        """Its charts are packed as they are. Materials do not matter."""
        layout = points("Texture coordinate", uvs, 2)
        self._add(part_of(np.column_stack([layout, np.zeros(len(layout))]), faces(indices)), True)

    def _add(self, part: Part, is_uv_mesh: bool) -> None:
        if self._has_uv_meshes not in (None, is_uv_mesh):
            raise RuntimeError("Adding mesh failed: an atlas has meshes or uv meshes, not both")
        self._has_uv_meshes = is_uv_mesh
        self._parts.append(part)

    def generate(
        self,
        chart_options: Optional[ChartOptions] = None,
        pack_options: Optional[PackOptions] = None,
        verbose: bool = False,
    ) -> None:
        chart_options = chart_options or ChartOptions()
        pack_options = pack_options or PackOptions()
        chart_options.warn_of_unused()
        pack_options.warn_of_unused()
        self._parts, self._result = self._generated(pack_options)
        self._layouts = split(self._parts, self._result.placed)
        self._has_image = bool(pack_options.create_image)
        if verbose:
            print("--- Generated Atlas ---")
            print(f"Utilization: {self.utilization * 100 if self.atlas_count else 0:f}%")
            print(f"Charts: {self.chart_count}")
            print(f"Size: {self.width}x{self.height}\n")

    def _generated(self, options: PackOptions) -> tuple[list[Part], Result]:
        parts = self._parts
        if not any(part.drawn.any() for part in parts):
            return parts, Result(_NOTHING, 0, 0, 0.0)
        positions, indices = join(parts)
        run = partial(unwrap, positions, indices)
        if self._has_uv_meshes:
            run = partial(pack, positions, indices, spread(positions[:, :2], indices))
        try:
            return parts, place(run, options)
        except AbflatError as error:
            if error.code != "EmptyMesh":
                raise
            # Every face is degenerate once vertices at one place are one.
            return [part._replace(drawn=part.drawn & False) for part in parts], Result(
                _NOTHING, 0, 0, 0.0
            )

    @property
    def mesh_count(self) -> int:
        return len(self._layouts)

    def __len__(self) -> int:
        return self.mesh_count

    def get_mesh(self, mesh_index: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """``vmapping`` (K,) uint32, ``indices`` (F, 3) uint32 and ``uvs`` (K, 2) float32."""
        layout = self._layout(mesh_index)
        return layout.vmapping.copy(), layout.indices.copy(), layout.uvs.copy()

    __getitem__ = get_mesh

    def get_mesh_vertex_assignment(self, mesh_index: int) -> tuple[np.ndarray, np.ndarray]:
        """The atlas and the chart of each vertex; 2**32 - 1 without one."""
        layout = self._layout(mesh_index)
        return layout.tiles.copy(), layout.charts.copy()

    # As the README of xatlas-python has it.
    get_mesh_vertex_assignement = get_mesh_vertex_assignment

    def get_mesh_chart_count(self, mesh_index: int) -> int:
        return len(_charts(self._layout(mesh_index)))

    def get_mesh_chart(self, mesh_index: int, chart_index: int) -> Chart:
        layout = self._layout(mesh_index)
        charts = _charts(layout)
        if not 0 <= chart_index < len(charts):
            raise IndexError(
                f"Chart index {chart_index} out of bounds for mesh with {len(charts)} charts."
            )
        members = np.flatnonzero(layout.face_charts == charts[chart_index])
        tile = layout.tiles[layout.indices[members[0], 0]]
        return Chart(members.astype(np.uint32), int(tile))

    @property
    def width(self) -> int:
        return self._result.side

    height = width

    @property
    def atlas_count(self) -> int:
        return self._result.tiles

    @property
    def chart_count(self) -> int:
        return sum(len(_charts(layout)) for layout in self._layouts)

    @property
    def texels_per_unit(self) -> float:
        return self._result.texels_per_unit

    @property
    def utilization(self) -> float:
        return self.get_utilization(0)

    def get_utilization(self, atlas_index: int) -> float:
        """The share of an atlas that triangles cover."""
        self._check_atlas(atlas_index)
        placed = self._result.placed
        shown = placed.triangles[placed.tile_of_triangle == atlas_index]
        a, b, c = np.moveaxis(placed.uv[shown], 1, 0)
        (x, y), (z, w) = (b - a).T, (c - a).T
        return float(np.abs(x * w - y * z).sum() / 2)

    @property
    def chart_image(self) -> np.ndarray:
        return self.get_chart_image(0)

    def get_chart_image(self, atlas_index: int) -> np.ndarray:
        """(height, width, 3) uint8: the charts in colours. Padding is black, as what is free."""
        self._check_atlas(atlas_index)
        if not self._has_image:
            raise RuntimeError("The atlas does not have an image.")
        placed = self._result.placed
        shown = placed.tile_of_triangle == atlas_index
        corners = placed.uv[placed.triangles[shown]] * self.width
        return draw_charts(corners, placed.chart_of_triangle[shown], self.width)

    def _check_atlas(self, atlas_index: int) -> None:
        if not 0 <= atlas_index < self.atlas_count:
            raise IndexError(f"Atlas index {atlas_index} out of bounds.")

    def _layout(self, mesh_index: int) -> PartLayout:
        if not 0 <= mesh_index < len(self._layouts):
            raise IndexError(
                f"Mesh index {mesh_index} out of bounds for atlas with {self.mesh_count} meshes."
            )
        return self._layouts[mesh_index]


def _charts(layout: PartLayout) -> np.ndarray:
    return np.unique(layout.face_charts[layout.face_charts != NO_CHART])
