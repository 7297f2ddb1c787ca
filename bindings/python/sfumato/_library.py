"""The shared library, and the types, constants and functions of sfumato.h. This module knows nothing of
documents."""

from __future__ import annotations

import os
from typing import Any

from ._interface import ffi as _ffi

ffi: Any = _ffi


def _load() -> Any:
    """Loads the library that SFUMATO_LIBRARY names, the library beside this file, or the system's."""
    name = "libsfumato.so.1"
    beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), name)
    path = os.environ.get("SFUMATO_LIBRARY") or (beside if os.path.exists(beside) else name)
    try:
        # At exit the interpreter would unload the library while other threads may still run in it.
        loaded = ffi.dlopen(path, ffi.RTLD_NODELETE)
    except OSError as error:
        raise ImportError(f"Sfumato's library cannot be loaded: {error}") from error
    try:
        for function in dir(loaded):
            getattr(loaded, function)
    except ffi.error as error:
        raise ImportError(f"{path} is too old for this package: {error}") from None
    if loaded.sfumato_abi() != loaded.SFUMATO_ABI:
        raise ImportError(
            f"{path} has ABI {loaded.sfumato_abi()}, this package needs {loaded.SFUMATO_ABI}"
        )
    return loaded


lib = _load()


def names_of(enumeration: str) -> tuple[str, ...]:
    """Returns the names of values 0, 1, ..., for example ("left", "right") for "sfumato_side"."""
    names = ffi.typeof(f"enum {enumeration}").elements
    return tuple(names[i].removeprefix("SFUMATO_").lower() for i in range(len(names)))


def member_type(structure: str, member: str) -> Any:
    """Returns the type of a structure's member, such as a pointer to a function."""
    return dict(ffi.typeof(structure).fields)[member].type
