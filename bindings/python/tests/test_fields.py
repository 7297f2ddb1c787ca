"""Exact colours at points, and the weights of the stops in them."""

from __future__ import annotations

import sys

import numpy as np
import pytest

import sfumato
from conftest import EXAMPLES


def points_of(drawing, side=20):
    x, y, width, height = drawing.artboard
    at = (np.arange(side) + 0.377) / side
    across, down = np.meshgrid(x + width * at, y + height * at)
    return np.column_stack([across.ravel(), down.ravel()])


def code_values(drawing, weights, values):
    mixed = weights.matrix @ values + weights.paint
    return np.clip(sfumato.convert_colors(mixed, drawing.interpolation, "srgb"), 0, 1)


def root_mean_square(difference):
    return float(np.sqrt(np.mean(np.square(difference))))


@pytest.mark.parametrize("name", ["evening.xml", "fish.svg", "flower.svg", "sunset.svg", "portrait.svg"])
def test_rows_times_stops_are_the_exact_colours(name):
    drawing = sfumato.open(EXAMPLES / name)
    field, points = drawing.field(), points_of(drawing)
    weights, colors = field.weights(points), field.colors(points)
    if not weights.paint.any():
        seen = np.diff(weights.matrix.indptr) > 0
        np.testing.assert_allclose(weights.matrix.sum(axis=1)[seen], 1, atol=1e-6)
    difference = code_values(drawing, weights, weights.values) - colors[:, :3]
    # The gather of fields sums distant parts in groups, with an error of a hundredth of a code
    # value.
    assert root_mean_square(difference[colors[:, 3] > 0]) < 4e-5


def test_weights_say_whose_stops_they_are(drawing):
    weights = drawing.field().weights(points_of(drawing))
    assert weights.stops.tolist() == [
        [0, 0, 0], [0, 0, 1], [0, 0, 2], [0, 1, 0], [1, 0, 0], [2, 0, 0]
    ]
    np.testing.assert_allclose(weights.values[1], (0, 0, 1))
    assert weights.matrix.shape == (400, 6) and weights.paint.shape == (400, 3)


def test_opacities_have_weights_too(drawing):
    field, points = drawing.field(), points_of(drawing)
    weights, colors = field.weights(points, "opacity"), field.colors(points)
    seen = colors[:, 3] > 0
    shown = (weights.matrix @ weights.values)[:, 0]
    np.testing.assert_allclose(shown[seen], colors[seen, 3], atol=2e-4)
    np.testing.assert_allclose(weights.values[:, 0], [0.5, 1])


def test_values_that_are_set_are_the_ones_that_are_seen(drawing):
    field, points = drawing.field(), points_of(drawing)
    weights = field.weights(points)
    values = np.random.default_rng(3).uniform(0, 1, weights.values.shape)
    field.set_values(drawing, weights.stops, values)
    colors = drawing.field().colors(points)
    difference = code_values(drawing, weights, values) - colors[:, :3]
    assert root_mean_square(difference[colors[:, 3] > 0]) < 4e-5
    np.testing.assert_allclose(drawing.layers[0].curves[0].left.colors[:, 0], [0, 0.25, 1])


def test_least_squares_find_the_colours_again():
    drawing = sfumato.open(EXAMPLES / "fish.svg")
    points = points_of(drawing, 60)
    field = drawing.field()
    weights = field.weights(points)
    well_seen = np.asarray(weights.matrix.sum(axis=0)).ravel() > 1
    wanted = weights.matrix @ weights.values
    found = np.linalg.lstsq(weights.matrix.toarray(), wanted, rcond=None)[0]
    np.testing.assert_allclose(found[well_seen], weights.values[well_seen], atol=1e-3)


def test_what_is_negligible_is_left_out(drawing):
    field = sfumato.open(EXAMPLES / "evening.xml").field()
    points = points_of(sfumato.open(EXAMPLES / "evening.xml"))
    all_of_them, some = field.weights(points), field.weights(points, negligible=1e-2)
    assert some.matrix.nnz < all_of_them.matrix.nnz
    np.testing.assert_allclose(np.asarray(some.matrix.sum(axis=1)).ravel(), 1, atol=1e-6)


def test_a_field_keeps_what_the_drawing_was(drawing):
    points = points_of(drawing)
    with drawing.field() as field:
        before = field.colors(points)
        drawing.layers[0].curves[0].remove()
        np.testing.assert_array_equal(field.colors(points), before)
        assert len(field.weights(points).stops) == 6
        drawing.free()
        assert len(field.weights(points, "opacity").stops) == 2
    for use in (lambda: field.colors(points), lambda: field.weights(points)):
        with pytest.raises(ValueError, match="freed"):
            use()


def test_colours_are_those_of_the_picture(drawing):
    centres = np.stack(np.meshgrid(np.arange(64) + 0.5, np.arange(48) + 0.5), axis=-1)
    colors = drawing.field().colors(centres.reshape(-1, 2)).reshape(48, 64, 4)
    image = drawing.solve().render(64, alpha=True, background="none")
    away = np.abs(255 * colors[..., :3] - image[..., :3]).max(axis=2)
    assert (away[image[..., 3] > 0] > 2).mean() < 0.1  # curves cut some pixels


def test_no_points_have_no_colours(drawing):
    field = drawing.field()
    assert field.colors([]).shape == (0, 4) and field.colors(np.zeros((0, 2))).shape == (0, 4)
    assert field.weights([]).matrix.shape == (0, 6)
    with pytest.raises(sfumato.InputError):
        field.colors([(1e6, 0)])
    with pytest.raises(sfumato.InputError):
        field.weights([(0, -1e6)])


def test_strided_and_small_numbers_are_taken(drawing):
    field, points = drawing.field(), points_of(drawing)
    whole = field.colors(points)
    np.testing.assert_array_equal(field.colors(np.repeat(points, 2, axis=0)[::2]), whole)
    np.testing.assert_array_equal(field.colors(np.asfortranarray(points)), whole)
    assert field.colors(points.astype(np.float32)).shape == whole.shape
    assert field.colors(np.array([(3, 4)], np.int16)).shape == (1, 4)


def test_without_scipy_weights_are_an_import_error(drawing, monkeypatch):
    monkeypatch.setitem(sys.modules, "scipy.sparse", None)
    with pytest.raises(ImportError):
        drawing.field().weights([(3, 3)])


def test_values_and_stops_go_together(drawing):
    field = drawing.field()
    with pytest.raises(ValueError):
        field.set_values(drawing, [(0, 0, 0)], [(0, 0, 0), (1, 1, 1)])
    with pytest.raises(IndexError):
        field.set_values(drawing, [(9, 0, 0)], [(0, 0, 0)])
    with pytest.raises(IndexError):
        field.set_values(drawing, [(0, 0, 9)], [(0, 0, 0)])


def test_colours_are_converted_there_and_back():
    colors = np.random.default_rng(1).uniform(0, 1, (50, 3))
    for space in ("srgb", "linear", "oklab"):
        there = sfumato.convert_colors(colors, "srgb", space)
        np.testing.assert_allclose(sfumato.convert_colors(there, space, "srgb"), colors, atol=1e-5)
    np.testing.assert_allclose(sfumato.convert_colors((1, 1, 1), "srgb", "oklab"), (1, 0, 0), atol=1e-6)
    assert not np.isfinite(sfumato.convert_colors([(np.nan, 1, 1)], "srgb", "oklab")).all()
    for bad in (np.zeros((2, 4)), 3.0):
        with pytest.raises(ValueError):
            sfumato.convert_colors(bad, "srgb", "linear")
