"""Layers, curves and sides of a document. These objects only refer to the document, which holds the
data."""

from __future__ import annotations

from collections.abc import Sequence as AbstractSequence
from typing import TYPE_CHECKING, Any, Callable, Optional, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import copied, fixed, rows_of
from ._colors import KINDS, Colors, Given, colors_given, scalars_given, stops_of
from ._errors import UsageError, text_of
from ._library import ffi, lib, names_of
from ._settable import Settable

if TYPE_CHECKING:
    from ._document import Document

_attributes = names_of("sfumato_attribute")
_spaces = ("length", "pieces")  # enum sfumato_space
Scalars = Union[None, str, ArrayLike]


class Layer:
    """A layer of a document: curves whose colours mix."""

    def __init__(self, document: "Document", index: int) -> None:
        self._document, self._index = document, index

    @property
    def document(self) -> "Document":
        return self._document

    @property
    def index(self) -> int:
        return self._index

    @property
    def id(self) -> str:
        """The id of the layer; may be ""."""
        held = self._document._held()
        with held.lock:
            return text_of(lib.sfumato_layer_id(held.pointer, self._index))

    def _count(self) -> int:
        """Returns the curve count. The caller holds the document."""
        return int(lib.sfumato_curve_count(self._document._held().pointer, self._index))

    @property
    def curves(self) -> "Curves":
        """The curves in drawing order, always up to date."""
        return Curves(self)

    def add(
        self,
        points: ArrayLike,
        left: Colors = None,
        right: Colors = None,
        *,
        blur: Scalars = None,
        opacity: Scalars = None,
        at: Optional[int] = None,
    ) -> "Curve":
        """Adds a curve and returns it. points: the 3 n + 1 control points of n Bézier pieces, shape
        (3 n + 1, 2), in the layer's units. left, right, blur, opacity: as for Side.colors,
        Side.blur and Side.opacity; blur and opacity apply to both sides. at: the curve to insert
        before [default: add as the last curve]."""
        document, xy = self._document, rows_of(points, 2, "points")
        # Find all faults of the sides before anything changes.
        given = [
            (side, attribute, value)
            for side in (0, 1)
            for attribute, value in (
                ("color", colors_given((left, right)[side])),
                ("opacity", scalars_given(opacity, "opacity")),
                ("blur", scalars_given(blur, "blur")),
            )
            if value.kind != lib.SFUMATO_OPEN
        ]
        added: list[Curve] = []

        def place() -> tuple[int, int]:
            count = self._count()
            if at is not None and not 0 <= at <= count:
                raise IndexError(f"there is no place {at} among {count} curves")
            return self._index, count if at is None else at

        def keep() -> None:
            where = self._count() - 1 if at is None else at
            document._moved(self._index, where, 1)
            added.append(document._curve(self, where))

        rest = (ffi.from_buffer("double[]", xy), len(xy))
        document._session.edit("insert_curve", document._held(), place, rest, keep)
        curve = added[0]
        try:
            for side, attribute, value in given:
                (curve.left, curve.right)[side]._give(attribute, value)
        except BaseException:
            curve.remove()
            raise
        return curve

    def __repr__(self) -> str:
        return f"<Layer {self._index} {self.id!r}: {len(self.curves)} curves>"


class Curves(AbstractSequence):  # type: ignore[type-arg]
    """The curves of a layer as a sequence, which follows all changes of the layer."""

    def __init__(self, layer: Layer) -> None:
        self._layer = layer

    def __len__(self) -> int:
        with self._layer._document._held().lock:
            return self._layer._count()

    @overload
    def __getitem__(self, index: int) -> "Curve": ...
    @overload
    def __getitem__(self, index: slice) -> "list[Curve]": ...
    def __getitem__(self, index: Union[int, slice]) -> "Union[Curve, list[Curve]]":
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        with self._layer._document._held().lock:
            count = self._layer._count()
            if not -count <= index < count:
                raise IndexError(f"there is no curve {index} among {count}")
            return self._layer._document._curve(self._layer, index % count)


class Curve:
    """A diffusion curve. The object keeps referring to the same curve when curves before it are
    added or removed. After the curve itself is removed, every use raises ValueError."""

    def __init__(self, layer: Layer, index: int) -> None:
        self._layer = layer
        self._index: Optional[int] = index

    @property
    def layer(self) -> Layer:
        return self._layer

    @property
    def index(self) -> int:
        """The curve's index in the layer's drawing order."""
        if self._index is None:
            raise ValueError("this curve was removed")
        return self._index

    def _place(self) -> tuple[int, int]:
        return self._layer._index, self.index

    def _edit(self, name: str, *rest: Any, after: Optional[Callable[[], None]] = None) -> None:
        document = self._layer._document
        document._session.edit(name, document._held(), self._place, rest, after)

    @property
    def id(self) -> str:
        """The id of the curve; may be ""."""
        held = self._layer._document._held()
        with held.lock:
            return text_of(lib.sfumato_curve_id(held.pointer, *self._place()))

    def _get_points(self) -> NDArray[np.float64]:
        """The 3 n + 1 control points of n Bézier pieces, in units of the layer: (3 n + 1) × 2. The
        array is a read-only copy; assign to this property to move the curve."""
        view = ffi.new("sfumato_view *")
        held = self._layer._document._held()
        with held.lock:
            lib.sfumato_curve_points(held.pointer, *self._place(), view)
            return fixed(copied(view))

    def _set_points(self, points: ArrayLike) -> None:
        xy = rows_of(points, 2, "points")
        self._edit("set_curve_points", ffi.from_buffer("double[]", xy), len(xy))

    points = Settable(_get_points, _set_points)

    @property
    def weight(self) -> float:
        """The curve's weight relative to other curves, above 0; usually 1."""
        held = self._layer._document._held()
        with held.lock:
            return float(lib.sfumato_curve_weight(held.pointer, *self._place()))

    @weight.setter
    def weight(self, weight: float) -> None:
        self._edit("set_curve_weight", float(weight))

    def _get_left(self) -> "Side":
        """The side on the left when walking along the curve, as seen on the screen. Assign colours
        to set only the side's colours, or a Side to copy all its attributes."""
        return Side(self, 0)

    def _set_left(self, colors: "Union[Side, Colors]") -> None:
        Side(self, 0)._take(colors)

    left = Settable(_get_left, _set_left)

    def _get_right(self) -> "Side":
        """The right side; see left."""
        return Side(self, 1)

    def _set_right(self, colors: "Union[Side, Colors]") -> None:
        Side(self, 1)._take(colors)

    right = Settable(_get_right, _set_right)

    def _get_blur(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Side.blur of the left and the right side. Assigning sets both."""
        return self.left.blur, self.right.blur

    def _set_blur(self, radii: Scalars) -> None:
        self.left.blur = radii
        self.right.blur = radii

    blur = Settable(_get_blur, _set_blur)

    def _get_opacity(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Side.opacity of the left and the right side. Assigning sets both."""
        return self.left.opacity, self.right.opacity

    def _set_opacity(self, opacities: Scalars) -> None:
        self.left.opacity = opacities
        self.right.opacity = opacities

    opacity = Settable(_get_opacity, _set_opacity)

    def remove(self) -> None:
        """Removes the curve from its document."""
        document = self._layer._document

        def forget() -> None:
            document._moved(*self._place(), -1)

        self._edit("remove_curve", after=forget)

    def __repr__(self) -> str:
        if self._index is None:
            return "<Curve, removed>"
        return f"<Curve {self._index} {self.id!r}: {len(self.points)} points>"


class Side:
    """One side of a curve: its colours, opacities and blur radii, each as stops along the curve.
    Arrays are read-only copies; assign to a property to change the side.

    Offsets are shares of the curve's length, from 0 to 1. In the space "pieces" they count Bézier
    pieces: i + t.
    """

    def __init__(self, curve: Curve, side: int) -> None:
        self._curve, self._side = curve, side

    def _get_colors(self) -> NDArray[np.float64]:
        """n × 4: offset, red, green, blue, all from 0 to 1 (sRGB code values).

        Accepts colours (CSS names, or 3 numbers each), spread evenly along the curve; n × 3
        numbers, also spread evenly; n × 4 numbers with offsets, as returned; the text of sf:left
        ("gold, #f06 60%, teal"); "none" for a barrier, where rays end and get no colour; None for
        an open side, which rays pass."""
        return self.stops("color")[2]

    def _set_colors(self, colors: Colors) -> None:
        self._give("color", colors_given(colors))

    colors = Settable(_get_colors, _set_colors)

    def _get_opacity(self) -> NDArray[np.float64]:
        """n × 2: offset, opacity from 0 to 1. Accepts a number, n numbers, spread evenly, n × 2
        numbers, "none" or None, with the same meaning as for colors."""
        return self.stops("opacity")[2]

    def _set_opacity(self, opacities: Scalars) -> None:
        self._give("opacity", scalars_given(opacities, "opacity"))

    opacity = Settable(_get_opacity, _set_opacity)

    def _get_blur(self) -> NDArray[np.float64]:
        """n × 2: offset, radius in units of the layer. Accepts a number, n numbers, spread evenly,
        n × 2 numbers, or None for a sharp side."""
        return self.stops("blur")[2]

    def _set_blur(self, radii: Scalars) -> None:
        self._give("blur", scalars_given(radii, "blur"))

    blur = Settable(_get_blur, _set_blur)

    def kind(self, attribute: str = "color") -> str:
        """Returns how the side acts on "color", "opacity" or "blur": "open", "barrier" (rays end
        and get nothing), "stops", or "paint" (a gradient or texture; only files can define one)."""
        return self.stops(attribute)[0]

    def stops(self, attribute: str) -> tuple[str, str, NDArray[np.float64]]:
        """Returns, for "color", "opacity" or "blur", the kind, the space of the offsets ("length"
        or "pieces"), and the rows."""
        which = self._attribute(attribute)
        held = self._curve._layer._document._held()
        with held.lock:
            kind, space, rows = stops_of(held, *self._curve._place(), self._side, which)
        return KINDS[kind], _spaces[space], fixed(rows)

    def set_stops(self, attribute: str, rows: ArrayLike, space: str = "length") -> None:
        """Sets the stops of "color" (n × 4), "opacity" or "blur" (n × 2), with offsets in a space."""
        columns = 2 if self._attribute(attribute) else 4
        if space not in _spaces:
            raise UsageError(f'{space!r} is not a space of offsets; use "length" or "pieces"')
        self._give(attribute, Given(lib.SFUMATO_STOPS, rows_of(rows, columns, attribute), True), space)

    @staticmethod
    def _attribute(attribute: str) -> int:
        if attribute not in _attributes:
            raise UsageError(f'{attribute!r}: expected "color", "opacity" or "blur"')
        return _attributes.index(attribute)

    def _give(self, attribute: str, given: Given, space: Optional[str] = None) -> None:
        """Sets rows; their offsets use the space of the present stops unless another one is given."""
        if space is None:
            space = self.stops(attribute)[1] if given.has_offsets else "length"
        self._curve._edit(
            "set_curve_stops", self._side, _attributes.index(attribute), given.kind,
            _spaces.index(space), ffi.from_buffer("double[]", given.rows), len(given.rows),
        )

    def _take(self, what: "Union[Side, Colors]") -> None:
        if not isinstance(what, Side):
            self.colors = what
            return
        for attribute in _attributes:
            kind, space, rows = what.stops(attribute)
            self._give(attribute, Given(KINDS.index(kind), rows, True), space)

    def __repr__(self) -> str:
        return f"<Side {('left', 'right')[self._side]}: {self.kind()}, {len(self.colors)} colours>"
