"""Wrong shapes, types of numbers, options and indices raise Python's own kinds of errors."""

from __future__ import annotations

import io

import numpy as np
import pytest

import sfumato

POINTS = [(0, 0), (1, 1), (2, 2), (3, 3)]


@pytest.mark.parametrize(
    "points",
    [np.zeros(8), np.zeros((4, 3)), np.zeros((2, 2, 2)), 3.0, np.zeros((5, 2)), np.zeros((0, 2)), []],
)
def test_points_of_a_wrong_shape_are_value_errors(drawing, points):
    before = drawing.to_svg()
    with pytest.raises(ValueError):
        drawing.layers[0].curves[0].points = points
    with pytest.raises(ValueError):
        drawing.layers[0].add(points)
    assert drawing.to_svg() == before


@pytest.mark.parametrize(
    "points",
    [np.zeros((4, 2), complex), np.zeros((4, 2), bool), [("a", "b")] * 4, None, [{}] * 4, "points",
     np.zeros((4, 2), "datetime64[s]"), object()],
)
def test_points_of_other_kinds_are_type_errors(drawing, points):
    with pytest.raises(TypeError):
        drawing.layers[0].curves[0].points = points
    with pytest.raises(TypeError):
        drawing.field().colors(points)


@pytest.mark.parametrize("value", [float("nan"), float("inf"), 1e300])
def test_numbers_that_no_drawing_has_are_value_errors(drawing, value):
    curve = drawing.layers[0].curves[0]
    with pytest.raises(ValueError):
        curve.points = [(0, 0), (1, 1), (2, 2), (3, value)]
    with pytest.raises(ValueError):
        curve.left.colors = [(0, value, 0, 0)]
    with pytest.raises(ValueError):
        curve.left.blur = value
    with pytest.raises(ValueError):
        drawing.field().colors([(value, 3)])


@pytest.mark.parametrize(
    "colors",
    ["", "no colour", "red,,blue", "url(#g)", ["red", "none"], ["red, blue"], [], np.zeros((2, 5)),
     np.zeros((0, 4)), [(1, 2)], ["red", (1, 2)], np.zeros((1, 2, 3)), 'red"/><x a="'],
)
def test_what_is_no_colour_is_a_value_error(drawing, colors):
    before = drawing.to_svg()
    with pytest.raises(ValueError):
        drawing.layers[0].curves[0].left = colors
    assert drawing.to_svg() == before


@pytest.mark.parametrize("colors", [3j, [None], [["a"]], {1: 2}, [b"red"]])
def test_colours_of_other_kinds_are_errors(drawing, colors):
    with pytest.raises((TypeError, ValueError)):
        drawing.layers[0].curves[0].left = colors


@pytest.mark.parametrize("attribute, value", [
    ("opacity", 2), ("opacity", -0.1), ("opacity", "half"), ("opacity", []), ("opacity", [[1, 2, 3]]),
    ("blur", -1), ("blur", "none"), ("blur", np.zeros((2, 2, 2))),
])
def test_opacities_and_radii_out_of_range_are_value_errors(drawing, attribute, value):
    with pytest.raises(ValueError):
        setattr(drawing.layers[0].curves[0].left, attribute, value)


def test_words_that_are_none_are_usage_errors(drawing):
    side = drawing.layers[0].curves[0].left
    for use in (
        lambda: side.stops("colour"),
        lambda: side.set_stops("color", [(0, 1, 0, 0)], "inches"),
        lambda: sfumato.convert_colors((1, 1, 1), "srgb", "hsl"),
        lambda: sfumato.Document.new(10, 10, interpolation="hsl"),
        lambda: sfumato.Document.new(10, 10, background="nothing"),
        lambda: drawing.field().weights([(3, 3)], "blur"),
        lambda: drawing.solve().changes("colors"),
    ):
        with pytest.raises(sfumato.UsageError):
            use()


@pytest.mark.parametrize("size", [(0, 10), (-1, 10), (float("nan"), 1), (1e300, 1)])
def test_artboards_of_no_size_are_value_errors(size):
    with pytest.raises(ValueError):
        sfumato.Document.new(*size)


def test_options_are_named_where_they_are_wrong(drawing):
    with pytest.raises(sfumato.UsageError, match="max-eror.*max-error"):
        drawing.solve(max_eror=1)
    for bad in ({"width": 0}, {"viewport": (0, 0, 1)}, {"viewport": (0, 0, -1, 2)}, {"scale": "wide"},
                {"method": 'x" scale="2'}, {"scale": float("nan")}, {"title": "a"}):
        with pytest.raises(sfumato.UsageError):
            drawing.solve(**bad)
    with pytest.raises(sfumato.UsageError, match="unknown option"):
        drawing.solve(**{"scale=2 width": 3})
    for bad in (object(), b"x", [None], {"a": 1}, 1j):
        with pytest.raises(TypeError):
            drawing.solve(scale=bad)
    with pytest.raises(ValueError):
        drawing.solve(scale="1\0 width=3")
    assert drawing.solve(no_blur=True, max_error=None, scale=np.float32(2)).layer_count == 1


def test_titles_with_quotes_go_through(drawing):
    page = drawing.solve().to_bytes("html", title='a "b" \\ c').decode()
    assert "a &quot;b&quot; \\ c" in page or 'a "b" \\ c' in page


@pytest.mark.parametrize("layer", [-1, 1, 2**31, 2**40])
def test_layers_that_are_not_there_are_index_errors(drawing, layer):
    picture = drawing.solve()
    for use in (picture.vertices, picture.color_values, lambda i: picture.changes("vertices", i),
                drawing.field):
        with pytest.raises(IndexError):
            use(layer)


@pytest.mark.parametrize("out, error", [
    (np.zeros((4, 4, 3)), TypeError),
    (np.zeros((4, 4, 3), np.int8), TypeError),
    (np.zeros((4, 4, 3), ">u2"), TypeError),
    ([[1]], TypeError),
    (np.zeros((4, 4), np.uint8), ValueError),
    (np.zeros((4, 4, 2), np.uint8), ValueError),
    (np.zeros((0, 4, 3), np.uint8), ValueError),
    (np.zeros((4, 8, 3), np.uint8)[:, ::2], ValueError),
    (np.zeros((4, 4, 3), np.uint8)[::-1], ValueError),
    (np.zeros((4, 4, 3), np.uint8).transpose(1, 0, 2), ValueError),
    (np.broadcast_to(np.zeros((1, 4, 3), np.uint8), (4, 4, 3)), ValueError),
    (np.frombuffer(bytes(48), np.uint8).reshape(4, 4, 3), ValueError),
])
def test_arrays_that_cannot_be_drawn_into_are_refused(drawing, out, error):
    with pytest.raises(error):
        drawing.solve().render(out=out)


def test_sizes_that_no_picture_has_are_errors(drawing):
    picture = drawing.solve()
    for bad in ({"width": 0}, {"height": -1}, {"width": 2**31}, {"depth": 12},
                {"viewport": (0, 0, 0, 1)}, {"background": "no colour"}, {"window": (0, 0, 1)},
                {"window": (0, 0, 0, 4)}, {"window": (-1, 0, 4, 4)}):
        with pytest.raises(sfumato.UsageError):
            picture.render(**bad)
    for bad in ({"width": 2.5}, {"width": "wide"}, {"width": 3, "scale": 2}, {"window": (0, 0, 1.5, 4)},
                {"width": 3, "out": np.zeros((3, 3, 3), np.uint8)}):
        with pytest.raises(TypeError):
            picture.render(**bad)
    with pytest.raises((MemoryError, sfumato.Error)):
        picture.render(2**31 - 1, 2**31 - 1)
    with pytest.raises(ValueError):
        picture.render(alpha=True, out=np.zeros((3, 3, 3), np.uint8))


@pytest.mark.parametrize("image, error", [
    (np.full((8, 8), 2.0), ValueError), (np.full((8, 8, 3), -0.1), ValueError),
    (np.full((8, 8), np.nan), ValueError), (np.zeros((8, 8), bool), TypeError), (np.zeros(8), ValueError),
    (np.zeros((8, 8), np.int32), TypeError), (np.zeros(8, np.uint8), ValueError),
    (np.zeros((8, 8, 5), np.uint8), ValueError), (np.zeros((0, 8, 3), np.uint8), ValueError),
    ("photo.jpg", TypeError), (None, TypeError),
])
def test_pictures_that_are_none_are_refused(drawing, image, error):
    with pytest.raises(error):
        sfumato.trace(image)
    with pytest.raises(error):
        drawing.fit_colors(image)


@pytest.mark.parametrize("negligible", [-1, 2, float("nan")])
def test_what_is_negligible_is_a_share(drawing, negligible):
    with pytest.raises(sfumato.UsageError):
        drawing.field().weights([(3, 3)], negligible=negligible)


def test_formats_that_are_none_are_errors(drawing, tmp_path):
    picture = drawing.solve()
    for bad in ("", "bmp", "png\0", "é"):
        with pytest.raises(sfumato.UsageError):
            picture.to_bytes(bad)
    with pytest.raises(TypeError):
        picture.to_bytes(b"png")
    with pytest.raises(sfumato.UsageError):
        picture.save(tmp_path / "picture")
    with pytest.raises(ValueError, match="format"):
        picture.save(io.BytesIO())
    with pytest.raises(OSError):
        picture.save(tmp_path / "none" / "picture.png")
