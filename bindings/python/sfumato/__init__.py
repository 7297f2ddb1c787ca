"""Diffusion curves: pictures of curves that carry a colour on each side.

    import sfumato

    drawing = sfumato.open("drawing.svg")
    drawing.layers[0].curves[3].left = ["#f00", "#00f"]
    image = drawing.render(width=1024)  # numpy: height × width × 3, uint8

docs/python.md is the guide.
"""

from ._colors import convert_colors
from ._curves import Curve, Curves, Layer, Side
from ._document import Document, open, read
from ._errors import (
    Cancelled,
    DrawingWarning,
    Error,
    InputError,
    LimitError,
    UnavailableError,
    UsageError,
)
from ._field import Field, Weights
from ._library import lib as _lib
from ._picture import Interactive, Picture, load_picture
from ._session import Session
from ._trace import Round, trace

__version__: str = _lib.sfumato_version().decode()

__all__ = [
    "Cancelled",
    "Curve",
    "Curves",
    "Document",
    "DrawingWarning",
    "Error",
    "Field",
    "InputError",
    "Interactive",
    "Layer",
    "LimitError",
    "Picture",
    "Round",
    "Session",
    "Side",
    "UnavailableError",
    "UsageError",
    "Weights",
    "convert_colors",
    "load_picture",
    "open",
    "read",
    "trace",
]
