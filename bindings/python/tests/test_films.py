"""Films: each frame continues with the mesh of the previous one."""

from __future__ import annotations

import gc

import numpy as np
import pytest

import sfumato

SIDE = 160
FRAMES = 12


def circle(x, y, r):
    """Returns 3 n + 1 control points of four pieces."""
    k = 0.5523 * r
    unit = [(r, 0), (r, k), (k, r), (0, r), (-k, r), (-r, k), (-r, 0), (-r, -k), (-k, -r), (0, -r), (k, -r),
            (r, -k), (r, 0)]
    return np.array(unit, float) + (x, y)


VARIED = {"left": "red", "right": "lime, #e6e619 30%, blue"}
STILL = ((24, 30, 10), (74, 74, 9))  # inside rings that no moving curve enters


@pytest.fixture
def scene():
    """Returns a disc that moves past two rings."""
    drawing = sfumato.Document.new(100, 100, background="white")
    layer = drawing.layers[0]
    layer.add(circle(50, 50, 46), left="blue", right="lime")
    layer.add(circle(24, 30, 13), **VARIED)
    layer.add(circle(74, 74, 14), blur=3, **VARIED)
    layer.add(circle(74, 74, 3), left="lime", right="red")
    disc = layer.add(circle(46, 18, 7), left="gold", right="navy", blur=2)
    return drawing, disc


def move_on(disc):
    disc.points = disc.points + (0.5, 4)


def still_pixels():
    at = (np.arange(SIDE) + 0.5) * 100 / SIDE
    x, y = np.meshgrid(at, at)
    return np.any([np.hypot(x - cx, y - cy) < r for cx, cy, r in STILL], axis=0)


def largest_difference(a, b):
    return int(np.abs(a.astype(int) - b.astype(int)).max())


def frame_layers(picture):
    return tuple(int(picture.statistics[f"{how}_layers"]) for how in ("kept", "continued", "begun"))


def test_where_nothing_moves_pixels_differ_by_a_code_value(scene):
    drawing, disc = scene
    picture = drawing.solve(coherent=True, max_error=1)
    assert frame_layers(picture) == (0, 0, 1)
    still = still_pixels()
    first = before = picture.render(SIDE)
    for _ in range(FRAMES):
        move_on(disc)
        assert picture.next(drawing) is picture
        assert frame_layers(picture) == (0, 1, 0)
        now = picture.render(SIDE)
        assert largest_difference(now[still], before[still]) <= 1
        assert largest_difference(now[still], first[still]) <= 1
        assert largest_difference(now, before) > 20
        before = now
    picture.next(drawing)
    assert frame_layers(picture) == (1, 0, 0)
    np.testing.assert_array_equal(picture.render(SIDE), before)
    exact = drawing.render(SIDE).astype(int)
    assert np.abs(before.astype(int) - exact).mean() < 0.25


def test_frames_may_be_drawings_of_their_own(scene, evening):
    drawing, disc = scene
    frames = []
    for _ in range(3):
        frames.append(drawing.copy())
        move_on(disc)
    picture = frames[0].solve(coherent=True)
    for frame in frames[1:]:
        assert frame_layers(picture.next(frame)) == (0, 1, 0)
    other = sfumato.open(evening)
    assert frame_layers(picture.next(other)) == (0, 0, len(other.layers))
    np.testing.assert_array_equal(
        picture.color_values().copy(), other.solve(coherent=True).color_values())


def test_what_fails_leaves_the_frame_before(scene):
    drawing, disc = scene
    picture = drawing.solve(coherent=True)
    before = picture.render(SIDE)
    move_on(disc)
    small = sfumato.Session(limits={"segments": 2})
    with pytest.raises(sfumato.LimitError):
        picture.next(sfumato.read(drawing.to_svg(), session=small))
    np.testing.assert_array_equal(picture.render(SIDE), before)
    session = sfumato.Session()
    session.cancel()
    frame = sfumato.read(drawing.to_svg())
    frame._given = session
    with pytest.raises(sfumato.Cancelled):
        picture.next(frame)
    np.testing.assert_array_equal(picture.render(SIDE), before)
    assert largest_difference(picture.next(drawing).render(SIDE), before) > 20


def test_what_is_no_film_is_an_error(scene):
    drawing, disc = scene
    alone, film = drawing.solve(), drawing.solve(coherent=True)
    with pytest.raises(sfumato.UsageError, match="coherent"):
        alone.next(drawing)
    with pytest.raises(sfumato.UsageError, match="read from a file"):
        sfumato.load_picture(film.to_bytes("sfp")).next(drawing)
    with pytest.raises(sfumato.UsageError, match="coherent"):
        drawing.solve(coherent=True, method="rays")
    with pytest.raises(sfumato.UsageError, match="coherent"):
        drawing.field(coherent=True)
    with pytest.raises(TypeError):
        film.next(drawing, scale=2)
    for wrong in (None, "drawing.svg", film, drawing.layers[0]):
        with pytest.raises(TypeError, match="Document"):
            film.next(wrong)
    assert film.next(drawing).render(SIDE).shape == (SIDE, SIDE, 3)


def test_freed_handles_and_arrays_are_errors(scene):
    drawing, disc = scene
    film, frame = drawing.solve(coherent=True), drawing.copy()
    values = film.color_values()
    with pytest.raises(BufferError):
        film.next(drawing)
    del values
    gc.collect()
    frame.free()
    with pytest.raises(ValueError, match="Document was freed"):
        film.next(frame)
    film.next(drawing)
    film.free()
    with pytest.raises(ValueError, match="Picture was freed"):
        film.next(drawing)
