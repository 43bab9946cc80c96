"""What a mesh may have beside its faces: a layout, materials, and objects."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._errors import AbflatError
from ._mesh import Mesh, mesh_of, narrow

_NO_TEXCOORD = 0xFFFFFFFF


def with_layout(mesh: Mesh, uv: Any, uv_faces: Any) -> Mesh:
    """Rows of uv per vertex, or per texcoord with ``uv_faces``. A row with NaN is none."""
    if uv is None:
        if uv_faces is not None:
            raise TypeError("uv_faces needs uv")
        return mesh
    texcoords = np.asarray(uv, dtype=np.float64)
    if texcoords.ndim != 2 or texcoords.shape[1] != 2:
        raise _invalid(f"uv has the shape {texcoords.shape}; it must be (K, 2)")
    used = mesh if uv_faces is None else mesh_of(mesh.positions, uv_faces)
    if used.vertices.size != mesh.vertices.size:
        raise _invalid("uv_faces and faces have different numbers of corners")
    corners = narrow(used.vertices.reshape(-1), len(texcoords))
    if corners.size and corners.max() >= len(texcoords):
        raise _invalid(f"a face refers to row {corners.max()} of uv; there are {len(texcoords)}")
    is_given = np.isfinite(texcoords).all(axis=1)
    return mesh._replace(
        texcoords=np.where(is_given[:, None], texcoords, 0),
        texcoord_of_corner=np.where(is_given[corners], corners, _NO_TEXCOORD),
    )


def with_materials(mesh: Mesh, materials: Any) -> Mesh:
    """Any values, one per face; faces with the same value have one material."""
    if materials is None:
        return mesh
    return mesh._replace(material_of_face=_numbered("materials", materials, mesh.face_count()))


def with_objects(mesh: Mesh, objects: Any) -> Mesh:
    """Any values, one per vertex; vertices with the same value belong to one object."""
    if objects is None:
        return mesh
    count = len(mesh.positions)
    return mesh._replace(object_of_vertex=_numbered("vertex_objects", objects, count))


def _numbered(what: str, values: Any, count: int) -> np.ndarray:
    """Numbers from 0, in the order in which the values appear."""
    names = np.asarray(values)
    if names.shape != (count,):
        raise _invalid(f"{what} have the shape {names.shape}; it must be ({count},)")
    _, first, number = np.unique(names, return_index=True, return_inverse=True)
    by_appearance = np.argsort(np.argsort(first))
    return by_appearance[number].astype(np.uint32)


def _invalid(message: str) -> AbflatError:
    return AbflatError("InvalidMesh", message)
