"""Drawings of pictures."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any, Callable, Optional

from numpy.typing import ArrayLike

from . import _library
from ._arrays import picture_of, pixels_of
from ._document import Document
from ._handle import Resource
from ._library import lib
from ._options import Option, encode
from ._session import Session, session_of


@dataclass(frozen=True)
class Round:
    """What a trace has reached."""

    psnr_db: float
    """to the picture as it is looked at; 0: not known yet"""
    seconds: float
    round: int
    """0: edges of the picture alone; then edges of what is missing"""
    round_count: int
    """at most, with round 0"""
    curves: int
    control_points: int
    stops: int


def trace(
    image: ArrayLike,
    *,
    on_round: Optional[Callable[[Round, Document], object]] = None,
    session: Optional[Session] = None,
    **options: Option,
) -> Document:
    """A drawing of a picture: curves along its edges, whose colours and blur are fitted. The artboard is
    the picture, a unit to a pixel. Takes seconds.

    image: height × width × 3 or 4, or height × width of grey, uint8 or uint16. on_round: told, in this
    thread, what has been reached and the drawing by then, which is lent until the function returns:
    copy() it to keep it. options: points or detail (0 to 1), psnr, smooth, stops, blur, max_curves,
    max_side, seed, edges_only, no_alpha, texture, as of `sfumato trace`.
    """
    chosen, array = session_of(session), picture_of(image, "image")
    pixels = pixels_of(array, "image")

    def reached(_: Any, state: Any, drawing: int) -> None:
        at = state.contents
        names = [name for name, _ in _library.TraceState._fields_]
        now = Round(**{name: getattr(at, name) for name in names})

        def answer() -> None:
            assert on_round is not None
            with Document(Resource(drawing, None), chosen) as lent:
                on_round(now, lent)

        chosen.ask(answer)

    watch = _library.Watch(_library.REACHED(reached), None)
    given = ctypes.byref(watch) if on_round is not None else None
    free = lib.sfumato_document_free
    made = chosen.make("trace", free, ctypes.byref(pixels), encode(options), given, slow=True)
    return Document(made, session)
