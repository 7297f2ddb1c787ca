"""What goes wrong, in Python's own form."""

from __future__ import annotations

import ctypes
from typing import Optional

from . import _library
from ._library import lib


class Error(Exception):
    """Whatever the library refuses.

    reason: the words without the place. file, line, column: where in an input it is; "" and 0 where
    that is not known. Lines and columns (in bytes) count from 1.
    """

    def __init__(self, reason: str, file: str = "", line: int = 0, column: int = 0) -> None:
        place = [part for part in (file, str(line or ""), str(column or "")) if part]
        super().__init__(": ".join([":".join(place), reason] if place else [reason]))
        self.reason, self.file, self.line, self.column = reason, file, line, column

    def __reduce__(self) -> tuple[type[Error], tuple[str, str, int, int]]:
        return type(self), (self.reason, self.file, self.line, self.column)


class InputError(Error, ValueError):
    """An input that cannot be understood or drawn; file, line and column say where."""


class UsageError(Error, ValueError):
    """An option, or a value of one, that the call does not take."""


class LimitError(Error):
    """A limit, the budget of memory (max_memory) or the time (max_time) of a session."""


class Cancelled(Error):
    """Session.cancel() was called."""


class UnavailableError(Error):
    """This build of the library cannot do it."""


class DrawingWarning(UserWarning):
    """What a drawing has that the library left out, or an output cannot show."""


_classes: dict[int, type[Error]] = {
    _library.BAD_INPUT: InputError,
    _library.LIMIT: LimitError,
    _library.CANCELLED: Cancelled,
    _library.UNAVAILABLE: UnavailableError,
    _library.BAD_USAGE: UsageError,
}


def error_of(context: int, status: int) -> Optional[Exception]:
    """What the last call with a context ended by; None after success."""
    if status == _library.OK:
        return None
    reason = text_of(lib.sfumato_error_text(context))
    if status == _library.OUT_OF_MEMORY:
        return MemoryError(reason or "out of memory")
    line, column = ctypes.c_int32(), ctypes.c_int32()
    lib.sfumato_error_place(context, line, column)
    file = text_of(lib.sfumato_error_file(context))
    return _classes.get(status, Error)(reason, file, line.value, column.value)


def text_of(words: Optional[bytes]) -> str:
    """A string of the library's, which may hold bytes of a file that are no UTF-8."""
    return (words or b"").decode("utf-8", "replace")
