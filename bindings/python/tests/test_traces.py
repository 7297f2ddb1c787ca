"""Tracing: drawings made from pictures."""

from __future__ import annotations

import numpy as np
import pytest

import sfumato


@pytest.fixture(scope="module")
def photo():
    y, x = np.mgrid[0:48, 0:64]
    image = np.empty((48, 64, 3), np.uint8)
    image[...] = (40, 60, 120)
    image[(x - 32) ** 2 + (y - 24) ** 2 < 200] = (230, 120, 30)
    return image


def error(drawing, photo):
    return np.abs(drawing.render(photo.shape[1]).astype(int) - photo[..., :3]).mean()


def test_a_trace_looks_like_its_picture(photo):
    drawing = sfumato.trace(photo, points=150)
    assert drawing.artboard == (0, 0, 64, 48)
    assert len(drawing.layers[0].curves) > 0
    assert error(drawing, photo) < 5


def test_pictures_of_any_kind_are_taken(photo):
    expected = sfumato.trace(photo, points=80, edges_only=True).to_svg()
    wide = np.zeros((60, 100, 3), np.uint8)
    wide[3:51, 7:71] = photo
    for image in (wide[3:51, 7:71], np.asfortranarray(photo), photo[::-1][::-1]):
        assert sfumato.trace(image, points=80, edges_only=True).to_svg() == expected
    for image in (photo[..., 0], photo.astype(np.uint16) * 257,
                  np.dstack([photo, np.full((48, 64), 255, np.uint8)])):
        assert len(sfumato.trace(image, points=80, edges_only=True).layers) > 0


def test_floats_from_0_to_1_are_taken(photo):
    exact = photo.astype(np.uint16) * 257
    expected = sfumato.trace(exact, points=80, edges_only=True).to_svg()
    for floats in (exact / 65535, (exact / 65535).astype(np.float32)):
        assert sfumato.trace(floats, points=80, edges_only=True).to_svg() == expected


def test_rounds_are_told_with_the_drawing_by_then(photo):
    told, kept, lent = [], [], []

    def hear(state, drawing):
        told.append(state)
        lent.append(drawing)
        kept.append(drawing.copy())
        assert drawing.render(16).shape == (12, 16, 3)

    drawing = sfumato.trace(photo, points=150, on_round=hear)
    assert [state.round for state in told] == sorted(state.round for state in told)
    assert told[-1].psnr_db > 20 and told[-1].curves > 0 and told[-1].seconds > 0
    assert kept[-1].artboard == drawing.artboard
    for gone in lent:
        with pytest.raises(ValueError, match="freed"):
            gone.to_svg()


def test_what_is_raised_in_a_round_ends_the_trace(photo):
    def stop(state, drawing):
        raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        sfumato.trace(photo, on_round=stop)
    session = sfumato.Session()
    with pytest.raises(sfumato.Cancelled):
        sfumato.trace(photo, on_round=lambda *_: session.cancel(), session=session)


def test_curves_take_the_colours_of_a_picture(photo):
    drawing = sfumato.trace(photo, points=150)
    for curve in drawing.layers[0].curves:
        curve.left = curve.right = "gray"
    grey = error(drawing, photo)
    assert error(drawing.fit_colors(photo), photo) < grey / 2
    with pytest.raises(sfumato.UsageError):
        drawing.fit_colors(photo, points=3)
    with pytest.raises(sfumato.InputError):
        sfumato.Document.new(64, 48).fit_colors(photo)
