from typing import Any, Optional

import numpy as np

__version__: str

class MeshArrays:
    def __init__(
        self,
        positions: np.ndarray,
        vertices: np.ndarray,
        offsets: Optional[np.ndarray],
        texcoords: Optional[np.ndarray],
        texcoord_of_corner: Optional[np.ndarray],
        material_of_face: Optional[np.ndarray],
        object_of_vertex: Optional[np.ndarray],
    ) -> None: ...

_Values = dict[str, Any]

def unwrap(mesh: MeshArrays, options: _Values, extras: _Values, progress: Any) -> _Values: ...
def flatten(mesh: MeshArrays, options: _Values, extras: _Values, progress: Any) -> _Values: ...
def pack(mesh: MeshArrays, options: _Values, extras: _Values, progress: Any) -> _Values: ...
def verify(mesh: MeshArrays, options: _Values, progress: Any) -> _Values: ...
