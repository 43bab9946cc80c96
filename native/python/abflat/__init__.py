"""UV unwrapping with exact checks: seams, angle based flattening, packing."""

from ._abflat import __version__
from ._calls import flatten, pack, unwrap
from ._errors import AbflatError
from ._generated import FLATTEN_OPTIONS, PACK_OPTIONS, UNWRAP_OPTIONS, OptionInfo
from ._results import FlattenResult, PackResult, UnwrapResult

__all__ = [
    "FLATTEN_OPTIONS",
    "PACK_OPTIONS",
    "UNWRAP_OPTIONS",
    "AbflatError",
    "FlattenResult",
    "OptionInfo",
    "PackResult",
    "UnwrapResult",
    "__version__",
    "flatten",
    "pack",
    "unwrap",
]
