"""The shared library and its functions for ctypes. This module knows nothing of documents."""

from __future__ import annotations

import ctypes
import os
from ctypes import POINTER, c_char_p, c_double, c_int32, c_size_t, c_uint32, c_void_p
from typing import Any

ABI = 1

# enum sfumato_status_code
OK, BAD_INPUT, LIMIT, CANCELLED, IO, OUT_OF_MEMORY, UNAVAILABLE, INTERNAL, BAD_USAGE = range(9)

# enum sfumato_table
VERTICES, TRIANGLES, CURVE_EDGES = range(3)
COLOR_NODES, COLOR_VALUES, OPACITY_NODES, OPACITY_VALUES = range(3, 7)

# enum sfumato_weights_table_name
ROW_BEGINS, COLUMNS, WEIGHTS, COLUMN_STOPS, COLUMN_VALUES, PAINT_VALUES = range(6)

LAST = 0xFFFFFFFF  # sfumato_insert_curve(): behind all others


class View(ctypes.Structure):
    """sfumato_view"""

    _fields_ = [
        ("data", c_void_p),
        ("rows", c_size_t),
        ("row_bytes", c_size_t),
        ("columns", c_uint32),
        ("type", c_uint32),
    ]


class Image(ctypes.Structure):
    """sfumato_image"""

    _fields_ = [
        ("pixels", c_void_p),
        ("row_bytes", c_size_t),
        ("width", c_int32),
        ("height", c_int32),
        ("format", c_int32),
    ]


class TraceState(ctypes.Structure):
    """sfumato_trace_state"""

    _fields_ = [
        ("psnr_db", c_double),
        ("seconds", c_double),
        ("round", c_uint32),
        ("round_count", c_uint32),
        ("curves", c_uint32),
        ("control_points", c_uint32),
        ("stops", c_uint32),
    ]


PROGRESS = ctypes.CFUNCTYPE(None, c_void_p, c_char_p, c_double)
DELIVER = ctypes.CFUNCTYPE(None, c_void_p, c_char_p, c_size_t)
LOAD = ctypes.CFUNCTYPE(c_int32, c_void_p, c_char_p, DELIVER, c_void_p)
REACHED = ctypes.CFUNCTYPE(None, c_void_p, POINTER(TraceState), c_void_p)


class Loader(ctypes.Structure):
    """sfumato_loader"""

    _fields_ = [("load", LOAD), ("user", c_void_p)]


class Watch(ctypes.Structure):
    """sfumato_trace_watch"""

    _fields_ = [("reached", REACHED), ("user", c_void_p)]


_handle = c_void_p
_out = POINTER(c_void_p)
_box = POINTER(c_double)
_numbers = c_void_p  # of an array that the caller keeps alive

# Each function's result type, then its argument types.
_signatures: dict[str, tuple[Any, ...]] = {
    "version": (c_char_p,),
    "abi": (c_uint32,),
    "context_new": (c_void_p, c_char_p),
    "context_free": (None, _handle),
    "error_text": (c_char_p, _handle),
    "error_file": (c_char_p, _handle),
    "error_place": (None, _handle, POINTER(c_int32), POINTER(c_int32)),
    "warning": (c_char_p, _handle, c_size_t),
    "set_progress": (None, _handle, PROGRESS, c_void_p),
    "cancel": (None, _handle),
    "resume": (None, _handle),
    "bytes_data": (c_void_p, _handle),
    "bytes_size": (c_size_t, _handle),
    "bytes_free": (None, _handle),
    "read": (c_int32, _handle, c_char_p, c_size_t, c_char_p, POINTER(Loader), _out),
    "import_svg": (c_int32, _handle, c_char_p, c_size_t, c_char_p, POINTER(Loader), _out),
    "document_new": (c_int32, _handle, c_char_p, _out),
    "document_copy": (c_int32, _handle, _handle, _out),
    "document_free": (None, _handle),
    "document_write": (c_int32, _handle, _handle, _out),
    "lint": (c_int32, _handle, _handle, c_char_p, _out),
    "document_artboard": (c_int32, _handle, _box),
    "document_interpolation": (c_int32, _handle),
    "layer_count": (c_uint32, _handle),
    "curve_count": (c_uint32, _handle, c_uint32),
    "layer_id": (c_char_p, _handle, c_uint32),
    "curve_id": (c_char_p, _handle, c_uint32, c_uint32),
    "curve_points": (c_int32, _handle, c_uint32, c_uint32, POINTER(View)),
    "set_curve_points": (c_int32, _handle, _handle, c_uint32, c_uint32, _numbers, c_size_t),
    "curve_stops": (
        c_size_t, _handle, c_uint32, c_uint32, c_uint32, c_uint32,
        POINTER(c_int32), POINTER(c_int32), _numbers, c_size_t,
    ),
    "set_curve_stops": (
        c_int32, _handle, _handle, c_uint32, c_uint32, c_uint32, c_uint32,
        c_int32, c_int32, _numbers, c_size_t,
    ),
    "curve_weight": (c_double, _handle, c_uint32, c_uint32),
    "set_curve_weight": (c_int32, _handle, _handle, c_uint32, c_uint32, c_double),
    "insert_curve": (c_int32, _handle, _handle, c_uint32, c_uint32, _numbers, c_size_t),
    "remove_curve": (c_int32, _handle, _handle, c_uint32, c_uint32),
    "solve": (c_int32, _handle, _handle, c_char_p, _out),
    "solve_again": (c_int32, _handle, _handle, c_int32, _handle),
    "solve_next": (c_int32, _handle, _handle, _handle),
    "picture_write": (c_int32, _handle, _handle, _out),
    "picture_read": (c_int32, _handle, c_char_p, c_size_t, _out),
    "picture_free": (None, _handle),
    "picture_viewport": (c_int32, _handle, _box),
    "picture_layer_count": (c_uint32, _handle),
    "picture_table": (c_int32, _handle, c_uint32, c_uint32, POINTER(View)),
    "picture_changes": (c_int32, _handle, c_uint32, c_uint32, POINTER(View)),
    "picture_statistic": (c_double, _handle, c_uint32),
    "raster": (c_int32, _handle, _handle, POINTER(Image), c_char_p),
    "export": (c_int32, _handle, _handle, c_char_p, c_char_p, _out),
    "encode": (c_int32, _handle, POINTER(Image), c_char_p, c_char_p, _out),
    "trace": (c_int32, _handle, POINTER(Image), c_char_p, POINTER(Watch), _out),
    "fit_colors": (c_int32, _handle, _handle, POINTER(Image), c_char_p, _out),
    "field_new": (c_int32, _handle, _handle, c_uint32, c_char_p, _out),
    "field_free": (None, _handle),
    "field_colors": (c_int32, _handle, _handle, _numbers, c_size_t, _numbers),
    "weights_new": (c_int32, _handle, _handle, c_uint32, c_uint32, c_char_p, _out),
    "weights_free": (None, _handle),
    "weights_at": (c_int32, _handle, _handle, _numbers, c_size_t, c_double),
    "weights_table": (c_int32, _handle, c_uint32, POINTER(View)),
    "convert_colors": (c_int32, c_int32, c_int32, _numbers, c_size_t, _numbers),
}


def _load() -> Any:
    """Loads the library that SFUMATO_LIBRARY names, the library beside this file, or the system's."""
    name = "libsfumato.so.1"
    beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), name)
    path = os.environ.get("SFUMATO_LIBRARY") or (beside if os.path.exists(beside) else name)
    try:
        loaded = ctypes.CDLL(path)
    except OSError as error:
        raise ImportError(f"Sfumato's library cannot be loaded: {error}") from error
    for name, (result, *arguments) in _signatures.items():
        try:
            function = getattr(loaded, "sfumato_" + name)
        except AttributeError:
            raise ImportError(f"{path} is too old for this package: no sfumato_{name}") from None
        function.restype, function.argtypes = result, arguments
    if loaded.sfumato_abi() != ABI:
        raise ImportError(f"{path} has ABI {loaded.sfumato_abi()}, this package needs {ABI}")
    return loaded


lib = _load()
