#!/usr/bin/env python3
"""Draws examples/wood.png: two oiled planks, a texture that repeats without a seam.

    examples/make_wood.py examples/wood.png

The grain is a height between 0 and 1 for every pixel, made of noise that is periodic in x and y;
the picture is that height, looked up in a palette of wood colours. Standard library only.
"""

import math
import random
import sys

from texture import write_texture

WIDTH, HEIGHT = 512, 256
PLANKS = 2
# From the dark of a pore to the light of early wood.
PALETTE_STOPS = [(0.0, (58, 30, 17)), (0.22, (104, 59, 31)), (0.5, (158, 98, 54)),
                 (0.78, (193, 133, 80)), (1.0, (219, 168, 112))]
PALETTE_SIZE = 64


class PeriodicNoise:
    """Smooth noise in -1..1 on a lattice of columns x rows, repeating with the texture."""

    def __init__(self, columns, rows, seed):
        chance = random.Random(seed)
        self.columns, self.rows = columns, rows
        self.value = [[chance.uniform(-1, 1) for _ in range(columns)] for _ in range(rows)]

    def at(self, x, y):
        """x and y in textures: 1 is once around."""
        column, u = split(x * self.columns)
        row, v = split(y * self.rows)
        upper, lower = (self.value[(row + k) % self.rows] for k in (0, 1))
        left, right = column % self.columns, (column + 1) % self.columns
        return (upper[left] * (1 - u) + upper[right] * u) * (1 - v) + (
            lower[left] * (1 - u) + lower[right] * u) * v


def split(a):
    """The whole part of a, and its fraction eased at both ends."""
    whole = math.floor(a)
    t = a - whole
    return whole, t * t * (3 - 2 * t)


# Columns are few and rows many: wood is long in x.
BEND = PeriodicNoise(3, 4, 1)
WAVE = PeriodicNoise(7, 10, 2)
STREAK = PeriodicNoise(5, 90, 3)
FIBRE = PeriodicNoise(28, 256, 4)
PORE = PeriodicNoise(40, 200, 5)
CLOUD = PeriodicNoise(4, 6, 6)


def rings(x, y, plank):
    """Growth rings, cut lengthways: the dark late wood is narrow, the early wood wide."""
    warp = 2.4 * BEND.at(x, y) + 0.7 * WAVE.at(x, y)
    phase = (5.0 * y * PLANKS + warp + 3.7 * plank) % 1
    return phase ** 2.2 if phase < 0.86 else 0.717 * (1 - phase) / 0.14


def grain(x, y):
    """The height of the wood at (x, y), both in textures."""
    plank = int(y * PLANKS)
    along = x + 0.37 * plank  # the planks were sawn from different places
    height = 0.66 + (0.05 if plank else -0.04)
    height -= 0.30 * rings(along, y, plank)
    height += 0.12 * STREAK.at(along, y) + 0.10 * FIBRE.at(along, y) + 0.10 * CLOUD.at(along, y)
    height -= 0.22 * max(0, PORE.at(along, y) - 0.55) / 0.45
    return height - joint(y, plank)


def joint(y, plank):
    """The shadow between two planks."""
    across = (y * PLANKS - plank) * HEIGHT / PLANKS
    distance = min(across, HEIGHT / PLANKS - across)
    return 0.75 * math.exp(-(distance / 1.3) ** 2)


def main():
    write_texture(sys.argv[1], (WIDTH, HEIGHT), lambda x, y: grain(x / WIDTH, y / HEIGHT),
                  PALETTE_STOPS, PALETTE_SIZE)


if __name__ == '__main__':
    main()
