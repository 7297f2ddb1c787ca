"""One layer without a mesh: exact colours at points, and the weights of the stops in them."""

from __future__ import annotations

import importlib
import threading
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import copied, rows_of
from ._colors import convert_colors
from ._errors import UsageError
from ._handle import Handle, Resource
from ._library import ffi, lib
from ._options import Option, encode
from ._session import Session, session_of

if TYPE_CHECKING:
    from ._document import Document

_attributes = {"color": lib.SFUMATO_COLOR, "opacity": lib.SFUMATO_OPACITY}


class Weights(NamedTuple):
    """The weight of each stop at points. `matrix @ values + paint` gives the exact values there, in
    the document's space for mixing colours."""

    matrix: Any
    """scipy.sparse.csr_matrix, points × stops, float64"""
    stops: NDArray[np.uint32]
    """for each column: curve, side (0 left, 1 right), stop"""
    values: NDArray[np.float64]
    """for each column: the value of the stop at the call, 3 numbers or 1"""
    paint: NDArray[np.float64]
    """for each point: the share of gradients and textures, 3 numbers or 1"""


class Field(Handle):
    """The exact colours of one layer at points, from Document.field(). Later edits of the document
    do not change it."""

    def __init__(self, document: "Document", layer: int, options: Mapping[str, Option]) -> None:
        count = len(document.layers)
        if not 0 <= layer < count:
            raise IndexError(f"there is no layer {layer} among {count}")
        self._document = document.copy()
        self._given: Optional[Session] = document._given
        self._layer, self._options = layer, dict(options)
        self._weights: dict[str, Resource] = {}
        self._one = threading.Lock()
        held = self._document._held()
        super().__init__(
            self._session.make(
                "field_new", held.pointer, layer, encode(options), reads=held, slow=True
            )
        )

    @property
    def _session(self) -> Session:
        return session_of(self._given)

    @property
    def layer(self) -> int:
        """The layer's index."""
        return self._layer

    def free(self) -> None:
        self._weights = {}
        self._document.free()
        super().free()

    def colors(self, points: ArrayLike) -> NDArray[np.float32]:
        """Returns n × 4: red, green, blue (sRGB, 0 to 1, not premultiplied) and opacity; all 0
        where no colour is visible. points: n × 2, in the frame of the layer, inside the viewport
        and not on a curve. Order the points so that neighbours in the list are close to each other;
        this is faster."""
        held, xy = self._held(), rows_of(points, 2, "points")
        out = np.empty((len(xy), 4), np.float32)
        self._session.call(
            "field_colors", held.pointer, ffi.from_buffer("double[]", xy), len(xy),
            ffi.from_buffer("float[]", out), reads=held, slow=True,
        )
        return out

    def weights(
        self, points: ArrayLike, of: str = "color", *, negligible: float = 0.0
    ) -> Weights:
        """Returns the weights of the stops in the values at points (n × 2 as for colors()). of:
        "color" or "opacity". negligible: smaller weights may be dropped; the rest is scaled up.

        The matrix stays valid while the curves, their blur and the offsets of their stops do not
        change; the values of the stops may change. Needs scipy. The first call prepares the layer.
        """
        sparse = importlib.import_module("scipy.sparse")
        if of not in _attributes:
            raise UsageError(f'{of!r}: expected "color" or "opacity"')
        held, xy, session = self._held(), rows_of(points, 2, "points"), self._session
        with self._one:
            made = self._weights.get(of) or self._prepare(of)
            session.call(
                "weights_at", made.pointer, ffi.from_buffer("double[]", xy), len(xy),
                float(negligible), changes=made, slow=True,
            )
            tables = [_table(made, i) for i in range(6)]
        del held
        begins, columns, weights, stops, values, paint = tables
        matrix = sparse.csr_matrix(
            (weights[:, 0].astype(np.float64), columns[:, 0], begins[:, 0]),
            shape=(len(xy), len(stops)),
        )
        return Weights(matrix, stops, values.astype(np.float64), paint.astype(np.float64))

    def set_values(self, document: "Document", stops: ArrayLike, values: ArrayLike) -> None:
        """Sets the colours of stops in a document that has the same curves as this field.

        stops, values: arrays in the form that weights() returns. The values use the colour space
        of the document's interpolation. Colours outside the sRGB gamut are clamped."""
        places, given = rows_of(stops, 3, "stops").astype(int), rows_of(values, 3, "values")
        if len(places) != len(given):
            raise ValueError(f"{len(places)} stops and {len(given)} values")
        codes = np.clip(convert_colors(given, document.interpolation, "srgb"), 0, 1)
        curves = document.layers[self._layer].curves
        for curve, side in sorted({(int(c), int(s)) for c, s, _ in places}):
            here = (places[:, 0] == curve) & (places[:, 1] == side)
            beside = curves[curve].right if side else curves[curve].left
            _, space, rows = beside.stops("color")
            rows = rows.copy()
            rows[places[here, 2], 1:] = codes[here]
            beside.set_stops("color", rows, space)

    def _prepare(self, of: str) -> Resource:
        held, options = self._document._held(), encode({**self._options, "ends": None})
        made = self._weights[of] = self._session.make(
            "weights_new", held.pointer, self._layer, _attributes[of], options,
            reads=held, slow=True,
        )
        return made

    def __repr__(self) -> str:
        return "<Field, freed>" if self.freed else f"<Field of layer {self._layer}>"


def _table(weights: Resource, which: int) -> NDArray[Any]:
    view = ffi.new("sfumato_view *")
    lib.sfumato_weights_table(weights.pointer, which, view)
    return copied(view)
