"""Colours, stops, and the spaces for mixing colours."""

from __future__ import annotations

import functools
from typing import Any, Optional, Sequence, Union
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import numbers
from ._errors import InputError, UsageError
from ._handle import Resource
from ._library import ffi, lib, names_of
from ._session import session_of

SPACES = names_of("sfumato_interpolation")
KINDS = names_of("sfumato_kind")
Color = Union[str, Sequence[float], NDArray[Any]]
Colors = Union[None, Color, Sequence[Color], NDArray[Any]]


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
    place = ffi.from_buffer("double[]", array)
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
        data = drawing.encode()
        held = session_of(None).make("read", data, len(data), b"text", ffi.NULL)
    except InputError as error:
        raise InputError(f"{text!r} is not a colour: {error.reason}") from None
    kind, _, rows = stops_of(held, 0, 0, lib.SFUMATO_LEFT, lib.SFUMATO_COLOR)
    if kind == lib.SFUMATO_PAINT:
        raise InputError(f"{text!r}: gradients and textures are made by files alone")
    return kind, tuple((at, r, g, b) for at, r, g, b in rows.tolist())


def stops_of(
    drawing: Resource, layer: int, curve: int, side: int, attribute: int
) -> tuple[int, int, NDArray[np.float64]]:
    """Returns the kind of a side, the space of the offsets, and the rows of its stops. The caller
    holds the drawing."""
    kind, space = ffi.new("int32_t *"), ffi.new("int32_t *")
    place = (drawing.pointer, layer, curve, side, attribute)
    count = lib.sfumato_curve_stops(*place, kind, space, ffi.NULL, 0)
    rows = np.empty((count, 4 if attribute == lib.SFUMATO_COLOR else 2))
    lib.sfumato_curve_stops(*place, ffi.NULL, ffi.NULL, ffi.from_buffer("double[]", rows), count)
    return kind[0], space[0], rows


def _color(color: Color) -> NDArray[np.float64]:
    """Returns the code values of one colour."""
    if isinstance(color, str):
        kind, rows = _read(color)
        if kind != lib.SFUMATO_STOPS or len(rows) != 1 or rows[0][0] != 0:
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
        return Given(lib.SFUMATO_OPEN)
    if isinstance(colors, str):
        kind, rows = _read(colors)
        return Given(kind, np.array(rows) if kind == lib.SFUMATO_STOPS else None)
    if not isinstance(colors, np.ndarray) and any(isinstance(c, str) for c in colors):
        return Given(lib.SFUMATO_STOPS, spread(np.array([_color(c) for c in colors])))  # type: ignore[arg-type]
    array = numbers(colors, "colours")  # type: ignore[arg-type]
    if array.ndim == 1:
        return Given(lib.SFUMATO_STOPS, spread(_color(array)[None]))
    if array.ndim != 2 or array.shape[1] not in (3, 4) or len(array) == 0:
        raise ValueError(
            "colours: expected names, n × 3 (red, green, blue) or n × 4 (offset before them), not the"
            f" shape {array.shape}"
        )
    return Given(lib.SFUMATO_STOPS, array, True) if array.shape[1] == 4 else Given(lib.SFUMATO_STOPS, spread(array))


def scalars_given(values: Union[None, str, ArrayLike], what: str) -> Given:
    if values is None:
        return Given(lib.SFUMATO_OPEN)
    if isinstance(values, str):
        if values != "none":
            raise UsageError(f'{what}: expected numbers, "none" or None, not {values!r}')
        return Given(lib.SFUMATO_BARRIER)
    array = numbers(values, what)
    if array.ndim == 0:
        array = array[None]
    if array.ndim == 1 and len(array) > 0:
        return Given(lib.SFUMATO_STOPS, spread(array))
    if array.ndim != 2 or array.shape[1] != 2 or len(array) == 0:
        raise ValueError(f"{what}: expected n numbers or n × 2 (offset, value), not {array.shape}")
    return Given(lib.SFUMATO_STOPS, array, True)
