"""A fully typed program that scripts/check-python checks with mypy."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import sfumato


def edit(drawing: sfumato.Document) -> NDArray[np.float64]:
    layer: sfumato.Layer = drawing.layers[0]
    curve = layer.add([(0, 0), (1, 1), (2, 2), (3, 3)], left="red", right=[(1, 0, 0), (0, 1, 0)], blur=2)
    curve.left = ["#f00", "#00f"]
    curve.right = None
    curve.left = curve.right
    curve.left.colors = np.array([(0, 1, 0, 0)])
    curve.blur = 3
    curve.opacity = [0.5, 1]
    curve.right.blur = [(0, 1), (1, 2)]
    curve.points = curve.points + 1
    rows: NDArray[np.float64] = curve.left.colors
    return rows


def look(drawing: sfumato.Document) -> None:
    session = sfumato.Session(threads=2, progress=lambda stage, done: print(stage, done))
    with drawing.solve(max_error=1, viewport=(0, 0, 9, 9)) as picture:
        image = picture.render(100, alpha=True, background="none")
        vertices: NDArray[np.float64] = picture.vertices()
        picture.save("picture.png", dither=True)
        picture.save("picture.sfp")
    kept: sfumato.Picture = sfumato.load_picture("picture.sfp", session=session)
    kept = sfumato.load_picture(kept.to_bytes("sfp"))
    frame: sfumato.Picture = drawing.solve(coherent=True).next(drawing)
    weights = drawing.field().weights(vertices)
    values: NDArray[np.float64] = weights.values
    found: list[sfumato.Curve] = drawing.layers[0].curves[1:3]
    one: sfumato.Curve = drawing.layers[0].curves[0]
    traced = sfumato.trace(image, session=session, on_round=lambda state, by_then: by_then.copy())
    print(values, found, one, traced, frame.statistics["kept_layers"])
