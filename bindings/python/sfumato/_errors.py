"""Errors and warnings as Python exceptions."""

from __future__ import annotations

from typing import Any, Optional

from ._library import ffi, lib


class Error(Exception):
    """Base class of all errors of the library.

    reason: the message without its place. file, line, column: the place in an input; "" and 0 if
    unknown. Lines and columns (in bytes) count from 1.
    """

    def __init__(self, reason: str, file: str = "", line: int = 0, column: int = 0) -> None:
        place = [part for part in (file, str(line or ""), str(column or "")) if part]
        super().__init__(": ".join([":".join(place), reason] if place else [reason]))
        self.reason, self.file, self.line, self.column = reason, file, line, column

    def __reduce__(self) -> tuple[type[Error], tuple[str, str, int, int]]:
        return type(self), (self.reason, self.file, self.line, self.column)


class InputError(Error, ValueError):
    """The input cannot be understood or drawn; file, line and column give the place."""


class UsageError(Error, ValueError):
    """The call does not accept an option, or a value of one."""


class LimitError(Error):
    """A limit, the memory budget (max_memory) or the time (max_time) of a session was exceeded."""


class Cancelled(Error):
    """Session.cancel() was called."""


class UnavailableError(Error):
    """This build of the library does not have the feature."""


class DrawingWarning(UserWarning):
    """The library left out content of a drawing, or an output cannot show it."""


_classes: dict[int, type[Error]] = {
    lib.SFUMATO_BAD_INPUT: InputError,
    lib.SFUMATO_LIMIT: LimitError,
    lib.SFUMATO_CANCELLED: Cancelled,
    lib.SFUMATO_UNAVAILABLE: UnavailableError,
    lib.SFUMATO_BAD_USAGE: UsageError,
}


def error_of(context: Any, status: int) -> Optional[Exception]:
    """Returns the error of the last call with a context; None after success."""
    if status == lib.SFUMATO_OK:
        return None
    reason = text_of(lib.sfumato_error_text(context))
    if status == lib.SFUMATO_OUT_OF_MEMORY:
        return MemoryError(reason or "out of memory")
    line, column = ffi.new("int32_t *"), ffi.new("int32_t *")
    lib.sfumato_error_place(context, line, column)
    file = text_of(lib.sfumato_error_file(context))
    return _classes.get(status, Error)(reason, file, line[0], column[0])


def text_of(words: Any) -> str:
    """Decodes a string of the library; NULL is "". It may contain bytes of a file that are not UTF-8."""
    text: bytes = ffi.string(words) if words else b""
    return text.decode("utf-8", "replace")
