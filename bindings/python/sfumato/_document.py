"""Drawings: read, made, edited, written."""

from __future__ import annotations

import ctypes
import io
import json
import os
import weakref
from typing import TYPE_CHECKING, Any, Callable, Optional, Union

from numpy.typing import ArrayLike, NDArray

from . import _library
from ._arrays import picture_of, pixels_of
from ._colors import SPACES
from ._curves import Curve, Layer
from ._handle import Handle, Resource
from ._library import lib
from ._options import Option, encode
from ._session import Session, session_of

if TYPE_CHECKING:
    from ._field import Field
    from ._picture import Picture

Box = tuple[float, float, float, float]
Load = Callable[[str], bytes]
Path = Union[str, "os.PathLike[str]"]


def box_of(function: Callable[..., int], address: int) -> Box:
    box = (ctypes.c_double * 4)()
    function(address, box)
    return (box[0], box[1], box[2], box[3])


class Document(Handle):
    """Diffusion curves as their author drew them. Make one by open(), read(), trace() or
    Document.new().

    Several threads may solve and draw one document at once; who edits it waits for them.
    """

    def __init__(self, resource: Resource, session: Optional[Session]) -> None:
        super().__init__(resource)
        self._given = session
        self._live: weakref.WeakValueDictionary[tuple[int, int], Curve] = (
            weakref.WeakValueDictionary()
        )

    @staticmethod
    def new(
        width: float,
        height: float,
        *,
        interpolation: Optional[str] = None,
        background: Optional[str] = None,
        session: Optional[Session] = None,
    ) -> "Document":
        """A drawing of one layer without curves. width, height: of the artboard, whose corner is 0, 0.
        interpolation: the space in which colours mix, "srgb", "linear" or "oklab". background: a colour
        of CSS, or "none"."""
        options: dict[str, Option] = {
            "artboard": (0, 0, width, height),
            "interpolation": interpolation,
            "background": background,
        }
        made = session_of(session).make("document_new", lib.sfumato_document_free, encode(options))
        return Document(made, session)

    @property
    def _session(self) -> Session:
        return session_of(self._given)

    @property
    def artboard(self) -> Box:
        """What is shown of the plane: x, y, width and height in user units."""
        held = self._held()
        with held.lock:
            return box_of(lib.sfumato_document_artboard, held.address)

    @property
    def interpolation(self) -> str:
        """The space in which colours mix: "srgb", "linear" or "oklab"."""
        held = self._held()
        with held.lock:
            return SPACES[lib.sfumato_document_interpolation(held.address)]

    @property
    def layers(self) -> tuple[Layer, ...]:
        """The layers, in drawing order."""
        held = self._held()
        with held.lock:
            return tuple(Layer(self, i) for i in range(lib.sfumato_layer_count(held.address)))

    def to_svg(self) -> str:
        """The whole drawing, exactly."""
        held = self._held()
        data = self._session.make_bytes("document_write", held.address, reads=held, slow=True)
        return data.decode()

    def save(self, path: Path) -> None:
        """Writes it as SVG."""
        with io.open(path, "w", encoding="utf-8", newline="") as file:
            file.write(self.to_svg())

    def copy(self) -> "Document":
        """Another document of the same."""
        held = self._held()
        free = lib.sfumato_document_free
        made = self._session.make("document_copy", free, held.address, reads=held)
        return Document(made, self._given)

    def __copy__(self) -> "Document":
        return self.copy()

    def __deepcopy__(self, memo: Any) -> "Document":
        return self.copy()

    def lint(self, verbose: bool = False) -> list[dict[str, Any]]:
        """Probable mistakes, as `sfumato lint --json` tells them: dicts with "kind", "message" and
        places. verbose: notes, too."""
        held, options = self._held(), encode({"verbose": verbose})
        told = self._session.make_bytes("lint", held.address, options, reads=held, slow=True)
        hints: list[dict[str, Any]] = json.loads(told)["hints"]
        return hints

    def solve(
        self, again: "Optional[Picture]" = None, *, quick: bool = False, **options: Option
    ) -> "Picture":
        """The picture: patches of no resolution.

        options: those of docs/c-api.md for sfumato_solve, as max_error, viewport=(x, y, width,
        height), width, height, scale, detail, no_blur. width, height and scale say how large the
        largest output will be. coherent: it is the first frame of a film, Picture.next().

        again: a picture of this document or another one, which becomes that of this one as it is now,
        by the options with which it was solved, and is returned: what has not changed is kept. quick:
        a picture to look at while a curve moves. BufferError where arrays look at its tables.
        """
        from ._picture import Picture

        held = self._held()
        if again is None:
            if quick:
                raise TypeError("quick goes with again")
            made = self._session.make(
                "solve", lib.sfumato_picture_free, held.address, encode(options),
                reads=held, slow=True,
            )
            return Picture(made, self._given)
        if options:
            raise TypeError("a picture is solved again by the options that it was solved with")
        again._follow("solve_again", self, held, int(quick))
        return again

    def render(self, width: Optional[int] = None, **options: Any) -> NDArray[Any]:
        """solve() and Picture.render() at once: height × width × 3 or 4. For other options than those
        of render(), solve first."""
        x = {k: options[k] for k in ("height", "scale", "viewport") if k in options}
        with self.solve(width=width, **x) as picture:
            return picture.render(width, **options)

    def field(self, layer: int = 0, **options: Option) -> "Field":
        """The exact colours of a layer at points. options: viewport, width, height, scale, tolerance,
        no_blur, as of solve(). Later edits of the document do not change it."""
        from ._field import Field

        return Field(self, layer, options)

    def fit_colors(self, image: ArrayLike, **options: Option) -> "Document":
        """A copy whose curves have the colours of a picture that is laid over the artboard: those with
        which it looks most like it. image: height × width × 3 or 4, uint8 or uint16. options: blur,
        max_side, seed, keep_colors, only, as of `sfumato trace --colors-only`."""
        held, array = self._held(), picture_of(image, "image")
        pixels = pixels_of(array, "image")
        made = self._session.make(
            "fit_colors", lib.sfumato_document_free, held.address, ctypes.byref(pixels),
            encode(options), reads=held, slow=True,
        )
        return Document(made, self._given)

    def _curve(self, layer: Layer, index: int) -> Curve:
        """The one object of a curve; while the document is used."""
        found = self._live.get((layer._index, index))
        if found is None:
            found = self._live[layer._index, index] = Curve(layer, index)
        return found

    def _moved(self, layer: int, index: int, by: int) -> None:
        """Follows a curve that was inserted at an index (by 1), or that was removed (by -1)."""
        live = sorted((at, curve) for (of, at), curve in self._live.items() if of == layer)
        for at, _ in live:
            del self._live[layer, at]
        for at, curve in live:
            if by < 0 and at == index:
                curve._index = None
                continue
            curve._index = at + by if at >= index else at
            self._live[layer, curve._index] = curve

    def _repr_png_(self) -> bytes:
        with self.solve() as picture:
            return picture._repr_png_()

    def __repr__(self) -> str:
        if self.freed:
            return "<Document, freed>"
        _, _, width, height = self.artboard
        layers = self.layers
        curves = sum(len(layer.curves) for layer in layers)
        return f"<Document {width:g} x {height:g}: {curves} curves in {len(layers)} layers>"


def _in_folder(folder: Path) -> Load:
    """Reads files in a folder, and below."""
    root = os.path.realpath(folder)

    def load(name: str) -> bytes:
        path = os.path.realpath(os.path.join(root, name))
        if os.path.commonpath([path, root]) != root:
            raise PermissionError(f"{name!r} lies outside of {root!r}")
        with io.open(path, "rb") as file:
            return file.read()

    return load


def open(path: Path, *, session: Optional[Session] = None) -> Document:
    """Reads a drawing: SVG with curves of Sfumato's, or the XML of Orzan et al., gzipped or not.
    Textures that it names are read in its folder, and below."""
    folder = os.path.dirname(os.path.abspath(path))
    with io.open(path, "rb") as file:
        return _read(file.read(), os.fspath(path), _in_folder(folder), session)


def read(
    data: Union[str, bytes, bytearray, memoryview],
    *,
    name: str = "drawing",
    folder: Optional[Path] = None,
    load: Optional[Load] = None,
    session: Optional[Session] = None,
) -> Document:
    """Reads a drawing from its text. name: for messages. folder: where textures that it names are read,
    itself and below. load: brings them instead: called with a name, in this thread, it returns bytes;
    what it raises comes out of read()."""
    if folder is not None and load is not None:
        raise TypeError("expected a folder or load, not both")
    if isinstance(data, str):
        data = data.encode("utf-8", "surrogatepass")
    elif not isinstance(data, (bytes, bytearray, memoryview)):
        raise TypeError(f"a drawing is text or bytes, not {type(data).__name__}")
    return _read(bytes(data), name, load if folder is None else _in_folder(folder), session)


def _read(data: bytes, name: str, load: Optional[Load], session: Optional[Session]) -> Document:
    chosen = session_of(session)

    def bring(_: Any, href: bytes, deliver: Any, sink: Any) -> int:
        def answer() -> bytes:
            assert load is not None
            return bytes(load(os.fsdecode(href)))

        content = chosen.ask(answer)
        if content is None:
            return 1
        deliver(sink, content, len(content))
        return 0

    loader = _library.Loader(_library.LOAD(bring), None)
    given = ctypes.byref(loader) if load is not None else None
    words = name.replace("\0", "").encode("utf-8", "surrogateescape")
    free = lib.sfumato_document_free
    made = chosen.make("read", free, data, len(data), words, given, slow=True)
    chosen.warn()
    return Document(made, session)


def read_quietly(data: bytes) -> Document:
    """A drawing of ours, which says nothing of what it lacks."""
    free = lib.sfumato_document_free
    return Document(session_of(None).make("read", free, data, len(data), b"text", None), None)
