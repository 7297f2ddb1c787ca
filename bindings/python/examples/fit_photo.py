"""Fits the colours of a drawing to a photo, by least squares over the weights of its stops.

    python fit_photo.py PHOTO OUT.svg

The script traces the photo for the curves and discards the colours of the trace. It needs scipy and
Pillow.
"""

from __future__ import annotations

import sys

import numpy as np
import sfumato
from PIL import Image
from scipy.sparse import identity, vstack
from scipy.sparse.linalg import lsqr

STRENGTH = 0.03  # of the pull towards the former colours; it determines stops that no sample point sees
POINTS = 20_000


def centres(width: int, height: int) -> np.ndarray:
    """Returns a grid of pixel centres, row by row."""
    step = max(1, round((width * height / POINTS) ** 0.5))
    x, y = np.meshgrid(np.arange(0, width, step) + 0.5, np.arange(0, height, step) + 0.5)
    return np.column_stack([x.ravel(), y.ravel()])


def fit(drawing: sfumato.Document, photo: np.ndarray) -> float:
    """Gives the stops of the first layer the best colours. Returns the error, 0 to 255 (RMS)."""
    height, width = photo.shape[:2]
    points = centres(width, height)
    with drawing.field(layer=0) as field:
        weights = field.weights(points)
        pixels = photo[points[:, 1].astype(int), points[:, 0].astype(int), :3] / 255
        wanted = sfumato.convert_colors(pixels, "srgb", drawing.interpolation) - weights.paint
        matrix = vstack([weights.matrix, STRENGTH * identity(len(weights.stops))]).tocsr()
        known = np.vstack([wanted, STRENGTH * weights.values])
        values = np.column_stack([lsqr(matrix, known[:, c])[0] for c in range(3)])
        field.set_values(drawing, weights.stops, values)
    shown = drawing.render(width=width).astype(float)
    return float(np.sqrt(np.mean((shown - photo[:, :, :3]) ** 2)))


def main(path: str, out: str) -> None:
    image = Image.open(path).convert("RGB")
    image.thumbnail((480, 480))
    photo = np.asarray(image)
    drawing = sfumato.trace(photo, points=6000, edges_only=True)
    for curve in drawing.layers[0].curves:
        for side in (curve.left, curve.right):
            rows = side.colors.copy()
            rows[:, 1:] = 0.5
            if len(rows):
                side.colors = rows
    grey = drawing.render(width=photo.shape[1]).astype(float)
    before = float(np.sqrt(np.mean((grey - photo) ** 2)))
    after = fit(drawing, photo)
    drawing.save(out)
    print(f"error {before:.1f} before, {after:.1f} after")


if __name__ == "__main__":
    main(*sys.argv[1:])
