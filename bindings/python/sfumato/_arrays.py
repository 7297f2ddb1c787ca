"""numpy arrays and the library's tables, points and pixels."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._handle import Resource
from ._library import ffi, lib

Points = NDArray[np.float64]
_dtypes: dict[int, type[np.generic]] = {
    lib.SFUMATO_U8: np.uint8,
    lib.SFUMATO_U32: np.uint32,
    lib.SFUMATO_F32: np.float32,
    lib.SFUMATO_F64: np.float64,
}
_formats = {
    (3, "u1"): lib.SFUMATO_RGB8,
    (4, "u1"): lib.SFUMATO_RGBA8,
    (3, "u2"): lib.SFUMATO_RGB16,
    (4, "u2"): lib.SFUMATO_RGBA16,
}


class Export:
    """Keeps a resource's memory alive while an array is a view of it."""

    def __init__(self, view: Any, owner: Resource) -> None:
        self.owner = owner
        dtype = np.dtype(_dtypes[view.type])
        self.__array_interface__ = {
            "version": 3,
            "shape": (view.rows, view.columns),
            "typestr": dtype.str,
            "data": (int(ffi.cast("uintptr_t", view.data)), True),
            "strides": (view.row_bytes, dtype.itemsize),
        }


def empty_table(view: Any) -> NDArray[Any]:
    table: NDArray[Any] = np.empty((0, view.columns), _dtypes[view.type])
    table.flags.writeable = False
    return table


def copied(view: Any) -> NDArray[Any]:
    """Copies a table into an array that owns its memory."""
    table: NDArray[Any] = np.empty((view.rows, view.columns), _dtypes[view.type])
    if view.rows:
        assert view.row_bytes == view.columns * table.itemsize
        ffi.memmove(table, view.data, table.nbytes)
    return table


def numbers(values: ArrayLike, what: str) -> NDArray[np.float64]:
    """Returns real numbers as doubles. Raises TypeError for other values."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{what}: expected real numbers, not {array.dtype}")
    return np.ascontiguousarray(array, np.float64)


def rows_of(values: ArrayLike, columns: int, what: str) -> NDArray[np.float64]:
    """Returns doubles of shape n × columns. Raises ValueError for another shape."""
    array = numbers(values, what)
    if array.shape == (0,):
        array = array.reshape(0, columns)
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{what}: expected the shape (n, {columns}), not {array.shape}")
    return array


def fixed(array: NDArray[Any]) -> NDArray[Any]:
    """Makes a copy of a document's values read-only, because writing into the copy would not change
    the document."""
    array.flags.writeable = False
    return array


def pixels_of(array: NDArray[Any], what: str) -> Any:
    """Describes rows of pixels in place. Keep the array alive while the description is used."""
    if not isinstance(array, np.ndarray):
        raise TypeError(f"{what}: expected a numpy array, not {type(array).__name__}")
    if array.dtype not in (np.dtype(np.uint8), np.dtype(np.uint16)):
        raise TypeError(f"{what}: expected uint8 or uint16 of this machine, not {array.dtype}")
    if array.ndim != 3 or array.shape[2] not in (3, 4) or 0 in array.shape:
        raise ValueError(f"{what}: expected the shape (height, width, 3 or 4), not {array.shape}")
    height, width, channels = array.shape
    if max(height, width) > 0x7FFFFFFF:
        raise ValueError(f"{what}: more than 2147483647 pixels to a side")
    row = width * channels * array.itemsize
    step = array.strides[0] if height > 1 else row
    if array.strides[1:] != (channels * array.itemsize, array.itemsize) or step < row:
        raise ValueError(f"{what}: the pixels of a row are not one behind the other")
    kind = _formats[channels, array.dtype.str[1:]]
    first = ffi.cast("void *", array.ctypes.data)
    return ffi.new("sfumato_image *", (first, step, width, height, kind))


def picture_of(image: ArrayLike, what: str) -> NDArray[Any]:
    """Returns rows of pixels, copied only if necessary. Floats from 0 to 1 become 16-bit integers."""
    array = np.asarray(image)
    if array.dtype.kind == "f":
        # A NaN fails the comparison.
        if not np.all((array >= 0) & (array <= 1)):
            raise ValueError(f"{what}: expected floats from 0 to 1, or uint8 or uint16")
        array = np.round(array.astype(np.float64) * 65535).astype(np.uint16)
    if array.ndim == 2 and array.dtype.kind == "u":
        array = np.repeat(array[:, :, None], 3, axis=2)
    return np.ascontiguousarray(array)
