"""Tracing: drawings made from pictures."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, Callable, Optional

from numpy.typing import ArrayLike

from ._arrays import picture_of, pixels_of
from ._document import Document
from ._handle import Resource
from ._library import ffi, member_type
from ._options import Option, encode
from ._session import Session, session_of


@dataclass(frozen=True)
class Round:
    """The progress of a trace."""

    psnr_db: float
    """of the result against the picture, as the picture is compared; 0: not known yet"""
    seconds: float
    round: int
    """0: only edges of the picture; later rounds add edges where something is missing"""
    round_count: int
    """the largest possible count, round 0 included"""
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
    """Traces a picture: returns a drawing with curves along its edges and with fitted colours and
    blur. The artboard is the picture, one unit per pixel. A trace takes seconds.

    image: height × width × 3 or 4, or height × width for grey; uint8, uint16, or floats from 0 to
    1. on_round: called after each round, in this thread, with the progress and the drawing so far.
    The drawing is valid only until the function returns; call copy() to keep it. options: points or
    detail (0 to 1), psnr, smooth, stops, blur, max_curves, max_side, seed, edges_only, no_alpha,
    texture, as for `sfumato trace`. If the session's time runs out, the result is the drawing of
    the last finished round.
    """
    chosen, array = session_of(session), picture_of(image, "image")
    pixels = pixels_of(array, "image")

    def reached(_: Any, state: Any, drawing: Any) -> None:
        now = Round(*(getattr(state, field.name) for field in fields(Round)))

        def answer() -> None:
            assert on_round is not None
            with Document(Resource(drawing), chosen) as lent:
                on_round(now, lent)

        chosen.ask(answer)

    called = ffi.callback(member_type("sfumato_trace_watch", "reached"), reached)
    watch = ffi.new("sfumato_trace_watch *", {"reached": called})
    given = watch if on_round is not None else ffi.NULL
    made = chosen.make("trace", pixels, encode(options), given, slow=True)
    return Document(made, session)
