"""Drawings: read, created, edited, written."""

from __future__ import annotations

import copy
import gc
import gzip
import pickle
import warnings
import weakref

import numpy as np
import pytest

import sfumato
from conftest import EXAMPLES, TEXT

PICTURE = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 64 64"
    sf:version="1"><defs><pattern id="p" patternUnits="userSpaceOnUse" width="16" height="16">
  <image href="waves.png" width="16" height="16" preserveAspectRatio="none"/></pattern></defs>
  <g sf:diffuse="true"><path d="M-8 12C20 4 40 24 72 10" sf:left="gold" sf:right="url(#p)"/></g></svg>"""


def test_text_and_bytes_packed_or_not_are_the_same_drawing(drawing):
    for data in (TEXT, TEXT.encode(), bytearray(TEXT.encode()), gzip.compress(TEXT.encode())):
        assert sfumato.read(data).to_svg() == drawing.to_svg()


def test_a_file_is_opened_with_its_textures(tmp_path):
    assert len(sfumato.open(EXAMPLES / "textures.svg").layers) > 0
    (tmp_path / "drawing.svg").write_text(PICTURE)
    with pytest.raises(FileNotFoundError, match="waves.png"):
        sfumato.open(tmp_path / "drawing.svg")
    with pytest.raises(FileNotFoundError):
        sfumato.open(tmp_path / "none.svg")


def test_textures_outside_of_the_folder_are_refused(tmp_path):
    inner = tmp_path / "inner"
    inner.mkdir()
    (tmp_path / "waves.png").write_bytes((EXAMPLES / "waves.png").read_bytes())
    (inner / "drawing.svg").write_text(PICTURE.replace("waves.png", "../waves.png"))
    with pytest.raises(PermissionError, match="outside"):
        sfumato.open(inner / "drawing.svg")
    (inner / "waves.png").symlink_to(tmp_path / "waves.png")
    with pytest.raises(PermissionError):
        sfumato.read(PICTURE, folder=inner)
    assert sfumato.read(PICTURE, folder=tmp_path).layers[0].curves[0].right.kind() == "paint"


def test_a_loader_brings_textures_and_its_errors_come_out():
    asked = []

    def load(name):
        asked.append(name)
        return (EXAMPLES / name).read_bytes()

    assert sfumato.read(PICTURE, load=load).layers[0].curves[0].right.kind() == "paint"
    assert asked == ["waves.png"]
    with pytest.raises(ZeroDivisionError):
        sfumato.read(PICTURE, load=lambda name: bytes(1 // 0))
    with pytest.raises(TypeError):
        sfumato.read(PICTURE, load=lambda name: "text")
    with pytest.raises(sfumato.InputError):
        sfumato.read(PICTURE, load=lambda name: b"no picture")
    with pytest.raises(sfumato.InputError, match="waves.png"):
        sfumato.read(PICTURE)
    with pytest.raises(TypeError):
        sfumato.read(PICTURE, load=load, folder=EXAMPLES)


def test_an_error_has_its_place():
    with pytest.raises(sfumato.InputError) as told:
        sfumato.read("<svg xmlns='http://www.w3.org/2000/svg'>\n <g>", name="broken.svg")
    error = told.value
    assert isinstance(error, ValueError) and isinstance(error, sfumato.Error)
    assert (error.file, error.line > 0, error.column > 0) == ("broken.svg", True, True)
    assert str(error) == f"broken.svg:{error.line}:{error.column}: {error.reason}"
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.line) == (str(error), error.line)


@pytest.mark.parametrize("data", [3, None, ["<svg/>"], np.zeros(3)])
def test_what_is_no_text_is_a_type_error(data):
    with pytest.raises(TypeError):
        sfumato.read(data)


@pytest.mark.parametrize("data", ["", b"\0\xff", b"\x1f\x8b broken", "<svg/>" * 3, "\ud800"])
def test_hostile_text_is_an_input_error(data):
    with pytest.raises(sfumato.InputError):
        sfumato.read(data)


def test_what_is_left_out_is_a_warning():
    with pytest.warns(sfumato.DrawingWarning, match="sf:version"):
        sfumato.read(TEXT.replace('sf:version="1"', ""))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        sfumato.read(TEXT)
        with pytest.raises(sfumato.DrawingWarning):
            sfumato.read(TEXT.replace('sf:version="1"', ""))


ORDINARY = """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 30 20">
<rect id="box" x="5" y="5" width="20" height="10" fill="#c04030"/>
<text x="5" y="5">left out</text></svg>"""


def test_an_ordinary_svg_is_imported_with_its_warnings_as_data():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        document, left_out = sfumato.import_svg(ORDINARY, name="box.svg")
    assert [curve.id for layer in document.layers for curve in layer.curves] == ["box"]
    assert len(left_out) == 1
    assert left_out[0].startswith("box.svg:3:") and "text" in left_out[0]
    image = document.render(width=30, background="#fff", dither=False)
    assert tuple(image[10, 15]) == (0xC0, 0x40, 0x30) and tuple(image[2, 2]) == (255, 255, 255)


PATTERNED = """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 30 20">
<pattern id="p" width="4" height="4" patternUnits="userSpaceOnUse"><rect width="2" height="4" fill="#08f"/></pattern>
<rect width="24" height="16" fill="url(#p)"/></svg>"""


def test_patterns_of_shapes_are_drawn_where_they_are_imported():
    document, left_out = sfumato.import_svg(PATTERNED)
    assert len(left_out) == 1 and "becomes a texture" in str(left_out[0])
    image = document.render(width=30, background="#fff", dither=False)
    assert tuple(image[9, 9]) == (0, 0x88, 0xFF) and tuple(image[9, 11]) == (255, 255, 255)


def test_regions_are_combined():
    square, other = "M0 0H10V10H0Z", "M5 5H15V15H5Z"
    cut = sfumato.combine_paths("subtract", square, other, 0.01)
    assert cut.startswith("M") and cut.endswith("Z") and "5 5" in cut and "15" not in cut
    assert sfumato.combine_paths("intersect", square, "M20 20H30V30Z", 0.01) == ""
    with pytest.raises(sfumato.UsageError, match="no operation"):
        sfumato.combine_paths("union", square, other, 0.01)
    with pytest.raises(sfumato.InputError):
        sfumato.combine_paths("unite", "M0 0L", other, 0.01)
    with pytest.raises(sfumato.InputError):
        sfumato.combine_paths("unite", square, other, 0)


@pytest.mark.parametrize("data", ["", "<svg", b"\x1f\x8b broken"])
def test_an_import_of_broken_text_is_an_input_error(data):
    with pytest.raises(sfumato.InputError):
        sfumato.import_svg(data)


def test_a_drawing_is_made_and_edited(tmp_path):
    with sfumato.Document.new(400, 300, interpolation="oklab", background="#223") as drawing:
        assert drawing.artboard == (0, 0, 400, 300)
        assert drawing.interpolation == "oklab"
        layer = drawing.layers[0]
        points = [(-20, 210), (130, 180), (270, 240), (420, 210)]
        curve = layer.add(points, left=["#f00", (0, 0, 1)], right="none", blur=3, opacity=(1, 0.5))
        np.testing.assert_array_equal(curve.points, points)
        np.testing.assert_allclose(curve.left.colors, [(0, 1, 0, 0), (1, 0, 0, 1)])
        assert curve.right.kind() == "barrier" and len(curve.right.colors) == 0
        np.testing.assert_allclose(curve.left.opacity, [(0, 1), (1, 0.5)])
        for side in curve.blur:
            np.testing.assert_allclose(side, [(0, 3)])
        drawing.save(tmp_path / "made.svg")
        assert sfumato.open(tmp_path / "made.svg").to_svg() == drawing.to_svg()


def test_sides_take_colours_in_every_form(drawing):
    side = drawing.layers[0].curves[0].left
    assert (side.kind(), side.stops("color")[1]) == ("stops", "length")
    np.testing.assert_allclose(side.colors[:, 0], [0, 0.25, 1])
    side.colors = "gold, #f06 60%, teal"
    np.testing.assert_allclose(side.colors[:, 0], [0, 0.6, 1])
    side.colors = "rgb(255 0 0)"
    np.testing.assert_allclose(side.colors, [(0, 1, 0, 0)])
    side.colors = ["red", "lime", "blue"]
    np.testing.assert_allclose(side.colors[:, 0], [0, 0.5, 1])
    side.colors = (0.25, 0.5, 0.75)
    np.testing.assert_allclose(side.colors, [(0, 0.25, 0.5, 0.75)])
    side.colors = np.array([(0.25, 0.5, 0.75), (1, 1, 1)], np.float32)
    np.testing.assert_allclose(side.colors[:, 0], [0, 1])
    side.colors = [(0.5, 0, 0, 0), (0.75, 1, 1, 1)]
    np.testing.assert_allclose(side.colors[:, 0], [0.5, 0.75])
    side.colors = None
    assert side.kind() == "open"
    drawing.layers[0].curves[0].left = ["#036"]
    assert side.kind() == "stops"


def test_offsets_in_pieces_stay_in_pieces(drawing):
    side = drawing.layers[0].curves[0].right
    side.set_stops("color", [(0.25, 1, 0, 0), (0.75, 0, 0, 1)], "pieces")
    side.colors = side.colors * (1, 0.5, 0.5, 0.5)
    assert side.stops("color")[1] == "pieces"
    side.colors = ["red", "blue"]
    assert side.stops("color")[1] == "length"


def test_a_side_takes_all_that_another_bears(drawing):
    curves = drawing.layers[0].curves
    curves[0].right = curves[2].left
    for attribute in ("color", "opacity", "blur"):
        given, taken = curves[2].left.stops(attribute), curves[0].right.stops(attribute)
        assert given[:2] == taken[:2]
        np.testing.assert_array_equal(given[2], taken[2])


def test_arrays_of_a_drawing_cannot_be_written_to(drawing):
    curve = drawing.layers[0].curves[0]
    for array in (curve.points, curve.left.colors, curve.left.blur):
        assert not array.flags.writeable
        with pytest.raises(ValueError):
            array += 1
    curve.points = curve.points + (0, 1)
    np.testing.assert_allclose(curve.points[0], (5, 41))


def test_curves_are_a_sequence_and_stay_who_they_are(drawing):
    layer = drawing.layers[0]
    curves = layer.curves
    first, second, third = curves
    assert len(curves) == 3 and curves[-1] is third and curves[0:2] == [first, second]
    assert first in curves and [c.id for c in curves] == ["first", "", ""]
    added = layer.add(first.points, at=1)
    assert (second.index, added.index, third.index) == (2, 1, 3)
    second.remove()
    assert (added.index, third.index) == (1, 2) and list(layer.curves) == [first, added, third]
    for use in (lambda: second.points, lambda: second.index, second.remove):
        with pytest.raises(ValueError, match="removed"):
            use()
    assert "removed" in repr(second)
    third.left = "black"
    np.testing.assert_array_equal(layer.curves[2].left.colors, [(0, 0, 0, 0)])
    for index in (3, -4, 2**40):
        with pytest.raises(IndexError):
            layer.curves[index]
    with pytest.raises(IndexError):
        layer.add(first.points, at=4)


def test_a_curve_that_cannot_be_added_leaves_nothing(drawing):
    layer, before = drawing.layers[0], drawing.to_svg()
    good = [(0, 0), (1, 1), (2, 2), (3, 3)]
    for bad in (
        {"points": good[:3]},
        {"points": good, "left": "no colour"},
        {"points": good, "left": [(0.5, 2, 0, 0)]},
        {"points": good, "blur": -1},
        {"points": good, "blur": [(1, 2, 3)]},
        {"points": [(0, 0), (1, 1), (2, 2), (3, float("nan"))]},
    ):
        with pytest.raises(ValueError):
            layer.add(**bad)
    assert drawing.to_svg() == before


def test_weight_is_how_strongly_a_curve_counts(drawing):
    curve = drawing.layers[0].curves[0]
    assert curve.weight == 1
    curve.weight = 2.5
    assert curve.weight == 2.5
    for bad in (0, -1, float("nan")):
        with pytest.raises(ValueError):
            curve.weight = bad
    with pytest.raises((TypeError, ValueError)):
        curve.weight = "heavy"


def test_a_copy_is_another_drawing(drawing):
    for other in (drawing.copy(), copy.copy(drawing), copy.deepcopy(drawing)):
        other.layers[0].curves[0].remove()
        assert len(drawing.layers[0].curves) == 3 and len(other.layers[0].curves) == 2


def test_lint_tells_probable_mistakes(drawing):
    layer = drawing.layers[0]
    layer.add(layer.curves[0].points, left="red", right="blue")
    assert "duplicate" in {hint["kind"] for hint in drawing.lint()}
    assert len(drawing.lint(verbose=True)) >= len(drawing.lint())


def test_a_freed_drawing_raises(drawing):
    curve, side = drawing.layers[0].curves[0], drawing.layers[0].curves[0].left
    drawing.free()
    drawing.free()
    assert drawing.freed and repr(drawing) == "<Document, freed>"
    for use in (
        drawing.to_svg, drawing.copy, drawing.solve, drawing.lint, drawing.field,
        lambda: drawing.artboard, lambda: drawing.layers, lambda: curve.points, curve.remove,
        lambda: side.colors, lambda: setattr(side, "colors", "red"), drawing.__enter__,
    ):
        with pytest.raises(ValueError, match="freed"):
            use()


def test_handles_are_not_pickled(drawing):
    for handle in (drawing, drawing.field()):
        with pytest.raises(TypeError, match="pickled"):
            pickle.dumps(handle)


def test_a_drawing_goes_with_its_last_use(drawing):
    gone = []
    weakref.finalize(drawing._held(), gone.append, 1)
    curve = drawing.layers[0].curves[0]
    gc.disable()
    try:
        del drawing
        assert curve.id == "first"
    finally:
        gc.enable()


def test_reprs_say_what_it_is(drawing):
    layer = drawing.layers[0]
    assert repr(drawing) == "<Document 64 x 48: 3 curves in 1 layers>"
    assert repr(layer) == "<Layer 0 'layer': 3 curves>"
    assert repr(layer.curves[0]) == "<Curve 0 'first': 4 points>"
    assert repr(layer.curves[0].left) == "<Side left: stops, 3 colours>"
