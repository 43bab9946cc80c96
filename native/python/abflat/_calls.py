"""unwrap, flatten, pack and verify."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from . import _abflat
from ._errors import AbflatError
from ._generated import FLATTEN_OPTIONS, PACK_OPTIONS, UNWRAP_OPTIONS, VERIFY_OPTIONS
from ._layout import with_layout, with_materials, with_objects
from ._mesh import Mesh, mesh_of
from ._options import checked, present
from ._results import FlattenResult, PackResult, UnwrapResult, VerifyResult, fields_of

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._generated import FlattenOptions, PackOptions, UnwrapOptions, VerifyOptions

Progress = Optional[Callable[[str, float], Any]]

_UNWRAP_EXTRAS = ("uv", "uv_faces", "materials", "seams", "seam_edges", "pins", "face_densities")
_UNWRAP_EXTRAS += ("vertex_objects", "precision", "progress")
_FLATTEN_EXTRAS = ("pins", "bounds", "straight", "progress")
_PACK_EXTRAS = ("uv_faces", "precision", "progress")
_VERIFY_EXTRAS = ("uv_faces", "progress")


def unwrap(
    positions: Any,
    faces: Any = None,
    *,
    uv: Any = None,
    uv_faces: Any = None,
    materials: Any = None,
    vertex_objects: Any = None,
    seams: Optional[str] = None,
    seam_edges: Any = None,
    pins: Any = None,
    face_densities: Any = None,
    precision: str = "double",
    progress: Progress = None,
    **options: Unpack[UnwrapOptions],
) -> UnwrapResult:
    """Cuts any mesh into charts, flattens each and packs them into the unit square.

    ``positions`` is (V, 3); ``faces`` is (F, n) of any integer type, or a list of polygons. A
    trimesh.Trimesh may take the place of both. ``seams`` is a list of sources such as
    ``"auto,sharp=60"``; ``seam_edges`` are rows of two vertices to cut between; ``pins`` are rows
    of vertex, u and v; ``face_densities`` has the texel density wanted for each face. With
    ``precision="single"`` uvs are rounded to numbers that float32 holds, where that keeps the
    layout valid. ``progress(stage, fraction)`` is called during the run; what it raises ends it.

    The seams ``"uv"`` and ``"material"`` need ``uv``, with a row per vertex or per texcoord if
    ``uv_faces`` has the texcoords of each face's corners, and ``materials``, one for each face.
    Vertices with different ``vertex_objects``, one for each vertex, are apart even in one place.
    """
    values = checked("unwrap", options, UNWRAP_OPTIONS, _UNWRAP_EXTRAS)
    mesh = with_materials(with_layout(mesh_of(positions, faces), uv, uv_faces), materials)
    mesh = with_objects(mesh, vertex_objects)
    extras = present(
        seams=seams,
        seam_edges=_rows("seam_edges", seam_edges, 2, len(mesh.positions)),
        pins=_rows("pins", pins, 3, len(mesh.positions), 1),
        face_densities=face_densities,
        precision=_precision(precision),
    )
    arrays = fields_of(_abflat.unwrap(mesh.arrays, values, extras, progress))
    return UnwrapResult(**arrays, _mesh=mesh)


def flatten(
    positions: Any,
    faces: Any = None,
    *,
    pins: Any = None,
    bounds: Any = None,
    straight: Any = None,
    progress: Progress = None,
    **options: Unpack[FlattenOptions],
) -> FlattenResult:
    """Flattens one disk in one piece: one part, one boundary loop, no handles.

    ``bounds`` are rows of a boundary vertex and its t; ``straight`` are rows of two vertices,
    between which the boundary is to be straight. The rest is as in ``unwrap``.
    """
    values = checked("flatten", options, FLATTEN_OPTIONS, _FLATTEN_EXTRAS)
    mesh = mesh_of(positions, faces)
    count = len(mesh.positions)
    extras = present(
        pins=_rows("pins", pins, 3, count, 1),
        bounds=_rows("bounds", bounds, 2, count, 1),
        straight=_rows("straight", straight, 2, count),
    )
    arrays = fields_of(_abflat.flatten(mesh.arrays, values, extras, progress))
    return FlattenResult(**arrays, _mesh=mesh)


def pack(
    positions: Any,
    faces: Any,
    uv: Any,
    uv_faces: Any = None,
    *,
    precision: str = "double",
    progress: Progress = None,
    **options: Unpack[PackOptions],
) -> PackResult:
    """Packs the layout that a mesh has: its islands keep their shapes.

    ``uv`` has a row per vertex, or per texcoord if ``uv_faces`` has the texcoords of each face's
    corners. A row with NaN is none.
    """
    values = checked("pack", options, PACK_OPTIONS, _PACK_EXTRAS)
    mesh = _laid_out(positions, faces, uv, uv_faces)
    extras = {"precision": _precision(precision)}
    return PackResult(**fields_of(_abflat.pack(mesh.arrays, values, extras, progress)))


def verify(
    positions: Any,
    faces: Any,
    uv: Any,
    uv_faces: Any = None,
    *,
    progress: Progress = None,
    **options: Unpack[VerifyOptions],
) -> VerifyResult:
    """Says what the layout of a mesh does not keep to, whichever program made it.

    ``uv`` and ``uv_faces`` are as in ``pack``. The options are the rules, each of which allows or
    asks for something: ``padding=8``, ``max_stretch=1.1``, ``allow_stacked=True``.
    """
    values = checked("verify", options, VERIFY_OPTIONS, _VERIFY_EXTRAS)
    mesh = _laid_out(positions, faces, uv, uv_faces)
    return VerifyResult(**fields_of(_abflat.verify(mesh.arrays, values, progress)))


def _laid_out(positions: Any, faces: Any, uv: Any, uv_faces: Any) -> Mesh:
    mesh = mesh_of(positions, faces)
    texcoords = np.asarray(uv, dtype=np.float64)
    if texcoords.ndim != 2 or texcoords.shape[1] != 2:
        raise AbflatError("InvalidMesh", f"uv has the shape {texcoords.shape}; it must be (K, 2)")
    return with_layout(mesh, uv, uv_faces)


def _precision(name: str) -> str:
    if name not in ("single", "double"):
        raise AbflatError("InvalidOption", f"precision cannot be {name!r}; it is single, double")
    return name


def _rows(name: str, rows: Any, columns: int, vertices: int, vertex_columns: int = 2) -> Any:
    """Rows that begin with vertices of the mesh."""
    if rows is None:
        return None
    table = np.asarray(rows)
    if table.size == 0:
        return None
    if table.ndim != 2 or table.shape[1] != columns:
        message = f"{name} have the shape {table.shape}; it must be (N, {columns})"
        raise AbflatError("InvalidOption", message)
    named = table[:, :vertex_columns]
    wrong = (named < 0) | (named >= vertices) | (named != np.trunc(named))
    if wrong.any():
        message = f"{name} name vertex {named[wrong][0]}; vertices are 0 to {vertices - 1}"
        raise AbflatError("InvalidOption", message)
    return table
