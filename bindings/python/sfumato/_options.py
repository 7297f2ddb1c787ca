"""Converts keyword arguments to the library's string of options."""

from __future__ import annotations

import re
from numbers import Integral, Real
from typing import Iterable, Mapping, Union

from ._errors import UsageError

Option = Union[None, bool, int, float, str, Iterable[float]]

_key = re.compile(r"[a-z][a-z0-9.-]*")


def _number(value: object) -> str:
    if isinstance(value, Integral):
        return str(int(value))
    if isinstance(value, Real):
        return repr(float(value))
    raise TypeError(f"an option is text, numbers or True, not {type(value).__name__}")


def _text(value: Option) -> str:
    if isinstance(value, str):
        if "\0" in value:
            raise UsageError("an option has a zero byte in it")
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    if isinstance(value, Real):
        return _number(value)
    if isinstance(value, Iterable) and not isinstance(value, (bytes, bytearray)):
        return ",".join(map(_number, value))
    raise TypeError(f"an option is text, numbers or True, not {type(value).__name__}")


def encode(options: Mapping[str, Option]) -> bytes:
    """Returns the string, for example b"max-error=2 no-blur viewport=0,0,9,9" for max_error=2,
    no_blur=True, viewport=(0, 0, 9, 9).

    None and False leave an option out.
    """
    words = []
    for name, value in options.items():
        key = name.replace("_", "-")
        if not _key.fullmatch(key):
            raise UsageError(f"unknown option {name!r}")
        if value is None or value is False:
            continue
        words.append(key if value is True else f"{key}={_text(value)}")
    return " ".join(words).encode("utf-8", "surrogateescape")
