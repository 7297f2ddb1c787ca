"""Lets scipy.optimize move a curve until its drawing looks like a picture.

    python optimize.py OUT.svg

Each step finds the colours by least squares, and the search covers only the geometry.
"""

from __future__ import annotations

import sys

import numpy as np
import sfumato
from scipy.optimize import minimize

SIDE = 64
STRAIGHT = np.array([(-8, 20), (20, 20), (44, 20), (72, 20)], float)
HIDDEN = np.array([(-8, 40), (20, 12), (44, 60), (72, 30)], float)


def drawing_of(points: np.ndarray) -> sfumato.Document:
    drawing = sfumato.Document.new(SIDE, SIDE)
    drawing.layers[0].add(points, left=["#fc6", "#d24"], right=["#137", "#4ad"], blur=4)
    return drawing


def main(out: str) -> None:
    grid = (np.arange(0, SIDE, 2) + 0.5).astype(float)
    places = np.stack(np.meshgrid(grid, grid), axis=-1).reshape(-1, 2)
    with drawing_of(HIDDEN) as hidden, hidden.field() as field:
        wanted = field.colors(places)[:, :3].astype(float)

    drawing = drawing_of(STRAIGHT)
    curve = drawing.layers[0].curves[0]

    def miss(heights: np.ndarray) -> float:
        curve.points = np.column_stack([STRAIGHT[:, 0], heights])
        with drawing.field() as field:
            weights = field.weights(places)
        matrix = weights.matrix.toarray()
        values = np.linalg.lstsq(matrix, wanted, rcond=None)[0]
        return float(np.sqrt(np.mean((matrix @ values - wanted) ** 2)) * 255)

    begin = miss(STRAIGHT[:, 1])
    found = minimize(
        miss, STRAIGHT[:, 1], method="Nelder-Mead",
        options={"maxfev": 400, "initial_simplex": STRAIGHT[:, 1] + 16 * np.eye(5, 4, -1)},
    )
    miss(found.x)
    drawing.save(out)
    away = float(np.abs(found.x - HIDDEN[:, 1]).max())
    print(f"error {begin:.2f} before, {found.fun:.2f} after; {away:.2f} from the hidden curve")


if __name__ == "__main__":
    main(*sys.argv[1:])
