"""What may be given as a mesh, as the arrays that the library reads."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional

import numpy as np

from ._abflat import MeshArrays
from ._errors import AbflatError

_LARGEST_INDEX = 0xFFFFFFFE


class Mesh(NamedTuple):
    """Positions, and triangles (F x 3) or the corners of polygons with where each starts."""

    positions: np.ndarray
    vertices: np.ndarray
    offsets: Optional[np.ndarray]
    texcoords: Optional[np.ndarray] = None
    texcoord_of_corner: Optional[np.ndarray] = None
    material_of_face: Optional[np.ndarray] = None
    object_of_vertex: Optional[np.ndarray] = None

    @property
    def arrays(self) -> MeshArrays:
        # Only bare triangles are read where they are; a copy has 32 bits.
        is_bare = all(each is None for each in self[3:])
        vertices = self.vertices if is_bare else narrow(self.vertices, len(self.positions))
        return MeshArrays(self.positions, vertices, *self[2:])

    def face_count(self) -> int:
        return len(self.vertices) if self.offsets is None else len(self.offsets) - 1


def mesh_of(positions: Any, faces: Any) -> Mesh:
    """``positions`` may be an object with ``vertices`` and ``faces``, such as trimesh.Trimesh."""
    if faces is None:
        if not (hasattr(positions, "vertices") and hasattr(positions, "faces")):
            raise TypeError("give positions and faces, or a mesh with .vertices and .faces")
        positions, faces = positions.vertices, positions.faces
    points = _points(positions)
    rows = _as_rows(faces)
    if rows is None:
        return Mesh(points, *_polygons(faces, len(points)))
    if rows.shape[1] == 3:
        return Mesh(points, rows, None)
    offsets = np.arange(len(rows) + 1, dtype=np.uint32) * np.uint32(rows.shape[1])
    return Mesh(points, narrow(rows.reshape(-1), len(points)), offsets)


def _points(positions: Any) -> np.ndarray:
    points = np.asarray(positions)
    if points.size == 0 and points.ndim < 2:
        points = points.reshape(0, 3)
    if points.ndim != 2 or points.shape[1] != 3:
        raise _invalid(f"positions have the shape {points.shape}; it must be (V, 3)")
    if points.dtype.kind not in "fiu":
        raise _invalid(f"positions are of type {points.dtype}; they must be numbers")
    return _readable(points, points.dtype in (np.float32, np.float64), np.float64)


def _as_rows(faces: Any) -> Optional[np.ndarray]:
    """Faces as a table of integers; None if they have different numbers of corners."""
    if not isinstance(faces, np.ndarray) and _is_ragged(faces):
        return None
    rows = np.asarray(faces)
    if rows.dtype == object:
        return None
    if rows.size == 0:
        return np.empty((0, 3), np.uint32)
    if rows.ndim != 2:
        raise _invalid(f"faces have the shape {rows.shape}; it must be (F, n)")
    if rows.dtype.kind not in "iu":
        raise _invalid(f"faces are of type {rows.dtype}; they must be integers")
    if rows.dtype.kind == "i" and rows.min() < 0:
        face = np.flatnonzero((rows < 0).any(axis=1))[0]
        raise _invalid(f"face {face} refers to vertex {rows[face].min()}; vertices start at 0")
    # The library reads these where they are.
    is_read = rows.dtype in (np.uint16, np.uint32, np.int32, np.uint64, np.int64)
    return _readable(rows, is_read, np.int64)


def _is_ragged(faces: Any) -> bool:
    if not isinstance(faces, (list, tuple)):
        return False
    return len({len(face) for face in faces}) > 1


def _polygons(faces: Any, count: int) -> tuple[np.ndarray, np.ndarray]:
    sizes = np.fromiter((len(face) for face in faces), np.int64, len(faces))
    offsets = np.concatenate([[0], np.cumsum(sizes)]).astype(np.uint32)
    vertices = np.concatenate([np.asarray(face) for face in faces])
    if vertices.dtype.kind not in "iu":
        raise _invalid(f"faces are of type {vertices.dtype}; they must be integers")
    return narrow(vertices, count), offsets


def narrow(vertices: np.ndarray, count: int) -> np.ndarray:
    """Vertices as 32 bits, which must not wrap around."""
    wrong = np.flatnonzero((vertices < 0) | (vertices > _LARGEST_INDEX))
    if len(wrong):
        raise _invalid(f"a face refers to vertex {vertices[wrong[0]]}; there are {count} vertices")
    return vertices.astype(np.uint32, copy=False)


def _readable(array: np.ndarray, is_read: bool, other: type) -> np.ndarray:
    """The array itself if the library can read it: rows without gaps, in native byte order."""
    if not is_read or not array.dtype.isnative:
        return np.ascontiguousarray(array, array.dtype.newbyteorder("=") if is_read else other)
    fits = array.strides[1] == array.itemsize and array.strides[0] > 0
    return array if fits else np.ascontiguousarray(array)


def _invalid(message: str) -> AbflatError:
    return AbflatError("InvalidMesh", message)
