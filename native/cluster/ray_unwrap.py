"""Unwraps meshes that live in Python on the machines of a Ray cluster.

    pip install abflat ray

    import ray
    from ray_unwrap import unwrap_all

    ray.init(address="auto")
    for name, result, error in unwrap_all(meshes, in_flight=200, padding=4):
        ...

``meshes`` yields (name, positions, faces). Results come as they are done, in any order: what
abflat.unwrap returns, or the abflat.AbflatError of a mesh that cannot be unwrapped. At most
``in_flight`` meshes are in the cluster at a time, so ``meshes`` may be a generator of millions.
Ray runs a task again, on another machine, if its worker dies.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any, Optional

import abflat
import ray


@ray.remote(num_cpus=1, max_retries=3)
def unwrap_one(name: str, positions: Any, faces: Any, options: dict[str, Any]) -> tuple:
    """(name, result, error), of which one is None."""
    try:
        return name, abflat.unwrap(positions, faces, threads=1, **options), None
    except abflat.AbflatError as error:
        return name, None, error


def unwrap_all(
    meshes: Iterable[tuple[str, Any, Any]], in_flight: int = 100, **options: Any
) -> Iterator[tuple[str, Optional[abflat.UnwrapResult], Optional[abflat.AbflatError]]]:
    """Yields (name, result, error) for each mesh; ``options`` are those of abflat.unwrap."""
    running: list = []

    def finished() -> tuple:
        done, left = ray.wait(running, num_returns=1)
        running[:] = left
        return ray.get(done[0])

    for name, positions, faces in meshes:
        running.append(unwrap_one.remote(name, positions, faces, options))
        if len(running) >= in_flight:
            yield finished()
    while running:
        yield finished()
