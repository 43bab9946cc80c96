"""What a mesh may have beside its faces: a layout, and materials."""

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
    names = np.asarray(materials)
    if names.shape != (mesh.face_count(),):
        message = f"materials have the shape {names.shape}; it must be ({mesh.face_count()},)"
        raise _invalid(message)
    _, first, number = np.unique(names, return_index=True, return_inverse=True)
    by_appearance = np.argsort(np.argsort(first))
    return mesh._replace(material_of_face=by_appearance[number].astype(np.uint32))


def _invalid(message: str) -> AbflatError:
    return AbflatError("InvalidMesh", message)
