"""The error of abflat."""


class AbflatError(Exception):
    """A call without a result. ``code`` is the name of a status, such as ``"EmptyMesh"``."""

    __module__ = "abflat"

    def __init__(self, code: str, message: str) -> None:
        super().__init__(message)
        self.code = code
        self.message = message

    def __reduce__(self):
        return type(self), (self.code, self.message)
