"""UV unwrapping with exact checks: seams, angle based flattening, packing, verifying."""

from ._abflat import __version__
from ._calls import flatten, pack, unwrap, verify
from ._errors import AbflatError
from ._generated import (
    FLATTEN_OPTIONS,
    PACK_OPTIONS,
    UNWRAP_OPTIONS,
    UV_FAULT,
    VERIFY_OPTIONS,
    OptionInfo,
)
from ._results import FlattenResult, PackResult, UnwrapResult, VerifyResult

__all__ = [
    "FLATTEN_OPTIONS",
    "PACK_OPTIONS",
    "UNWRAP_OPTIONS",
    "UV_FAULT",
    "VERIFY_OPTIONS",
    "AbflatError",
    "FlattenResult",
    "OptionInfo",
    "PackResult",
    "UnwrapResult",
    "VerifyResult",
    "__version__",
    "flatten",
    "pack",
    "unwrap",
    "verify",
]
