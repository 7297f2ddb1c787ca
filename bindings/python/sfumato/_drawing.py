"""The base of documents, and types of parameters and results that several modules name."""

from __future__ import annotations

import os
from typing import Any, Callable, Optional, Union

from ._handle import Handle, Resource
from ._library import ffi
from ._session import Session, session_of

Box = tuple[float, float, float, float]
Load = Callable[[str], bytes]
Path = Union[str, "os.PathLike[str]"]
Text = Union[str, bytes, bytearray, memoryview]


def box_of(function: Callable[..., int], pointer: Any) -> Box:
    box = ffi.new("double[4]")
    function(pointer, box)
    return (box[0], box[1], box[2], box[3])


class Drawing(Handle):
    """A document's memory and its session: modules that Document imports use only these."""

    def __init__(self, resource: Resource, session: Optional[Session]) -> None:
        super().__init__(resource)
        self._given = session

    @property
    def _session(self) -> Session:
        return session_of(self._given)
