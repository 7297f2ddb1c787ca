"""The solution as files of tables, read by common programs."""

from __future__ import annotations

import json
import struct

import numpy as np

import sfumato

TABLES = ("vertices", "triangles", "curve_edges", "color_nodes", "color_values", "opacity_nodes",
          "opacity_values")


def test_numpy_reads_an_npz(drawing, tmp_path):
    picture = drawing.solve()
    picture.save(tmp_path / "picture.npz")
    with np.load(tmp_path / "picture.npz", allow_pickle=False) as arrays:
        for name in TABLES:
            table = getattr(picture, name)()
            np.testing.assert_array_equal(arrays["layer0/" + name].reshape(table.shape), table)
        assert str(arrays["interpolation"]) == "srgb"
        assert arrays["viewport"].tolist() == list(drawing.artboard)
        assert arrays["instances"].shape[1] == 8
        assert arrays["blends"].tolist() == ["normal"] * len(arrays["instances"])
        nodes, place = arrays["layer0/color_nodes"], arrays["layer0/color_positions"]
        corners = arrays["layer0/vertices"][arrays["layer0/triangles"]]
        np.testing.assert_allclose(place[nodes[:, :3]], corners)
        np.testing.assert_allclose(place[nodes[:, 9]], corners.mean(axis=1))


def test_json_has_the_same_numbers(drawing):
    picture = drawing.solve()
    tables = json.loads(picture.to_bytes("json"))
    for name in TABLES:
        table = getattr(picture, name)()
        numbers = np.asarray(tables["layers"][0][name], table.dtype)
        np.testing.assert_array_equal(numbers.reshape(table.shape), table)
    assert [item["layer"] for item in tables["stack"]] == [0]


def test_a_ply_has_what_its_header_says(drawing):
    picture = drawing.solve()
    header, body = picture.to_bytes("ply").split(b"end_header\n", 1)
    counts = [int(line.split()[2]) for line in header.decode().splitlines() if "element" in line]
    assert counts[1] == 9 * len(picture.triangles())
    assert len(body) == 28 * counts[0] + 13 * counts[1]
    x, y = struct.unpack_from("<2f", body)
    assert np.isclose(picture.vertices(), (x, -y)).all(axis=1).any()
