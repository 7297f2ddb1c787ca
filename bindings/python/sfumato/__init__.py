"""Diffusion curves: curves with a colour on each side, and the pictures that they define.

    import sfumato

    drawing = sfumato.open("drawing.svg")
    drawing.layers[0].curves[3].left = ["#f00", "#00f"]
    image = drawing.render(width=1024)  # numpy: height × width × 3, uint8

See docs/python.md for the guide.
"""

from ._colors import convert_colors
from ._curves import Curve, Curves, Layer, Side
from ._document import Document, ImportedSvg, combine_paths, import_svg, open, read
from ._errors import (
    Cancelled,
    DrawingWarning,
    Error,
    InputError,
    LimitError,
    UnavailableError,
    UsageError,
    text_of as _text_of,
)
from ._field import Field, Weights
from ._library import lib as _lib
from ._picture import Interactive, Picture, load_picture
from ._session import Session
from ._trace import Round, trace

__version__: str = _text_of(_lib.sfumato_version())

__all__ = [
    "Cancelled",
    "Curve",
    "Curves",
    "Document",
    "DrawingWarning",
    "Error",
    "Field",
    "ImportedSvg",
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
    "combine_paths",
    "convert_colors",
    "import_svg",
    "load_picture",
    "open",
    "read",
    "trace",
]
