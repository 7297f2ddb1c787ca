"""Pictures: solved drawings without a resolution, their tables, pixels and files."""

from __future__ import annotations

import base64
import io
import os
import sys
import weakref
from numbers import Integral
from typing import IO, Any, Optional, Tuple, Union, cast

import numpy as np
from numpy.typing import NDArray

from ._arrays import Export, copied, empty_table, pixels_of
from ._drawing import Box, Drawing, Path, box_of
from ._errors import UsageError
from ._handle import Handle, Resource
from ._library import ffi, lib, names_of
from ._options import Option, encode
from ._session import Session, session_of

_statistics = tuple(name.removeprefix("solved_") for name in names_of("sfumato_statistic"))
_tables = names_of("sfumato_table")

SOLVED = "sfp"  # the extension of solved pictures


def _window_size(window: Any) -> Tuple[int, int]:
    numbers = tuple(window)
    if len(numbers) != 4:
        raise UsageError("a window is x, y, width and height")
    for number in numbers:
        if not isinstance(number, Integral):
            raise TypeError(f"a window has whole numbers, not {type(number).__name__}")
    return int(numbers[2]), int(numbers[3])


def _room(across: int, down: int, depth: int, alpha: bool) -> NDArray[Any]:
    if depth not in (8, 16):
        raise UsageError(f"depth is 8 or 16 bits, not {depth}")
    if not (0 < across < 2**31 and 0 < down < 2**31):
        raise UsageError(f"there are no pictures of {across} x {down} pixels")
    channels, kind = 4 if alpha else 3, np.dtype(np.uint8 if depth == 8 else np.uint16)
    if down * across * channels * kind.itemsize > sys.maxsize:
        raise MemoryError(f"no memory holds {across} x {down} pixels")
    return np.empty((down, across, channels), kind)


class Picture(Handle):
    """A solved document, from Document.solve() or load_picture(). It can be pickled and copied; the
    copy belongs to no document and uses this thread's session. The arrays of its tables are
    read-only views of the library's memory and keep it alive."""

    def __init__(self, resource: Resource, session: Optional[Session]) -> None:
        super().__init__(resource)
        self._given = session
        self._exports: weakref.WeakSet[Export] = weakref.WeakSet()

    @property
    def _session(self) -> Session:
        return session_of(self._given)

    @property
    def viewport(self) -> Box:
        """The solved part of the plane: x, y, width and height in user units."""
        held = self._held()
        with held.lock:
            return box_of(lib.sfumato_picture_viewport, held.pointer)

    @property
    def layer_count(self) -> int:
        held = self._held()
        with held.lock:
            return int(lib.sfumato_picture_layer_count(held.pointer))

    @property
    def statistics(self) -> dict[str, float]:
        """Counts and the seconds of each step of the last solve. For a frame also how many layers
        did not change, continued with the mesh of the previous frame, or were restarted."""
        held = self._held()
        with held.lock:
            return {
                name: float(lib.sfumato_picture_statistic(held.pointer, i))
                for i, name in enumerate(_statistics)
            }

    def render(
        self,
        width: Optional[int] = None,
        height: Optional[int] = None,
        *,
        scale: Optional[float] = None,
        depth: int = 8,
        alpha: bool = False,
        out: Optional[NDArray[Any]] = None,
        **options: Option,
    ) -> NDArray[Any]:
        """Renders pixels: height × width × 3, or 4 with alpha (not premultiplied), in sRGB; uint8,
        or uint16 with depth=16.

        width, height: in pixels; give one, and the other follows. scale: pixels per user unit [1].
        out: an array of that form to draw into and return; it may be a slice of a larger array.
        window=(x, y, width, height): render only this part of the full image, in its pixels. The
        pixels equal the same pixels of a full render. options: viewport=(x, y, width, height),
        background (a colour, "none"), dither, no_antialias, mesh_overlay. The options of solve()
        decide how fine the picture is.
        """
        window, viewport = options.get("window"), options.get("viewport")
        if window is not None:
            across, down = self._size(width, height, scale, viewport)
            options.update(width=across, height=down)
            if out is None:
                out = _room(*_window_size(window), depth, alpha)
        elif out is None:
            out = _room(*self._size(width, height, scale, viewport), depth, alpha)
        elif width is not None or height is not None or scale is not None:
            raise TypeError("out has a size of its own")
        pixels = pixels_of(out, "out")
        if not out.flags.writeable:
            raise ValueError("out cannot be written to")
        if alpha and out.shape[2] != 4:
            raise ValueError("out has no alpha")
        held = self._held()
        self._session.call(
            "raster", held.pointer, pixels, encode(options), reads=held, slow=True
        )
        return out

    def _size(
        self, width: Optional[int], height: Optional[int], scale: Optional[float], viewport: Any
    ) -> Tuple[int, int]:
        _, _, w, h = self.viewport if viewport is None else viewport
        if not (w > 0 and h > 0):
            raise UsageError("a viewport has a width and a height above 0")
        if scale is not None and (width is not None or height is not None):
            raise TypeError("expected a scale, or width and height")
        for side in (width, height):
            if side is not None and not isinstance(side, Integral):
                raise TypeError(f"width and height are whole numbers, not {type(side).__name__}")
        by = scale or 1.0
        if width is not None or height is not None:
            by = width / w if width is not None else height / h
        across = width if width is not None else max(round(w * by), 1)
        down = height if height is not None else max(round(h * by), 1)
        return across, down

    def to_bytes(self, format: str, **options: Option) -> bytes:
        """Returns a file as bytes. The format "sfp" stores the picture itself, exactly and without
        options; load_picture() reads it and `sfumato render` draws it. Other formats: png, jpg,
        webp, html, pdf, eps, svg, glb, npz, ply, json. options: width, height, scale, background;
        for pixel formats also viewport, window, depth, dither, quality, lossless, no_antialias,
        mesh_overlay; for other formats dpi, svg, force, pdf_flatten, title. Raises a DrawingWarning
        for content that the format cannot show."""
        if not isinstance(format, str):
            raise TypeError(f"a format is text, not {type(format).__name__}")
        held, session = self._held(), self._session
        if format.lower() == SOLVED:
            if options:
                raise TypeError(f"a solved picture takes no options, as {next(iter(options))}")
            return session.make_bytes("picture_write", held.pointer, reads=held, slow=True)
        data = session.make_bytes(
            "export", held.pointer, format.replace("\0", "?").encode("utf-8", "replace"),
            encode(options), reads=held, slow=True,
        )
        session.warn()
        return data

    def save(
        self, file: "Union[Path, IO[bytes]]", format: Optional[str] = None, **options: Option
    ) -> None:
        """Writes a file. file: a path, or an object open for writing bytes. format and options: as
        for to_bytes(). The default format is the extension of the path or of the object's name; an
        object without a name and without a format raises ValueError."""
        path = file if isinstance(file, (str, os.PathLike)) else None
        if format is None:
            name = path if path is not None else getattr(file, "name", None)
            if not isinstance(name, (str, os.PathLike)):
                raise ValueError("save: the file has no name; set the format, such as format='png'")
            format = os.path.splitext(os.fspath(name))[1][1:]
        data = self.to_bytes(format, **options)
        if path is None:
            cast("IO[bytes]", file).write(data)
            return
        with io.open(path, "wb") as opened:
            opened.write(data)

    def vertices(self, layer: int = 0) -> NDArray[np.float64]:
        """n × 2: positions in the frame of the layer."""
        return self._table(layer, lib.SFUMATO_VERTICES)

    def triangles(self, layer: int = 0) -> NDArray[np.uint32]:
        """m × 3: rows of vertices()."""
        return self._table(layer, lib.SFUMATO_TRIANGLES)

    def curve_edges(self, layer: int = 0) -> NDArray[np.uint8]:
        """m × 3: 1 if colours may jump across that edge of the triangle."""
        return self._table(layer, lib.SFUMATO_CURVE_EDGES)

    def color_nodes(self, layer: int = 0) -> NDArray[np.uint32]:
        """m × 10: rows of color_values(), which are the nodes of one cubic patch each."""
        return self._table(layer, lib.SFUMATO_COLOR_NODES)

    def color_values(self, layer: int = 0) -> NDArray[np.float32]:
        """k × 3 or more: a colour, in the document's space for mixing colours, then the
        weight of each gradient and texture of the layer."""
        return self._table(layer, lib.SFUMATO_COLOR_VALUES)

    def opacity_nodes(self, layer: int = 0) -> NDArray[np.uint32]:
        """m × 10: rows of opacity_values(); no rows if the layer is opaque."""
        return self._table(layer, lib.SFUMATO_OPACITY_NODES)

    def opacity_values(self, layer: int = 0) -> NDArray[np.float32]:
        """k × 1 or more: an opacity, then the weight of each gradient and texture."""
        return self._table(layer, lib.SFUMATO_OPACITY_VALUES)

    def changes(self, table: str, layer: int = 0) -> NDArray[np.uint32]:
        """Returns k × 2 row ranges (from, up to) of a table, such as "color_values", that the last
        solve(again=…) or next() computed again. The array is a copy."""
        if table not in _tables:
            raise UsageError(f"{table!r} is not a table; use one of {', '.join(_tables)}")
        held, view = self._held(), ffi.new("sfumato_view *")
        with held.lock:
            self._check_layer(held.pointer, layer)
            lib.sfumato_picture_changes(held.pointer, layer, _tables.index(table), view)
            return copied(view)

    def _table(self, layer: int, table: int) -> NDArray[Any]:
        held, view = self._held(), ffi.new("sfumato_view *")
        with held.lock:
            self._check_layer(held.pointer, layer)
            lib.sfumato_picture_table(held.pointer, layer, table, view)
            if view.rows == 0:
                return empty_table(view)
            export = Export(view, held)
            self._exports.add(export)
        return np.asarray(export)

    @staticmethod
    def _check_layer(picture: Any, layer: int) -> None:
        count = lib.sfumato_picture_layer_count(picture)
        if not 0 <= layer < count:
            raise IndexError(f"there is no layer {layer} among {count}")

    def __reduce__(self) -> Any:
        return _unpickled, (self.to_bytes(SOLVED),)

    def next(self, document: Drawing) -> "Picture":
        """Turns the picture into the next frame of a film, the frame of `document`, and returns it.
        It uses the options of the first solve, which must include coherent=True. Where nothing
        changes, pixels differ by at most one code value. Raises BufferError while arrays are views
        of its tables."""
        if not isinstance(document, Drawing):
            raise TypeError(f"a frame is a Document's, not a {type(document).__name__}'s")
        self._follow("solve_next", document, document._held())
        return self

    def _follow(self, name: str, document: Drawing, of: Resource, *how: int) -> None:
        held = self._held()
        if len(self._exports) > 0:
            raise BufferError("arrays look at this picture's tables: copy them, or let go of them")
        document._session.call(
            name, of.pointer, *how, held.pointer, reads=of, changes=held, slow=True
        )

    def _repr_png_(self) -> bytes:
        _, _, width, height = self.viewport
        scale = min(max(1.0, 512 / max(width, height)), 2048 / max(width, height))
        return self.to_bytes("png", scale=scale)

    def interactive(self, height: int = 480) -> "Interactive":
        """Returns the viewer in a frame, for zooming in a notebook; 150 kB or more. A cell shows a
        picture without it as a PNG."""
        # A page of a data: URL has its own origin and cannot see the notebook.
        page = base64.b64encode(self.to_bytes("html")).decode()
        return Interactive(
            f'<iframe src="data:text/html;base64,{page}" title="picture"'
            f' style="width:100%;height:{int(height)}px;border:0" allow="fullscreen"></iframe>'
        )

    def __repr__(self) -> str:
        if self.freed:
            return "<Picture, freed>"
        _, _, width, height = self.viewport
        count = int(self.statistics["triangles"])
        return f"<Picture {width:g} x {height:g}: {self.layer_count} layers, {count} triangles>"


def load_picture(
    source: "Union[Path, bytes, bytearray, memoryview]", *, session: Optional[Session] = None
) -> Picture:
    """Loads a picture that Picture.save() or `sfumato solve` wrote as .sfp, from a path or from the
    bytes of such a file. It draws and exports exactly as the picture that was written, to the last
    bit. It belongs to no document: solve(again=…) and next() raise UsageError."""
    if isinstance(source, (bytes, bytearray, memoryview)):
        data = bytes(source)
    else:
        with io.open(source, "rb") as file:
            data = file.read()
    made = session_of(session).make("picture_read", data, len(data), slow=True)
    return Picture(made, session)


def _unpickled(data: bytes) -> Picture:
    return load_picture(data)


class Interactive(str):
    """HTML that notebooks show."""

    def _repr_html_(self) -> str:
        return str(self)
