"""Writes an OBJ file."""

from __future__ import annotations

from os import PathLike
from typing import Any, Union

from ._arrays import faces, points


def export(
    path: Union[str, "PathLike[str]"],
    positions: Any,
    indices: Any = None,
    uvs: Any = None,
    normals: Any = None,
) -> None:
    vertices = points("Position", positions, 3)
    lines = [_line("v", row) for row in vertices]
    if normals is not None:
        lines += [_line("vn", row) for row in points("Normal", normals, 3, len(vertices))]
    if uvs is not None:
        lines += [_line("vt", row) for row in points("Texture coordinates", uvs, 2, len(vertices))]
    if indices is not None:
        corner = "{0}"
        if uvs is not None or normals is not None:
            corner += "/{0}" if uvs is not None else "/"
        if normals is not None:
            corner += "/{0}"
        for face in faces(indices) + 1:
            lines.append("f " + " ".join(corner.format(vertex) for vertex in face))
    with open(path, "w", encoding="ascii") as file:
        file.writelines(f"{line}\n" for line in lines)


def _line(word: str, numbers: Any) -> str:
    return " ".join([word, *(format(number, ".9g") for number in numbers)])
