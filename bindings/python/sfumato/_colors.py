"""Colours, stops, and the spaces for mixing colours."""

from __future__ import annotations

import ctypes
import functools
from typing import Any, Optional, Sequence, Union
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _library
from ._arrays import address_of, numbers
from ._errors import InputError, UsageError
from ._library import lib
from ._session import session_of

SPACES = ("srgb", "linear", "oklab")
Color = Union[str, Sequence[float], NDArray[Any]]
Colors = Union[None, Color, Sequence[Color], NDArray[Any]]

# enum sfumato_kind
KINDS = ("open", "barrier", "stops", "paint")
OPEN, BARRIER, STOPS = range(3)


def convert_colors(colors: ArrayLike, source: str, target: str) -> NDArray[np.float64]:
    """Converts colours to another space and returns them. colors: n × 3, or 3 numbers, in the space
    `source`. The spaces are "srgb" (code values, 0 to 1), "linear" (light, 0 to 1) and "oklab" (L,
    a, b). Nothing is clamped."""
    for space in (source, target):
        if space not in SPACES:
            raise UsageError(f"{space!r} is not a colour space; use one of {', '.join(SPACES)}")
    array = numbers(colors, "colours").copy()
    if array.ndim == 0 or array.shape[-1] != 3:
        raise ValueError(f"colours: expected the shape (n, 3), not {array.shape}")
    at, of = SPACES.index(source), SPACES.index(target)
    place = address_of(array)
    lib.sfumato_convert_colors(at, of, place, array.size // 3, place)
    return array


@functools.lru_cache(maxsize=1024)
def _read(text: str) -> tuple[int, tuple[tuple[float, float, float, float], ...]]:
    """Returns the kind and the stops of a text for sf:left."""
    drawing = (
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 1 1"'
        ' sf:version="1">'
        f'<g sf:diffuse="true"><path d="M0 0L1 0" sf:left={quoteattr(text)}/></g></svg>'
    )
    try:
        kind, rows = _left_stops(drawing.encode())
    except InputError as error:
        raise InputError(f"{text!r} is not a colour: {error.reason}") from None
    if kind == KINDS.index("paint"):
        raise InputError(f"{text!r}: gradients and textures are made by files alone")
    return kind, tuple((at, r, g, b) for at, r, g, b in rows.tolist())


def _left_stops(drawing: bytes) -> tuple[int, NDArray[np.float64]]:
    """Returns the kind and the colour stops of the left side of a drawing's first curve."""
    free = lib.sfumato_document_free
    held = session_of(None).make("read", free, drawing, len(drawing), b"text", None)
    kind = ctypes.c_int32()
    place = (held.address, 0, 0, 0, 0)  # layer, curve, side, attribute
    count = lib.sfumato_curve_stops(*place, kind, None, None, 0)
    rows = np.empty((count, 4))
    lib.sfumato_curve_stops(*place, None, None, address_of(rows), count)
    return kind.value, rows


def _color(color: Color) -> NDArray[np.float64]:
    """Returns the code values of one colour."""
    if isinstance(color, str):
        kind, rows = _read(color)
        if kind != STOPS or len(rows) != 1 or rows[0][0] != 0:
            raise InputError(f"{color!r} is not one colour")
        return np.array(rows[0][1:])
    array = numbers(color, "a colour")
    if array.shape != (3,):
        raise ValueError(f"a colour: expected 3 numbers, not the shape {array.shape}")
    return array


def spread(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Returns rows of stops at even distances."""
    columns = values if values.ndim == 2 else values[:, None]
    return np.column_stack([np.linspace(0, 1, len(columns)), columns])


class Given:
    """A caller's value for a side: the kind, the rows if it has stops, and whether the rows hold
    offsets."""

    def __init__(
        self, kind: int, rows: Optional[NDArray[np.float64]] = None, has_offsets: bool = False
    ) -> None:
        self.kind, self.has_offsets = kind, has_offsets
        self.rows = np.empty((0, 0)) if rows is None else np.ascontiguousarray(rows)


def colors_given(colors: Colors) -> Given:
    if colors is None:
        return Given(OPEN)
    if isinstance(colors, str):
        kind, rows = _read(colors)
        return Given(kind, np.array(rows) if kind == STOPS else None)
    if not isinstance(colors, np.ndarray) and any(isinstance(c, str) for c in colors):
        return Given(STOPS, spread(np.array([_color(c) for c in colors])))  # type: ignore[arg-type]
    array = numbers(colors, "colours")  # type: ignore[arg-type]
    if array.ndim == 1:
        return Given(STOPS, spread(_color(array)[None]))
    if array.ndim != 2 or array.shape[1] not in (3, 4) or len(array) == 0:
        raise ValueError(
            "colours: expected names, n × 3 (red, green, blue) or n × 4 (offset before them), not the"
            f" shape {array.shape}"
        )
    return Given(STOPS, array, True) if array.shape[1] == 4 else Given(STOPS, spread(array))


def scalars_given(values: Union[None, str, ArrayLike], what: str) -> Given:
    if values is None:
        return Given(OPEN)
    if isinstance(values, str):
        if values != "none":
            raise UsageError(f'{what}: expected numbers, "none" or None, not {values!r}')
        return Given(BARRIER)
    array = numbers(values, what)
    if array.ndim == 0:
        array = array[None]
    if array.ndim == 1 and len(array) > 0:
        return Given(STOPS, spread(array))
    if array.ndim != 2 or array.shape[1] != 2 or len(array) == 0:
        raise ValueError(f"{what}: expected n numbers or n × 2 (offset, value), not {array.shape}")
    return Given(STOPS, array, True)
