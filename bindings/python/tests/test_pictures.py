"""Pictures: pixels in place, tables as views, files, notebooks."""

from __future__ import annotations

import copy
import gc
import io
import pickle
import warnings

import numpy as np
import pytest

import sfumato


def test_pictures_and_drawings_are_saved_into_open_files(drawing, tmp_path):
    picture = drawing.solve()
    memory, text, coded = io.BytesIO(), io.StringIO(), io.BytesIO()
    picture.save(memory, format="png")
    assert memory.getvalue() == picture.to_bytes("png")
    with open(tmp_path / "named.jpg", "wb") as file:
        picture.save(file)
    assert (tmp_path / "named.jpg").read_bytes() == picture.to_bytes("jpg")
    picture.save(tmp_path / "other.dat", format="png")
    assert (tmp_path / "other.dat").read_bytes() == picture.to_bytes("png")
    drawing.save(text)
    drawing.save(coded)
    assert text.getvalue() == drawing.to_svg() == coded.getvalue().decode()


def test_pixels_have_the_size_and_kind_that_was_asked_for(drawing):
    picture = drawing.solve(width=128)
    assert picture.render().shape == (48, 64, 3)
    assert picture.render(128).shape == (96, 128, 3)
    assert picture.render(height=96).shape == (96, 128, 3)
    assert picture.render(10, 20).shape == (20, 10, 3)
    assert picture.render(scale=0.5).shape == (24, 32, 3)
    assert picture.render(viewport=(0, 0, 10, 20), scale=2).shape == (40, 20, 3)
    assert picture.render(depth=16).dtype == np.uint16
    image = picture.render(alpha=True, background="none")
    assert image.shape == (48, 64, 4) and image.dtype == np.uint8
    assert drawing.render(32).shape == (24, 32, 3)
    assert drawing.render(alpha=True, depth=16, scale=2).shape == (96, 128, 4)


def test_a_part_of_an_array_is_drawn_in_place(drawing):
    picture = drawing.solve(width=128)
    sheet = np.full((200, 300, 4), 7, np.uint8)
    part = sheet[50:146, 100:228]
    assert picture.render(out=part) is part
    np.testing.assert_array_equal(part, picture.render(128, alpha=True))
    assert (sheet[:50] == 7).all() and (sheet[:, 228:] == 7).all()


def test_a_window_has_the_pixels_of_the_whole_image(drawing):
    picture = drawing.solve(width=640)
    whole = picture.render(640, dither=True)
    x, y, width, height = window = (101, 77, 300, 123)
    expected = whole[y:y + height, x:x + width]
    np.testing.assert_array_equal(picture.render(640, dither=True, window=window), expected)
    sheet = np.zeros((200, 400, 3), np.uint8)
    part = sheet[20:143, 30:330]
    assert picture.render(scale=10, out=part, dither=True, window=window) is part
    np.testing.assert_array_equal(part, expected)
    assert (sheet[:20] == 0).all() and (sheet[143:] == 0).all()
    far = picture.render(16_000_000, window=(5_000_000, 4_000_000, 30, 20))
    assert far.shape == (20, 30, 3)


def test_png_files_have_the_pixels_that_are_drawn(drawing):
    image = pytest.importorskip("PIL.Image")
    picture = drawing.solve(width=128)
    data = picture.to_bytes("png", width=128, background="white", no_dither=True)
    shown = np.asarray(image.open(io.BytesIO(data)).convert("RGB"))
    np.testing.assert_array_equal(shown, picture.render(128, background="white"))


def test_a_drawing_is_solved_for_the_pixels_that_it_renders(drawing):
    with drawing.solve(width=80, pixel_grid=True) as picture:
        pixels = picture.render(80, dither=False)
        assert np.array_equal(drawing.render(80, dither=False), pixels)
        with pytest.raises(sfumato.InputError, match="pixel grid"):
            picture.to_bytes("pdf")
    with drawing.solve(width=80) as picture:
        assert np.abs(picture.render(80, dither=False).astype(int) - pixels).max() <= 8
        assert np.array_equal(drawing.render(80, depth=16), picture.render(80, depth=16))


def test_tables_are_views_that_keep_their_owner(drawing):
    picture = drawing.solve()
    tables = {
        "vertices": (picture.vertices(), np.float64, 2),
        "triangles": (picture.triangles(), np.uint32, 3),
        "edges": (picture.curve_edges(), np.uint8, 3),
        "nodes": (picture.color_nodes(), np.uint32, 10),
        "values": (picture.color_values(), np.float32, 3),
        "opacity nodes": (picture.opacity_nodes(), np.uint32, 10),
        "opacities": (picture.opacity_values(), np.float32, 1),
    }
    for table, kind, columns in tables.values():
        assert table.dtype == kind and table.shape[1] == columns and len(table) > 0
        assert not table.flags.owndata and not table.flags.writeable
    assert picture.vertices().ctypes.data == tables["vertices"][0].ctypes.data
    before = {name: table.copy() for name, (table, _, _) in tables.items()}
    picture.free()
    del picture
    gc.collect()
    others = [drawing.solve() for _ in range(4)]
    for name, (table, _, _) in tables.items():
        np.testing.assert_array_equal(table, before[name])
    part = tables["values"][0][3:, 1]
    del tables, others, table
    gc.collect()
    np.testing.assert_array_equal(part, before["values"][3:, 1])
    assert before["triangles"].max() == len(before["vertices"]) - 1
    assert before["nodes"].max() < len(before["values"])


def test_a_table_without_rows_is_an_empty_array():
    opaque = sfumato.Document.new(10, 10)
    opaque.layers[0].add([(0, 5), (3, 5), (6, 5), (10, 5)], left="red", right="blue")
    assert opaque.solve().opacity_values().shape[0] == 0


def test_solving_again_equals_solving(drawing):
    picture = drawing.solve(scale=2)
    drawing.layers[0].curves[0].left = ["#f00", "#00f"]
    assert drawing.solve(again=picture) is picture
    fresh = drawing.solve(scale=2)
    np.testing.assert_array_equal(picture.color_values(), fresh.color_values())
    np.testing.assert_array_equal(picture.render(256), fresh.render(256))
    assert picture.changes("color_values").tolist() == [[0, len(fresh.color_values())]]
    with pytest.raises(TypeError):
        drawing.solve(again=picture, scale=3)
    with pytest.raises(TypeError):
        drawing.solve(quick=True)


def test_quick_pictures_follow_a_curve(drawing):
    picture, curve = drawing.solve(drags=True), drawing.layers[0].curves[0]
    for step in range(3):
        curve.points = curve.points + (0, -1)
        drawing.solve(again=picture, quick=True)
    assert picture.statistics["curves"] >= 0
    exact = drawing.render(64).astype(int)
    assert np.abs(picture.render(64).astype(int) - exact).mean() < 3


def test_a_picture_that_arrays_look_at_is_not_solved_again(drawing):
    picture = drawing.solve()
    values = picture.color_values()
    drawing.layers[0].curves[0].left = "black"
    with pytest.raises(BufferError):
        drawing.solve(again=picture)
    part = values[2:4]
    del values
    with pytest.raises(BufferError):
        drawing.solve(again=picture)
    del part
    gc.collect()
    drawing.solve(again=picture)


@pytest.mark.parametrize("format, begin", [
    ("png", b"\x89PNG"), ("jpg", b"\xff\xd8"), ("webp", b"RIFF"), ("html", b"<!"), ("pdf", b"%PDF"),
    ("eps", b"%!PS"), ("svg", b"<"), ("glb", b"glTF"),
    ("npz", b"PK"), ("ply", b"ply\n"), ("json", b"{"),
])
def test_files_are_of_their_kind(drawing, tmp_path, format, begin):
    picture = drawing.solve(detail=2)
    if format == "eps":
        with pytest.warns(sfumato.DrawingWarning, match="EPS"):
            data = picture.to_bytes(format)
    else:
        data = picture.to_bytes(format)
    assert data.startswith(begin)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        picture.save(tmp_path / f"picture.{format}")
    assert (tmp_path / f"picture.{format}").read_bytes() == data


def test_notebooks_show_a_png_and_the_viewer_when_asked(drawing):
    picture = drawing.solve()
    for shown in (drawing, picture):
        assert shown._repr_png_().startswith(b"\x89PNG")
    frame = picture.interactive(height=300)
    html = frame._repr_html_()
    assert html.startswith('<iframe src="data:text/html;base64,') and "height:300px" in html


def test_a_picture_says_what_it_is(drawing):
    with drawing.solve(viewport=(1, 2, 30, 20)) as picture:
        assert picture.viewport == (1, 2, 30, 20)
        assert picture.layer_count == 1
        assert picture.statistics["triangles"] == len(picture.triangles())
        assert repr(picture).startswith("<Picture 30 x 20: 1 layers, ")
    for use in (picture.render, picture.vertices, lambda: picture.viewport, picture._repr_png_,
                lambda: drawing.solve(again=picture)):
        with pytest.raises(ValueError, match="freed"):
            use()


def test_any_drawing_solves_any_picture_again(drawing, evening):
    picture = drawing.solve()
    sfumato.open(evening).solve(again=picture)
    assert picture.viewport != (0, 0, 64, 48) or picture.layer_count >= 1


def test_a_picture_is_kept_in_a_file(drawing, tmp_path):
    picture = drawing.solve(scale=2)
    path = tmp_path / "picture.sfp"
    picture.save(path)
    data = path.read_bytes()
    assert data == picture.to_bytes("sfp") == picture.to_bytes("SFP")
    for again in (sfumato.load_picture(path), sfumato.load_picture(str(path)),
                  sfumato.load_picture(data), sfumato.load_picture(memoryview(bytearray(data))),
                  sfumato.load_picture(data, session=sfumato.Session(threads=1))):
        assert again.viewport == picture.viewport and again.layer_count == picture.layer_count
        np.testing.assert_array_equal(again.color_values(), picture.color_values())
        np.testing.assert_array_equal(again.render(128, alpha=True), picture.render(128, alpha=True))
        for format in ("png", "pdf", "svg", "glb"):
            assert again.to_bytes(format) == picture.to_bytes(format)
        # A page made from the other picture also holds the curves for exact pixels.
        assert len(again.to_bytes("html")) < len(picture.to_bytes("html"))
        assert again.to_bytes("sfp") == data
        assert again.statistics["triangles"] == len(picture.triangles())
        assert repr(again).startswith("<Picture 64 x 48: 1 layers, ")
    with pytest.raises(TypeError, match="options"):
        picture.to_bytes("sfp", width=9)


def test_a_picture_that_was_read_follows_no_drawing(drawing):
    again = sfumato.load_picture(drawing.solve().to_bytes("sfp"))
    for quick in (False, True):
        with pytest.raises(sfumato.UsageError, match="read from a file"):
            drawing.solve(again=again, quick=quick)
    assert again.render(32).shape == (24, 32, 3)


def test_pictures_are_pickled_and_copied(drawing):
    picture = drawing.solve()
    pixels = picture.render(64)
    others = [pickle.loads(pickle.dumps(picture)), copy.copy(picture), copy.deepcopy(picture)]
    picture.free()
    for other in others:
        np.testing.assert_array_equal(other.render(64), pixels)
    with pytest.raises(ValueError, match="freed"):
        pickle.dumps(picture)


def test_files_that_are_no_pictures_are_refused(drawing, tmp_path):
    data = drawing.solve().to_bytes("sfp")
    for wrong in (b"", b"<svg/>", data[:-1], data[:100] + bytes([data[100] ^ 1]) + data[101:]):
        with pytest.raises(sfumato.InputError):
            sfumato.load_picture(wrong)
    with pytest.raises(FileNotFoundError):
        sfumato.load_picture(tmp_path / "none.sfp")
    with pytest.raises(TypeError):
        sfumato.load_picture(None)
