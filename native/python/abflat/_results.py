"""What calls return."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ._mesh import Mesh


@dataclass(frozen=True, eq=False, repr=False)
class Layout:
    """One uv per output vertex: those of the input in their order, on seams several of each."""

    uv: np.ndarray
    """(K, 2) float64: u and v of each output vertex."""
    vertex_map: np.ndarray
    """(K,) uint32: the input vertex of each output vertex."""
    triangles: np.ndarray
    """(T, 3) uint32: output vertices, by input face; triangles of the input keep their order."""
    report: dict[str, Any]
    """The report, with the keys of docs/report.md."""

    @property
    def valid(self) -> bool:
        """Whether no triangle is flipped and nothing overlaps, by exact arithmetic."""
        return self.report["valid"]

    def __repr__(self) -> str:
        state = "valid" if self.valid else "not valid"
        counts = f"{len(self.triangles)} triangles, {len(self.uv)} vertices"
        return f"<{type(self).__name__}: {counts}, {state}>"


@dataclass(frozen=True, eq=False, repr=False)
class FlattenResult(Layout):
    """A disk in one piece. Its area in uv is that of the surface, unless pinned."""

    corner_vertex: np.ndarray
    """(C,) uint32: the output vertex of each corner of the input's faces."""
    _mesh: Mesh = field(repr=False)

    @property
    def faces(self) -> Any:
        """The input's faces with output vertices: an array, or a list if their sizes differ."""
        if self._mesh.offsets is None:
            return self.corner_vertex.reshape(-1, 3)
        sizes = np.diff(self._mesh.offsets)
        if len(sizes) and (sizes == sizes[0]).all():
            return self.corner_vertex.reshape(len(sizes), -1)
        return np.split(self.corner_vertex, self._mesh.offsets[1:-1])


@dataclass(frozen=True, eq=False, repr=False)
class UnwrapResult(FlattenResult):
    """Charts in the unit square, or in UDIM tiles."""

    chart_of_triangle: np.ndarray
    """(T,) int32: index into report["charts"]; -1 for a face that has no area and no neighbour."""
    chart_of_face: np.ndarray
    """(F,) int32: the same for the faces of the input."""
    seams: np.ndarray
    """(S, 2) uint32: the edges that were cut, as two input vertices each."""


@dataclass(frozen=True, eq=False, repr=False)
class PackResult(Layout):
    """The islands of a layout, packed again."""

    island_of_triangle: np.ndarray
    """(T,) int32: the island of each triangle; -1 without texcoords."""


@dataclass(frozen=True, eq=False, repr=False)
class VerifyResult:
    """What a layout does not keep to."""

    report: dict[str, Any]
    """The report, with the keys of docs/report.md; its findings name faces and islands."""
    island_of_face: np.ndarray
    """(F,) int32: the island of each face of the input; -1 without texcoords."""
    face_of_triangle: np.ndarray
    """(T,) uint32: the face of each triangle; polygons are triangulated in their order."""
    faults: np.ndarray
    """(T,) uint8: what is wrong with each triangle in uv, a sum of values of UV_FAULT."""

    @property
    def valid(self) -> bool:
        """Whether nothing was found."""
        return self.report["valid"]

    @property
    def findings(self) -> list[dict[str, Any]]:
        """What was found: rule, message, faces, islands, value and limit."""
        return self.report["findings"]

    def __repr__(self) -> str:
        count = len(self.findings)
        found = f"{count} finding{'' if count == 1 else 's'}" if count else "valid"
        return f"<{type(self).__name__}: {self.report['islands']} islands, {found}>"


def fields_of(arrays: dict[str, Any]) -> dict[str, Any]:
    """Numbers that stand for nothing, 2**32 - 1, become -1."""
    fields = dict(arrays, report=json.loads(arrays["report"]))
    for name in ("chart_of_triangle", "chart_of_face", "island_of_triangle", "island_of_face"):
        if name in fields:
            fields[name] = fields[name].view(np.int32)
    return fields
