"""Drawings: read, created, edited, written."""

from __future__ import annotations

import io
import json
import os
import weakref
from typing import IO, Any, NamedTuple, Optional, Union, cast

from numpy.typing import ArrayLike, NDArray

from ._arrays import picture_of, pixels_of
from ._colors import SPACES
from ._curves import Curve, Layer
from ._drawing import Box, Drawing, Load, Path, Text, box_of
from ._field import Field
from ._handle import Resource
from ._library import ffi, lib, member_type
from ._options import Option, encode
from ._picture import Picture
from ._session import Session, session_of


class Document(Drawing):
    """Diffusion curves as their author drew them. Create one with open(), read(), trace() or
    Document.new().

    Several threads may solve and draw one document at once. An edit waits until they have finished.
    """

    def __init__(self, resource: Resource, session: Optional[Session]) -> None:
        super().__init__(resource, session)
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
        """Returns a drawing of one layer without curves. width, height: of the artboard, whose
        corner is 0, 0. interpolation: the space for mixing colours, "srgb", "linear" or "oklab".
        background: a CSS colour, or "none"."""
        options: dict[str, Option] = {
            "artboard": (0, 0, width, height),
            "interpolation": interpolation,
            "background": background,
        }
        made = session_of(session).make("document_new", encode(options))
        return Document(made, session)

    @property
    def artboard(self) -> Box:
        """The visible part of the plane: x, y, width and height in user units."""
        held = self._held()
        with held.lock:
            return box_of(lib.sfumato_document_artboard, held.pointer)

    @property
    def interpolation(self) -> str:
        """The space for mixing colours: "srgb", "linear" or "oklab"."""
        held = self._held()
        with held.lock:
            return SPACES[int(lib.sfumato_document_interpolation(held.pointer))]

    @property
    def layers(self) -> tuple[Layer, ...]:
        """The layers, in drawing order."""
        held = self._held()
        with held.lock:
            return tuple(Layer(self, i) for i in range(lib.sfumato_layer_count(held.pointer)))

    def to_svg(self) -> str:
        """Returns the whole drawing as SVG; reading it again gives exactly the same drawing."""
        held = self._held()
        data = self._session.make_bytes("document_write", held.pointer, reads=held, slow=True)
        return data.decode()

    def save(self, file: Union[Path, IO[bytes], IO[str]]) -> None:
        """Writes the drawing as SVG. file: a path, or an object open for writing text or bytes."""
        text = self.to_svg()
        if isinstance(file, (str, os.PathLike)):
            with io.open(file, "w", encoding="utf-8", newline="") as opened:
                opened.write(text)
        elif isinstance(file, io.TextIOBase):
            file.write(text)
        else:
            cast("IO[bytes]", file).write(text.encode())

    def copy(self) -> "Document":
        """Returns a copy of the document."""
        held = self._held()
        made = self._session.make("document_copy", held.pointer, reads=held)
        return Document(made, self._given)

    def __copy__(self) -> "Document":
        return self.copy()

    def __deepcopy__(self, memo: Any) -> "Document":
        return self.copy()

    def lint(self, verbose: bool = False) -> list[dict[str, Any]]:
        """Returns probable mistakes, in the form of `sfumato lint --json`: dicts with "kind",
        "message" and places. verbose: include notes."""
        held, options = self._held(), encode({"verbose": verbose})
        told = self._session.make_bytes("lint", held.pointer, options, reads=held, slow=True)
        hints: list[dict[str, Any]] = json.loads(told)["hints"]
        return hints

    def solve(
        self, again: "Optional[Picture]" = None, *, quick: bool = False, **options: Option
    ) -> "Picture":
        """Solves the drawing and returns the picture: patches that have no resolution.

        options: as in docs/c-api.md for sfumato_solve, for example max_error, viewport=(x, y,
        width, height), width, height, scale, detail, no_blur. width, height and scale set the size
        of the largest output. coherent: prepares the picture as the first frame of a film; see
        Picture.next().

        again: a picture of this or another document to update. It becomes the picture of this
        document as it is now, with the options of its first solve, and is returned. Unchanged parts
        are reused. quick: solves roughly, for a preview while a curve moves. Raises BufferError
        while arrays are views of the tables of `again`.
        """
        held = self._held()
        if again is None:
            if quick:
                raise TypeError("quick goes with again")
            made = self._session.make(
                "solve", held.pointer, encode(options), reads=held, slow=True
            )
            return Picture(made, self._given)
        if options:
            raise TypeError("a picture is solved again by the options that it was solved with")
        again._follow("solve_again", self, held, int(quick))
        return again

    def render(self, width: Optional[int] = None, **options: Any) -> NDArray[Any]:
        """Solves and renders in one call: height × width × 3 or 4. For options that Picture.render()
        does not have, call solve() first."""
        x = {k: options[k] for k in ("height", "scale", "viewport") if k in options}
        needs_fine_mesh = options.get("no_antialias") or options.get("mesh_overlay")
        for_pixels = options.get("depth", 8) == 8 and not needs_fine_mesh
        with self.solve(width=width, pixel_grid=for_pixels, **x) as picture:
            return picture.render(width, **options)

    def field(self, layer: int = 0, **options: Option) -> "Field":
        """Returns the exact colours of a layer at points. options: viewport, width, height, scale,
        tolerance, no_blur, as for solve(). Later edits of the document do not change the field."""
        return Field(self, layer, options)

    def fit_colors(self, image: ArrayLike, **options: Option) -> "Document":
        """Returns a copy of the drawing with the colours that resemble an image best. The image
        covers the artboard. image: height × width × 3 or 4, uint8, uint16, or floats from 0 to 1.
        options: blur, max_side, seed, keep_colors, only, as for `sfumato trace --colors-only`."""
        held, array = self._held(), picture_of(image, "image")
        pixels = pixels_of(array, "image")
        made = self._session.make(
            "fit_colors", held.pointer, pixels, encode(options), reads=held, slow=True
        )
        return Document(made, self._given)

    def _curve(self, layer: Layer, index: int) -> Curve:
        """Returns the only object of a curve. The caller holds the document."""
        found = self._live.get((layer._index, index))
        if found is None:
            found = self._live[layer._index, index] = Curve(layer, index)
        return found

    def _moved(self, layer: int, index: int, by: int) -> None:
        """Updates indices after a curve was inserted at an index (by = 1) or removed (by = -1)."""
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
    """Returns a loader that reads files in a folder and its subfolders."""
    root = os.path.realpath(folder)

    def load(name: str) -> bytes:
        path = os.path.realpath(os.path.join(root, name))
        if os.path.commonpath([path, root]) != root:
            raise PermissionError(f"{name!r} lies outside of {root!r}")
        with io.open(path, "rb") as file:
            return file.read()

    return load


def open(path: Path, *, session: Optional[Session] = None) -> Document:
    """Reads a drawing: SVG with Sfumato's curves, or the XML of Orzan et al., plain or gzipped.
    Textures are read only from the drawing's folder and its subfolders."""
    folder = os.path.dirname(os.path.abspath(path))
    with io.open(path, "rb") as file:
        document, chosen = _made_of("read", file.read(), os.fspath(path), _in_folder(folder), session)
    chosen.warn(2)
    return document


def read(
    data: Text,
    *,
    name: str = "drawing",
    folder: Optional[Path] = None,
    load: Optional[Load] = None,
    session: Optional[Session] = None,
) -> Document:
    """Reads a drawing from its text. name: for messages. folder: textures may be read from this
    folder and its subfolders. load: replaces `folder`; a function that gets a name, runs in this
    thread and returns bytes. read() passes on the exceptions that it raises."""
    document, chosen = _made_of("read", _bytes_of(data), name, _loader_of(folder, load), session)
    chosen.warn(2)
    return document


class ImportedSvg(NamedTuple):
    """The result of import_svg()."""

    document: Document
    warnings: list[str]  # one for each kind of content that was left out, with its place


def import_svg(
    data: Text,
    *,
    name: str = "drawing",
    folder: Optional[Path] = None,
    load: Optional[Load] = None,
    session: Optional[Session] = None,
) -> ImportedSvg:
    """Converts an ordinary SVG, plain or gzipped, to a drawing: curves along the boundaries of its
    fills and strokes (docs/import.md). The parameters are as for read(). The warnings of the result
    name the content that was left out; no Python warning is raised."""
    loader = _loader_of(folder, load)
    document, chosen = _made_of("import_svg", _bytes_of(data), name, loader, session)
    return ImportedSvg(document, chosen.last_warnings())


def combine_paths(
    operation: str,
    first: str,
    second: str,
    tolerance: float,
    *,
    session: Optional[Session] = None,
) -> str:
    """Combines two regions and returns the path data of the result, with the inside on its right;
    "" if nothing is left.

    operation: "unite", "intersect", "subtract" (the first without the second) or "exclude".
    first, second: path data of SVG, filled by the nonzero rule. tolerance: the accuracy of
    crossings, in the paths' units, above 0."""
    words = [text.replace("\0", "").encode() for text in (operation, first, second)]
    chosen = session_of(session)
    return chosen.make_bytes("combine_paths", *words, float(tolerance), slow=True).decode()


def _loader_of(folder: Optional[Path], load: Optional[Load]) -> Optional[Load]:
    if folder is not None and load is not None:
        raise TypeError("expected a folder or load, not both")
    return load if folder is None else _in_folder(folder)


def _bytes_of(data: Text) -> bytes:
    if isinstance(data, str):
        return data.encode("utf-8", "surrogatepass")
    if not isinstance(data, (bytes, bytearray, memoryview)):
        raise TypeError(f"a drawing is text or bytes, not {type(data).__name__}")
    return bytes(data)


def _made_of(
    function: str, data: bytes, name: str, load: Optional[Load], session: Optional[Session]
) -> tuple[Document, Session]:
    """Calls sfumato_read() or sfumato_import_svg(). Returns the session as well, which holds the
    warnings."""
    chosen = session_of(session)

    def bring(_: Any, href: Any, deliver: Any, sink: Any) -> int:
        def answer() -> bytes:
            assert load is not None
            return bytes(load(os.fsdecode(ffi.string(href))))

        content = chosen.ask(answer)
        if content is None:
            return 1
        deliver(sink, content, len(content))
        return 0

    called = ffi.callback(member_type("sfumato_loader", "load"), bring)
    loader = ffi.new("sfumato_loader *", {"load": called})
    given = loader if load is not None else ffi.NULL
    words = name.replace("\0", "").encode("utf-8", "surrogateescape")
    made = chosen.make(function, data, len(data), words, given, slow=True)
    return Document(made, session), chosen
